"""Looking inside a network: the responses of its layers, by name."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Protocol

from torch import Tensor

Layer = tuple[str, Callable[[Tensor], Any]]
"""A name, and what turns the response of the layer before into its own."""


class Layered(Protocol):
    """A network that can be taken layer by layer."""

    def layers(self) -> Iterator[Layer]:
        """Yield the layers in their order, all but a classification head."""
        ...


def respond(network: Layered, images: Tensor, names: Sequence[str]) -> list[Tensor]:
    """Compute what some layers respond to images, in one pass that stops after the last of them.

    Parameters
    ----------
    network : Layered
        The network.
    images : (B, 3, H, W) float32
        As its first layer takes them.
    names : sequence of str
        The layers wanted, in any order.

    Returns
    -------
    list of (B, …) float32
        In the order of ``names``.

    Raises
    ------
    ValueError
        If there is no such layer.
    """
    responses: dict[str, Tensor] = {}
    x = images
    for name, layer in network.layers():
        x = layer(x)
        if name in names:
            responses[name] = x
            if len(responses) == len(set(names)):
                return [responses[one] for one in names]
    known = ", ".join(name for name, _ in network.layers())
    raise ValueError(f"{type(network).__name__} has the layers {known}. Got {', '.join(names)} instead.")
