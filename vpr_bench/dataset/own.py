"""Folders of one's own: described by a card that lies beside the images, or recognised by their layout."""

import re
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from vpr_bench.dataset.card import Card
from vpr_bench.dataset.layout import LAYOUTS, Recognised, recognise
from vpr_bench.errors import DataError, closest, first_fault

CARD_FILE = "vpr-bench.toml"
"""Name of the card beside one's own images."""


def own_card(folder: Path) -> Card:
    """Return the card that lies in a folder, or one made from what its layout tells.

    Raises
    ------
    DataError
        If the card is not valid, or the folder is of no known layout.
    """
    file = folder / CARD_FILE
    return _checked(Card.from_toml(file), file) if file.exists() else recognised_card(folder)[1]


def recognised_card(folder: Path, layout: str | None = None) -> tuple[Recognised, Card]:
    """Look at a folder and describe it.

    Parameters
    ----------
    folder : Path
        Holds the images, in folders.
    layout : str, optional
        Read it as this one; by default the most specific layout that recognises it.

    Raises
    ------
    UsageError
        If there is no such layout.
    DataError
        If no layout recognises the folder, or not this one.
    """
    said = recognise(folder, layout)
    if not said:
        known = ", ".join(entry.name for entry in LAYOUTS.entries())
        raise DataError(
            f"{folder} is not recognised as {layout or 'any layout'} (known: {known}). It needs folders of images, "
            "with positions or in the same order: see docs/own_data.md, or describe it in a card, vpr-bench.toml."
        )
    name, recognised = said[0]
    try:
        return recognised, Card.model_validate(describe(folder, name, recognised))
    except ValidationError as error:  # two folders whose names become one, for example
        raise DataError(
            f"{folder} looks like {name} ({recognised.found}), but makes no dataset: {first_fault(error)}. "
            "Rename its folders, or describe it in a card, vpr-bench.toml."
        ) from None


def describe(folder: Path, layout: str, recognised: Recognised) -> dict[str, Any]:
    """Return the content of a card for a folder that was recognised."""
    content: dict[str, Any] = {
        "id": slug(folder.name, "-") or "own",
        "name": folder.name or "own data",
        "summary": recognised.found,
        "citation": "not stated",
        "licence": "not stated",
        "homepage": "not stated",
        "unit": recognised.unit,
        "loader": {"layout": layout, "options": recognised.options},
        "traverses": recognised.traverses,
        "protocols": recognised.protocols,
    }
    return content | ({"given": recognised.given} if recognised.given else {})


def slug(text: str, joint: str = "_") -> str:
    """Turn a folder's name into a name for a traverse or, with the joint ``-``, for a dataset.

    Examples
    --------
    >>> slug("Day Left (1)"), slug("My-Walk.2024", "-")
    ('day_left_1', 'my-walk-2024')
    """
    return re.sub(r"[^a-z0-9]+", joint, text.lower()).strip(joint)


def _checked(card: Card, file: Path) -> Card:
    """Refuse a card beside images that would make the program load code or fetch anything: it may be anybody's."""
    if card.simulation is not None or card.download is not None:
        raise DataError(
            f"The card {file} must not have a [simulation] or a [download]: those are for installed datasets."
        )
    for loader in [card.loader, *(edition.loader for edition in card.editions)]:
        known = [entry.name for entry in LAYOUTS.entries()]
        if loader is not None and loader.layout not in known:
            raise DataError(
                f"The card {file} names no known layout: {loader.layout!r}. {closest(loader.layout, known)}"
            )
    return card
