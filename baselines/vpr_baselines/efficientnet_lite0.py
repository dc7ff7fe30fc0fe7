"""EfficientNet-Lite0's last map as a global descriptor: its weights come with the installation."""

from dataclasses import dataclass
from typing import Annotated, ClassVar

from pydantic import Field

from vpr_baselines.backbones.architectures import Backbone
from vpr_baselines.backbones.pooling import Pooling
from vpr_baselines.backbones.trunk import Normalise
from vpr_baselines.pooled import Pooled


@dataclass
class EfficientNetLite0(Pooled):
    """EfficientNet-Lite0's last feature map, pooled and centred.

    The defaults were chosen on the real day_left-day_right and on simulated walks, never on real night: grey,
    locally equalised images beat colour by far once light changes; 416 × 256 beats smaller inputs everywhere, and
    512 × 288 does not beat it; generalised mean and average are alike by day, and the first is better by simulated
    night; the grid is better by night still and worse where the viewpoint changes. Centring makes no difference there.

    Parameters
    ----------
    pooling : {"gem", "average", "grid2x3"}
        How the map becomes a vector: 1280 numbers, 7680 for the grid.
    weights : str
        ``imagenet``, the path of a checkpoint, or ``random``.
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
    backbone: ClassVar[Backbone] = "efficientnet-lite0"

    pooling: Pooling = "gem"
    weights: str = "imagenet"
    width: Annotated[int, Field(ge=32)] = 416
    height: Annotated[int, Field(ge=32)] = 256
    normalise: Normalise = "grey+clahe"
    centre: bool = True
    seed: Annotated[int, Field(ge=0)] = 0
