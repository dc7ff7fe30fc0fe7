"""The base of the methods whose descriptor is the pooled last map of a network."""

from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.backbones.architectures import Backbone
from vpr_baselines.backbones.pooling import POOLINGS, Pooling
from vpr_baselines.backbones.trunk import Normalise, Trunk, load_trunk
from vpr_baselines.centred import Centred
from vpr_bench.types.traverse import Traverse
from vpr_bench.weights.choice import choose_weights


@dataclass
class Pooled(Centred):
    """Describe an image by the pooled last feature map of a frozen network; a subclass says which.

    Parameters
    ----------
    pooling : {"gem", "average", "grid1x3", "grid2x3"}
        How the map becomes a vector: C numbers, three or six times as many for the grids.
    weights : str
        ``imagenet``, ``places365`` where there are such, the path of a checkpoint, or ``random``.
    width, height : int
        Input size in pixels.
    normalise : {"grey+clahe", "none"}
        Grey and locally equalised, or colours as they are.
    centre : bool
        Subtract the references' mean.
    seed : int
        Of random weights.
    """

    backbone: ClassVar[Backbone]

    pooling: Pooling = "grid1x3"
    weights: str = "imagenet"
    width: Annotated[int, Field(ge=32)] = 416
    height: Annotated[int, Field(ge=32)] = 256
    normalise: Normalise = "grey+clahe"
    centre: bool = True
    seed: Annotated[int, Field(ge=0)] = 0

    def weights_digest(self) -> str:
        """Name the weights by training set and SHA-256; it raises what :func:`choose_weights` raises."""
        return choose_weights(self.backbone, self.weights, self.seed).identity()

    def fit(self, references: Traverse) -> None:
        """Describe every reference; the weights are loaded before the first image is."""
        self._trunk  # noqa: B018
        super().fit(references)

    def respond(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into a (D,) float32 descriptor, not centred."""
        pooled = POOLINGS[self.pooling](self._trunk.encode([image]))
        return np.asarray(pooled[0])

    @property
    def _trunk(self) -> Trunk:
        return load_trunk(self.backbone, self.width, self.height, self.weights, self.normalise, seed=self.seed)
