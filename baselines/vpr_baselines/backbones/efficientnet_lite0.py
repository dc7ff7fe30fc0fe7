"""EfficientNet-Lite0: the small trunk whose ImageNet weights come with a Python package.

Architecture: Tan and Le, "EfficientNet: Rethinking Model Scaling for Convolutional Neural Networks", ICML 2019,
table 1, in its Lite variant: no squeeze-and-excitation, ReLU6, stem and head not scaled. The state-dict keys are
those of the published checkpoint (4,652,008 parameters).
"""

from collections.abc import Iterator
from typing import cast

from torch import Tensor, nn
from torch.nn import functional

from vpr_baselines.backbones.layers import Layer, respond

# (repeats, kernel, stride, expansion, output channels) of each stage; table 1 of the paper
_STAGES = (
    (1, 3, 1, 1, 16),
    (2, 3, 2, 6, 24),
    (2, 5, 2, 6, 40),
    (3, 3, 2, 6, 80),
    (3, 5, 1, 6, 112),
    (4, 5, 2, 6, 192),
    (1, 3, 1, 6, 320),
)
_STEM, _HEAD = 32, 1280
_EPSILON = 1e-3  # batch norm of the TensorFlow original


class EfficientNetLite0(nn.Module):
    """The whole classifier."""

    def __init__(self, classes: int = 1000) -> None:
        super().__init__()
        self._conv_stem = _SameConv2d(3, _STEM, 3, stride=2)
        self._bn0 = nn.BatchNorm2d(_STEM, eps=_EPSILON)
        blocks, channels = [], _STEM
        for repeats, kernel, stride, expansion, output in _STAGES:
            for repeat in range(repeats):
                blocks.append(_Block(channels, output, kernel, stride if repeat == 0 else 1, expansion))
                channels = output
        self._blocks = nn.ModuleList(blocks)
        self._conv_head = _SameConv2d(channels, _HEAD, 1)
        self._bn1 = nn.BatchNorm2d(_HEAD, eps=_EPSILON)
        self._fc = nn.Linear(_HEAD, classes)

    def layers(self) -> Iterator[Layer]:
        """Yield ``stem``, ``block0`` to ``block15``, and ``head``.

        The first takes (B, 3, H, W) float32 RGB in [0, 1], normalised with ``MEAN`` and ``STD``; ``block10`` makes
        (B, 112, ceil(H / 16), ceil(W / 16)), of any sign, and ``head`` (B, 1280, ceil(H / 32), ceil(W / 32)) in
        [0, 6].
        """
        yield "stem", lambda x: _relu6(self._bn0(self._conv_stem(x)))
        for number, block in enumerate(self._blocks):
            yield f"block{number}", block
        yield "head", lambda x: _relu6(self._bn1(self._conv_head(x)))

    def forward(self, images: Tensor) -> Tensor:
        """Classify (B, 3, H, W) images: (B, classes) logits."""
        (x,) = respond(self, images, ("head",))
        return cast(Tensor, self._fc(x.mean(dim=(2, 3))))


MEAN, STD = 0.498, 0.502
"""Per-channel normalisation of RGB in [0, 1], the same for the three channels."""


def _relu6(fresh: Tensor) -> Tensor:
    """Clip a tensor that nobody else holds, in place: a large map more would push others out of the cache."""
    return functional.relu6(fresh, inplace=True)


class _SameConv2d(nn.Conv2d):
    """Convolution with TensorFlow's "same" padding: the odd pixel goes to the right and the bottom."""

    def __init__(self, inputs: int, outputs: int, kernel: int, stride: int = 1, groups: int = 1) -> None:
        # With stride 1 and an odd kernel "same" is symmetric, and the convolution can do it itself.
        padding = kernel // 2 if stride == 1 else 0
        super().__init__(inputs, outputs, kernel, stride, padding, groups=groups, bias=False)

    def forward(self, x: Tensor) -> Tensor:
        if self.stride[0] == 1:
            return super().forward(x)
        kernel, stride = self.kernel_size[0], self.stride[0]
        down = max((-(-x.shape[2] // stride) - 1) * stride + kernel - x.shape[2], 0)
        across = max((-(-x.shape[3] // stride) - 1) * stride + kernel - x.shape[3], 0)
        padded = functional.pad(x, (across // 2, across - across // 2, down // 2, down - down // 2))
        return super().forward(padded)


class _Block(nn.Module):
    """Inverted residual: expand, depth-wise convolution, project; added to its input where shapes allow."""

    def __init__(self, inputs: int, outputs: int, kernel: int, stride: int, expansion: int) -> None:
        super().__init__()
        hidden = inputs * expansion
        self.expands = expansion != 1
        self.residual = stride == 1 and inputs == outputs
        if self.expands:
            self._expand_conv = _SameConv2d(inputs, hidden, 1)
            self._bn0 = nn.BatchNorm2d(hidden, eps=_EPSILON)
        self._depthwise_conv = _SameConv2d(hidden, hidden, kernel, stride, groups=hidden)
        self._bn1 = nn.BatchNorm2d(hidden, eps=_EPSILON)
        self._project_conv = _SameConv2d(hidden, outputs, 1)
        self._bn2 = nn.BatchNorm2d(outputs, eps=_EPSILON)

    def forward(self, x: Tensor) -> Tensor:
        y: Tensor = _relu6(self._bn0(self._expand_conv(x))) if self.expands else x
        y = _relu6(self._bn1(self._depthwise_conv(y)))
        y = self._bn2(self._project_conv(y))
        return y.add_(x) if self.residual else y
