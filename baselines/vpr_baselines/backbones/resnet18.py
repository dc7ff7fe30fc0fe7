"""ResNet-18, whole or cut short.

Architecture: He, Zhang, Ren and Sun, "Deep Residual Learning for Image Recognition", CVPR 2016, table 1 and
figure 3. State-dict keys and shapes are torchvision's, so that its checkpoints and those of Places365 load.
Checked without torchvision: key by key against its published names and shapes, by its published parameter count
(11,689,512), by the counts of the cut networks that the thesis prints, and by forward passes that agree with a second
implementation written from the paper in functions alone (see the tests).
"""

from collections.abc import Iterator
from typing import cast

from torch import Tensor, nn
from torch.nn import functional

from vpr_baselines.backbones.layers import Layer, respond

_CHANNELS = (64, 128, 256, 512)  # of the four stages; the first keeps the size, each other one halves it
_STEM = 64


class ResNet18(nn.Module):
    """The classifier.

    Parameters
    ----------
    classes : int
        Outputs of the last layer.
    stages : int
        How many of the four stages are kept. The thesis calls what is left with 3, 2, 1 and 0 of them and no pool 15,
        10, 5 and 1 layers.
    pool : bool
        Whether the last map is averaged before it is classified. Otherwise every number of it is an input of the last
        layer, which then depends on the size of the image.
    size : (int, int)
        Height and width of the images, in pixels; only used without ``pool``.

    Raises
    ------
    ValueError
        If there are not so many stages.
    """

    def __init__(
        self, classes: int = 1000, *, stages: int = 4, pool: bool = True, size: tuple[int, int] = (227, 227)
    ) -> None:
        super().__init__()
        if not 0 <= stages <= len(_CHANNELS):
            raise ValueError(f"stages must lie in [0, {len(_CHANNELS)}]. Got {stages} instead.")
        self.stages, self.pool = stages, pool
        self.conv1 = nn.Conv2d(3, _STEM, 7, stride=2, padding=3, bias=False)
        self.bn1 = nn.BatchNorm2d(_STEM)
        channels = _STEM
        for number, width in enumerate(_CHANNELS[:stages], 1):
            stride = 1 if number == 1 else 2
            stage = nn.Sequential(_BasicBlock(channels, width, stride), _BasicBlock(width, width))
            self.add_module(f"layer{number}", stage)
            channels = width
        cells = 1 if pool else _cells(size[0], stages) * _cells(size[1], stages)
        self.fc = nn.Linear(channels * cells, classes)

    def layers(self) -> Iterator[Layer]:
        """Yield ``conv1``, with its pool, and ``layer1`` to ``layer4``.

        The first takes (B, 3, H, W) float32 RGB in [0, 1], normalised with ``MEAN`` and ``STD``; the last makes
        (B, 512, ceil(H / 32), ceil(W / 32)), each one before has twice the height and width and half the channels,
        64 at least. None is negative.
        """
        yield "conv1", self._stem
        for number in range(1, self.stages + 1):
            yield f"layer{number}", self.get_submodule(f"layer{number}")

    def forward(self, images: Tensor) -> Tensor:
        """Classify (B, 3, H, W) images: (B, classes) logits."""
        (x,) = respond(self, images, (f"layer{self.stages}" if self.stages else "conv1",))
        return cast(Tensor, self.fc(x.mean(dim=(2, 3)) if self.pool else x.flatten(1)))

    def _stem(self, images: Tensor) -> Tensor:
        return functional.max_pool2d(
            functional.relu(self.bn1(self.conv1(images)), inplace=True), 3, stride=2, padding=1
        )


MEAN, STD = (0.485, 0.456, 0.406), (0.229, 0.224, 0.225)
"""Normalisation of RGB in [0, 1], with which both ImageNet's and Places365's weights were trained."""


def _cells(side: int, stages: int) -> int:
    """Return the side of the last map: convolution and pool of the stem and all stages but the first halve it."""
    for _ in range(max(stages, 1) + 1):
        side = -(-side // 2)
    return side


class _BasicBlock(nn.Module):
    """Two 3 × 3 convolutions added to their input, which is projected where the shapes differ."""

    def __init__(self, inputs: int, outputs: int, stride: int = 1) -> None:
        super().__init__()
        self.conv1 = nn.Conv2d(inputs, outputs, 3, stride, padding=1, bias=False)
        self.bn1 = nn.BatchNorm2d(outputs)
        self.conv2 = nn.Conv2d(outputs, outputs, 3, padding=1, bias=False)
        self.bn2 = nn.BatchNorm2d(outputs)
        self.downsample: nn.Module = nn.Identity()
        if stride != 1 or inputs != outputs:
            self.downsample = nn.Sequential(nn.Conv2d(inputs, outputs, 1, stride, bias=False), nn.BatchNorm2d(outputs))

    def forward(self, x: Tensor) -> Tensor:
        # In place, as nobody else holds these maps: one more would push others out of the cache.
        y = functional.relu(self.bn1(self.conv1(x)), inplace=True)
        y = self.bn2(self.conv2(y))
        return functional.relu(y.add_(self.downsample(x)), inplace=True)
