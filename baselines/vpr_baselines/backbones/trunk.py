"""A frozen network that encodes images of any size: resized, their light normalised, scaled as it was trained."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Literal, cast

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from vpr_baselines.backbones.architectures import ARCHITECTURES, Architecture, Backbone, Channels, load_network
from vpr_baselines.backbones.layers import Layered, respond
from vpr_baselines.photometry import grey, locally_equalised, resized

Normalise = Literal["grey+clahe", "none"]
"""What is done to the light of an image: grey and locally equalised (CLAHE), so that day and night look more alike,
or nothing."""


@dataclass(frozen=True)
class Trunk:
    """A network and what is done to images before it sees them.

    Parameters
    ----------
    network : nn.Module
        In evaluation mode, batch norms folded.
    width, height : int
        What images are resized to, in pixels.
    mean, std : three floats
        What the channels in [0, 1] are normalised with.
    normalise : {"grey+clahe", "none"}
        What is done to the light.
    layers : tuple of str
        Whose responses are wanted.
    """

    network: nn.Module
    width: int
    height: int
    mean: Channels
    std: Channels
    normalise: Normalise
    layers: tuple[str, ...]

    def respond(self, image: NDArray[np.uint8]) -> list[NDArray[np.float32]]:
        """Compute the responses of the layers to one (H, W, 3) uint8 RGB image of any size.

        Returns
        -------
        list of (1, …) float32
            Of a convolution the feature map, (1, C, h, w).
        """
        with torch.inference_mode():
            return [one.numpy() for one in respond(cast(Layered, self.network), self.input(image), self.layers)]

    def encode(self, images: Sequence[NDArray[np.uint8]]) -> NDArray[np.float32]:
        """Compute the response of the only layer to (H, W, 3) uint8 RGB images of any size.

        Images go through one by one: on a CPU a batch is no faster, its large intermediate results make it
        slower, and an image's features do not depend on its neighbours.

        Returns
        -------
        (B, …) float32
        """
        return np.concatenate([response for image in images for response in self.respond(image)])

    def input(self, image: NDArray[np.uint8]) -> Tensor:
        """Turn an image into what the network takes: (1, 3, height, width) float32."""
        mean, std = self._scale
        channels = (torch.from_numpy(self._prepare(image)).float().div_(255) - mean) / std
        return channels.permute(2, 0, 1)[None].contiguous(memory_format=torch.channels_last)

    def _prepare(self, image: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Resize and normalise the light: (height, width, 1 or 3) uint8."""
        if self.normalise == "none":
            return resized(image, self.width, self.height)
        return locally_equalised(resized(grey(image), self.width, self.height))[..., None]

    @cached_property
    def _scale(self) -> tuple[Tensor, Tensor]:
        return torch.tensor(self.mean), torch.tensor(self.std)


@cache
def load_trunk(
    backbone: Backbone | Architecture,
    width: int,
    height: int,
    weights: str = "imagenet",
    normalise: Normalise = "grey+clahe",
    layers: tuple[str, ...] = (),
    seed: int = 0,
) -> Trunk:
    """Load a network with its weights; the same trunk is shared by all that ask for it.

    Parameters
    ----------
    backbone : Backbone or Architecture
        The network.
    width, height, normalise
        As for :class:`Trunk`.
    layers : tuple of str
        Whose responses are wanted; by default the last map's.
    weights : str
        A training set, a path, or ``random``: see :func:`vpr_bench.weights.choice.choose_weights`.
    seed : int
        Of random weights.

    Raises
    ------
    UsageError
        If ``weights`` means nothing.
    DataError
        If the weights are missing, damaged, or of another network.
    """
    one = ARCHITECTURES[backbone] if isinstance(backbone, str) else backbone
    return Trunk(load_network(one, weights, seed), width, height, one.mean, one.std, normalise, layers or (one.last,))
