"""AlexNet's responses as global descriptors, the first of the learned ones."""

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.backbones.architectures import ARCHITECTURES, WHOLE_ALEXNET
from vpr_baselines.backbones.trunk import Normalise, Trunk, load_trunk
from vpr_baselines.centred import Centred
from vpr_baselines.projection import gaussian_projection
from vpr_bench.types.traverse import Traverse
from vpr_bench.weights.choice import choose_weights


@dataclass
class AlexNet(Centred):
    """AlexNet's conv3 or fc7 response; `vpr-bench weights fetch alexnet-imagenet` first.

    The defaults are those of Sünderhauf et al., "On the Performance of ConvNet Features for Place Recognition",
    IROS 2015, and of the thesis (ch. 2): colours as they are, all of conv3, nothing subtracted.

    Parameters
    ----------
    layer : {"conv3", "fc7"}
        The response after its ReLU: 13 × 13 × 384 = 64,896 numbers of conv3 at the default size, or 4096 of fc7.
    dimensions : int, optional
        Project the response onto so many random directions (4096, say); by default it stays as it is.
    weights : str
        ``imagenet``, ``places365``, the path of a checkpoint, or ``random``.
    width, height : int
        Input size in pixels.
    normalise : {"grey+clahe", "none"}
        Grey and locally equalised, or colours as they are.
    centre : bool
        Subtract the references' mean.
    seed : int
        Of the projection and of random weights.
    """

    version: ClassVar[str] = "1"

    layer: Literal["conv3", "fc7"] = "conv3"
    dimensions: Annotated[int, Field(ge=1)] | None = None
    weights: str = "imagenet"
    width: Annotated[int, Field(ge=63)] = 227
    height: Annotated[int, Field(ge=63)] = 227
    normalise: Normalise = "none"
    centre: bool = False
    seed: Annotated[int, Field(ge=0)] = 0

    def weights_digest(self) -> str:
        """Name the weights by training set and SHA-256; it raises what :func:`choose_weights` raises."""
        return choose_weights("alexnet", self.weights, self.seed).identity()

    def fit(self, references: Traverse) -> None:
        """Describe every reference; the weights are loaded before the first image is."""
        self._trunk  # noqa: B018
        super().fit(references)

    def respond(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into a (D,) float32 response, not centred."""
        response = self._trunk.encode([image]).ravel()
        if self.dimensions is None:
            return response
        return gaussian_projection(len(response), self.dimensions, self.seed) @ response

    @property
    def _trunk(self) -> Trunk:
        network = ARCHITECTURES["alexnet"] if self.layer == "conv3" else WHOLE_ALEXNET
        return load_trunk(network, self.width, self.height, self.weights, self.normalise, (self.layer,), self.seed)
