"""ResNet-18's last map as a global descriptor."""

from dataclasses import dataclass
from typing import Annotated, ClassVar

from pydantic import Field

from vpr_baselines.backbones.architectures import Backbone
from vpr_baselines.backbones.pooling import Pooling
from vpr_baselines.backbones.trunk import Normalise
from vpr_baselines.pooled import Pooled


@dataclass
class ResNet18(Pooled):
    """ResNet-18's last feature map, pooled and centred; `vpr-bench weights fetch resnet18-imagenet` first.

    The defaults are those of EfficientNet-Lite0.

    Parameters
    ----------
    pooling : {"gem", "average", "grid1x3", "grid2x3"}
        How the map becomes a vector: 512 numbers, three or six times as many for the grids.
    weights : str
        ``imagenet``, ``places365``, the path of a checkpoint, or ``random``.
    width, height : int
        Input size in pixels.
    normalise : {"grey+clahe", "none"}
        Grey and locally equalised, or colours as they are.
    centre : bool
        Subtract the references' mean.
    seed : int
        Of random weights.
    """

    version: ClassVar[str] = "1"
    backbone: ClassVar[Backbone] = "resnet18"

    pooling: Pooling = "grid1x3"
    weights: str = "imagenet"
    width: Annotated[int, Field(ge=32)] = 416
    height: Annotated[int, Field(ge=32)] = 256
    normalise: Normalise = "grey+clahe"
    centre: bool = True
    seed: Annotated[int, Field(ge=0)] = 0
