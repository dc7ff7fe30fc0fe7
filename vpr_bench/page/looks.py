"""How each method is drawn, the same in every chart of the page."""

from collections.abc import Iterable
from dataclasses import dataclass

from vpr_bench.errors import one_line

COLOURS, DASHES, MARKERS = 9, 4, 8
"""How many of each the page's style sheet and script know; no two of 72 methods look alike."""


@dataclass(frozen=True)
class Look:
    """Numbers of a colour, a dash and a marker: who cannot tell the colours apart has the other two."""

    colour: int
    dash: int
    marker: int


def displayed(method: str) -> str:
    r"""Return what the page calls a method, whose label may come from anywhere.

    Examples
    --------
    >>> displayed("gnp.\u202e\nhog")
    'gnp. hog'
    """
    return one_line(method) or "?"


def looks(methods: Iterable[str]) -> dict[str, Look]:
    """Give each method, by what the page calls it, a look in the order of first appearance.

    Examples
    --------
    >>> looks(["hog", "sad", "hog"])
    {'hog': Look(colour=0, dash=0, marker=0), 'sad': Look(colour=1, dash=1, marker=1)}
    """
    names = dict.fromkeys(map(displayed, methods))
    return {name: Look(number % COLOURS, number % DASHES, number % MARKERS) for number, name in enumerate(names)}
