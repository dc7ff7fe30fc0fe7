"""Folders of one's own: described by a card that lies beside the images, or recognised by their layout."""

from pathlib import Path

from vpr_bench.dataset.card import Card
from vpr_bench.dataset.describe_own import CARD_FILE, describe_own
from vpr_bench.dataset.layout import LAYOUTS
from vpr_bench.errors import DataError, closest


def own_card(folder: Path) -> Card:
    """Return the card that lies in a folder, or one made from what its layout tells.

    Raises
    ------
    DataError
        If the card is not valid, or the folder is of no known layout.
    """
    file = folder / CARD_FILE
    return _checked(Card.from_toml(file), file) if file.exists() else describe_own(folder).card


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
