"""AlexNet, whole or cut short.

Architecture: Krizhevsky, "One weird trick for parallelizing convolutional neural networks", arXiv:1404.5997, the
one-tower variant of Krizhevsky, Sutskever and Hinton, NIPS 2012. State-dict keys and shapes are torchvision's, so that
its checkpoints and those of Places365 load. Checked without torchvision: key by key against its published names and
shapes, by its published parameter count (61,100,840), by the counts of the cut networks that the thesis prints, and by
forward passes that agree with a second implementation written from the paper in functions alone (see the tests).
"""

from collections import OrderedDict
from collections.abc import Iterator
from typing import Literal, cast

from torch import Tensor, nn

from vpr_baselines.backbones.layers import Layer

Depth = Literal["pool5", "fc6", "fc7"]
"""The last layer before the head."""

_CONVOLUTIONS = (
    ("conv1", 2),
    ("pool1", 3),
    ("conv2", 5),
    ("pool2", 6),
    ("conv3", 8),
    ("conv4", 10),
    ("conv5", 12),
    ("pool5", 13),
)  # where in ``features`` each one stops
_POOLED = 256 * 6 * 6
_WIDE = 4096


class AlexNet(nn.Module):
    """The classifier; :attr:`features` is its convolutional part.

    Parameters
    ----------
    classes : int
        Outputs of the head.
    depth : {"fc7", "fc6", "pool5"}
        What the head stands on: the whole network (``fc7``), the network without its last fully connected layer but
        the head (``fc6``, 4096 inputs), or the convolutions alone (``pool5``, 9216 inputs). The thesis's network
        "without the last three layers" (of the classifier's entries: 4096 to 4096, ReLU, head) and "without the last
        two" have the same count of parameters because both are ``fc6``: of the layers that have weights, these three
        entries are two. Its "without the last six" is ``pool5``.
    """

    def __init__(self, classes: int = 1000, *, depth: Depth = "fc7") -> None:
        super().__init__()
        self.features = nn.Sequential(
            nn.Conv2d(3, 64, 11, stride=4, padding=2),
            nn.ReLU(),
            nn.MaxPool2d(3, stride=2),
            nn.Conv2d(64, 192, 5, padding=2),
            nn.ReLU(),
            nn.MaxPool2d(3, stride=2),
            nn.Conv2d(192, 384, 3, padding=1),
            nn.ReLU(),
            nn.Conv2d(384, 256, 3, padding=1),
            nn.ReLU(),
            nn.Conv2d(256, 256, 3, padding=1),
            nn.ReLU(),
            nn.MaxPool2d(3, stride=2),
        )
        self.avgpool = nn.AdaptiveAvgPool2d((6, 6))  # the size it has anyway for images of 223 to 254 pixels
        parts: list[tuple[str, nn.Module]] = [("0", nn.Dropout())]
        if depth != "pool5":
            parts += [("1", nn.Linear(_POOLED, _WIDE)), ("2", nn.ReLU()), ("3", nn.Dropout())]
        if depth == "fc7":
            parts += [("4", nn.Linear(_WIDE, _WIDE)), ("5", nn.ReLU())]
        # The head keeps its number whatever was cut before it.
        parts.append(("6", nn.Linear(_POOLED if depth == "pool5" else _WIDE, classes)))
        self.classifier = nn.Sequential(OrderedDict(parts))

    def layers(self) -> Iterator[Layer]:
        """Yield ``conv1`` to ``conv5`` (after their ReLUs), the pools after the first, second and fifth, and ``fc…``.

        The first takes (B, 3, H, W) float32 RGB in [0, 1], normalised with ``MEAN`` and ``STD``. For images of 223 to
        238 pixels ``conv3`` is (B, 384, 13, 13) and ``pool5`` (B, 256, 6, 6); ``fc6`` and ``fc7`` are (B, 4096). None
        is negative.
        """
        start = 0
        for name, stop in _CONVOLUTIONS:
            yield name, self.features[start:stop]
            start = stop
        if len(self.classifier) > 2:  # not cut down to dropout and head
            yield "fc6", lambda x: self.classifier[:3](self.avgpool(x).flatten(1))
        if len(self.classifier) > 5:
            yield "fc7", self.classifier[3:-1]

    def forward(self, images: Tensor) -> Tensor:
        """Classify (B, 3, H, W) images, of 63 pixels at least: (B, classes) logits."""
        return cast(Tensor, self.classifier(self.avgpool(self.features(images)).flatten(1)))


MEAN, STD = (0.485, 0.456, 0.406), (0.229, 0.224, 0.225)
"""Normalisation of RGB in [0, 1], with which both ImageNet's and Places365's weights were trained."""
