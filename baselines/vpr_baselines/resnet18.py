"""ResNet-18's last map as a global descriptor."""

from dataclasses import dataclass
from typing import ClassVar

from vpr_baselines.backbones.architectures import Backbone
from vpr_baselines.pooled import Pooled


@dataclass
class ResNet18(Pooled):
    """ResNet-18's last feature map, pooled and centred; `vpr-bench weights fetch resnet18-imagenet` first.

    The defaults are those of EfficientNet-Lite0.

    Its parameters are those of :class:`~vpr_baselines.pooled.Pooled`.
    """

    version: ClassVar[str] = "1"
    backbone: ClassVar[Backbone] = "resnet18"
