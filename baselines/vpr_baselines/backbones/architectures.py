"""The networks by name, and loading their weights."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial
from itertools import pairwise
from typing import Literal, cast

import torch
from torch import nn
from torch.nn.utils.fusion import fuse_conv_bn_eval

from vpr_baselines.backbones import alexnet, efficientnet_lite0, resnet18
from vpr_baselines.backbones.layers import Layered
from vpr_bench.weights.choice import choose_weights
from vpr_bench.weights.fit import fit_checkpoint

Backbone = Literal["efficientnet-lite0", "resnet18", "alexnet"]
"""Names of the networks. The weights of the first come with the installation."""

Channels = tuple[float, float, float]


@dataclass(frozen=True)
class Architecture:
    """A network that can be built and given weights.

    Attributes
    ----------
    name : Backbone
        Weights of it have ids that begin so.
    build : callable
        Makes the network, without what nobody looks at.
    head : str
        Name of the classification head, and of what else is cut, in checkpoints: neither is needed.
    last : str
        The layer whose map is pooled into a global descriptor.
    middle : str
        The last layer with a cell for every 16 pixels, whose cells are compared one by one.
    mean, std : three floats
        What the weights expect the channels of an image in [0, 1] to be normalised with.
    """

    name: Backbone
    build: Callable[[], nn.Module]
    head: str
    last: str
    middle: str
    mean: Channels
    std: Channels

    def cut_at(self, last: str) -> tuple[str, str]:
        """Return the middle and the last layer of the network cut short; the same one if it is cut before the middle.

        Raises
        ------
        ValueError
            If there is no such layer.
        """
        with torch.device("meta"):  # no weights are made
            names = [name for name, _ in cast(Layered, self.build()).layers()]
        if last not in names:
            raise ValueError(f"{self.name} has the layers {', '.join(names)}. Got {last!r} instead.")
        return min(self.middle, last, key=names.index), last


_LITE0_MEAN, _LITE0_STD = efficientnet_lite0.MEAN, efficientnet_lite0.STD

ARCHITECTURES: dict[Backbone, Architecture] = {
    one.name: one
    for one in (
        Architecture(
            "efficientnet-lite0",
            partial(efficientnet_lite0.EfficientNetLite0, 1),
            "_fc",
            "head",
            "block10",
            (_LITE0_MEAN, _LITE0_MEAN, _LITE0_MEAN),
            (_LITE0_STD, _LITE0_STD, _LITE0_STD),
        ),
        Architecture("resnet18", partial(resnet18.ResNet18, 1), "fc", "layer4", "layer3", resnet18.MEAN, resnet18.STD),
        Architecture(
            "alexnet",
            partial(alexnet.AlexNet, 1, depth="pool5"),
            "classifier",
            "pool5",
            "conv5",
            alexnet.MEAN,
            alexnet.STD,
        ),
    )
}
"""The trunks."""

WHOLE_ALEXNET = Architecture(
    "alexnet", partial(alexnet.AlexNet, 1), "classifier.6", "fc7", "conv5", alexnet.MEAN, alexnet.STD
)
"""With its fully connected layers but the last, 54 of its 61 million parameters."""


@cache
def load_network(architecture: Architecture, weights: str, seed: int = 0) -> nn.Module:
    """Build a network with its weights, frozen and folded; the same one is shared by all that ask for it.

    Parameters
    ----------
    architecture : Architecture
        The network.
    weights : str
        As for :func:`vpr_bench.weights.choice.choose_weights`.
    seed : int
        Of random weights.

    Raises
    ------
    UsageError
        If ``weights`` means nothing.
    DataError
        If the weights are missing, damaged, or of another network.
    """
    choice = choose_weights(architecture.name, weights, seed)
    identity = choice.identity()
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        network = architecture.build()
        if choice.random:
            network.apply(_initialise)
    if not choice.random:
        fit_checkpoint(network, choice.tensors(), allow_head=architecture.head, name=identity)
    network.eval()
    _fold_norms(network)
    network.to(memory_format=torch.channels_last)  # type: ignore[call-overload]
    return network.requires_grad_(False)


def _initialise(module: nn.Module) -> None:
    """Draw weights as He et al. (ICCV 2015, eq. 10) do: deep networks answer with zeros else."""
    if isinstance(module, nn.Conv2d | nn.Linear):
        nn.init.kaiming_normal_(module.weight, nonlinearity="relu")


def _fold_norms(module: nn.Module) -> None:
    """Fold every batch norm into the convolution before it: a third less time, the same numbers."""
    for (convolution, first), (norm, second) in pairwise(list(module.named_children())):
        if isinstance(first, nn.Conv2d) and isinstance(second, nn.BatchNorm2d):
            setattr(module, convolution, fuse_conv_bn_eval(first, second))
            setattr(module, norm, nn.Identity())
    for child in module.children():
        _fold_norms(child)
