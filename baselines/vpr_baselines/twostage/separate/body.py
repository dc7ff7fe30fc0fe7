"""A network up to its last layer."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import cast

import numpy as np
from numpy.typing import NDArray
from torch import Tensor, nn

from vpr_baselines.backbones.architectures import ARCHITECTURES, WHOLE_ALEXNET, Backbone
from vpr_baselines.backbones.layers import Layered, respond
from vpr_baselines.backbones.pooling import average
from vpr_baselines.backbones.trunk import Normalise, Trunk, load_trunk

SIDE = 227
"""Width and height of the thesis's input, in pixels."""


@dataclass(frozen=True)
class Body:
    """What a new last layer stands on.

    Attributes
    ----------
    trunk : Trunk
        The network, whose response is the last map, which is averaged, or a vector.
    """

    trunk: Trunk

    def respond(self, images: Sequence[NDArray[np.uint8]]) -> NDArray[np.float32]:
        """Pass (H, W, 3) uint8 RGB images of any size through the network, one by one: (B, D) float32."""
        responses = self.trunk.encode(images)
        return average(responses) if responses.ndim == 4 else responses

    def response(self, inputs: Tensor) -> Tensor:
        """Do the same to (B, 3, height, width) inputs that :meth:`Trunk.input` made, with gradients: (B, D)."""
        (response,) = respond(cast(Layered, self.trunk.network), inputs, self.trunk.layers)
        return response.mean(dim=(2, 3)) if response.ndim == 4 else response

    def on(self, network: nn.Module) -> "Body":
        """Return the same with another network of the same architecture."""
        return replace(self, trunk=replace(self.trunk, network=network))


def load_body(
    backbone: Backbone = "resnet18",
    weights: str = "places365",
    width: int = SIDE,
    height: int = SIDE,
    normalise: Normalise = "none",
    seed: int = 0,
) -> Body:
    """Load a network without its last layer; by default the thesis's, with its input.

    AlexNet keeps its fully connected layers but the last, the others end with their average pool.

    Parameters
    ----------
    backbone, weights, width, height, normalise, seed
        As for :func:`~vpr_baselines.backbones.trunk.load_trunk`.

    Raises
    ------
    UsageError
        If ``weights`` means nothing.
    DataError
        If the weights are missing, damaged, or of another network.
    """
    architecture = WHOLE_ALEXNET if backbone == "alexnet" else ARCHITECTURES[backbone]
    return Body(load_trunk(architecture, width, height, weights, normalise, seed=seed))
