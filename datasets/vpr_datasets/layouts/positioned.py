"""Describing folders of images whose positions are known in metres."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import chain, count
from pathlib import PurePosixPath
from typing import Any

from pydantic import ValidationError

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.describe_own import slug
from vpr_bench.dataset.layout import Recognised
from vpr_bench.errors import DataError
from vpr_datasets.layouts.roles import pairings

RADIUS = 25.0
"""Metres within which two images show the same place, unless the user says otherwise: what most papers take."""


@dataclass(frozen=True)
class Found:
    """A traverse that a layout found in a folder.

    Attributes
    ----------
    label : str
        What its owner calls it.
    folder : str
        Inside the dataset's folder, with ``/``.
    images : int
        How many there are.
    area : str
        Only traverses of one area are looked up in each other.
    options : dict
        For the layout.
    """

    label: str
    folder: str
    images: int
    area: str = ""
    options: dict[str, Any] = field(default_factory=dict)


def positioned(found: str, traverses: Sequence[Found], options: dict[str, Any] | None = None) -> Recognised | None:
    """Describe traverses with positions in metres.

    Parameters
    ----------
    found : str
        What the positions are taken from, for a person: the counts are written before it.
    traverses : sequence of Found
        In the order in which they are listed.
    options : dict, optional
        What the layout needs to know about all of them.

    Returns
    -------
    Recognised or None
        None if no traverse can be looked up in another.

    Raises
    ------
    DataError
        If a folder has a name that no card can hold.
    """
    names = _names(traverses)
    protocols: list[dict[str, Any]] = []
    for area in dict.fromkeys(one.area for one in traverses):
        known = {one.label: name for one, name in zip(traverses, names, strict=True) if one.area == area}
        protocols += [
            {"references": known[map_], "queries": known[query], "radius": RADIUS} for map_, query in pairings([*known])
        ]
    if not protocols:
        return None
    counts = ", ".join(f"{one.images} of {name}" for one, name in zip(traverses, names, strict=True))
    cards = [_card(one, name) for one, name in zip(traverses, names, strict=True)]
    return Recognised(f"images with {found}: {counts}", "m", cards, protocols, options or {})


def _names(traverses: Sequence[Found]) -> list[str]:
    """Make names for a card: each once, even where labels differ in capitals only or hold no letter that it takes."""
    names: list[str] = []
    for one in traverses:
        plain = slug(one.label) or "traverse"
        longer = (f"{plain}_{number}" for number in count(2))
        within = [slug(f"{one.area}_{one.label}")] if one.area else []
        names.append(next(name for name in chain([plain], within, longer) if name not in names))
    return names


def _card(one: Found, name: str) -> dict[str, Any]:
    card = {"name": name, "folder": one.folder, "images": one.images}
    if one.options:
        card["options"] = one.options
    try:
        TraverseCard.model_validate(card)
        PurePosixPath(one.folder).as_posix().encode()
    except (ValidationError, UnicodeEncodeError):
        raise DataError(f"The folder {one.folder!r} has a name that no card can hold: rename it.") from None
    return card
