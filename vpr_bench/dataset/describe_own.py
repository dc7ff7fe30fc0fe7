"""Describing a folder of one's own once and for all: from what a layout recognises to a card beside the images."""

import re
import tomllib
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from vpr_bench.dataset.advice import unrecognised
from vpr_bench.dataset.card import DATASETS, Card
from vpr_bench.dataset.layout import Recognised, find_layout, recognise
from vpr_bench.errors import DataError, UsageError, VprBenchError, blaming, first_fault, one_line

CARD_FILE = "vpr-bench.toml"
"""Name of the card beside one's own images."""

_HEADER = """\
# What vpr-bench knows about the images beside this file. Edit it freely, then look at the outcome with
# `vpr-bench data preview`.
#
# protocols   which traverse is looked up (queries) in which (references); the first one is the default.
# radius      how far apart two places may be and still be the same one, in the unit: f (frames) or m (metres).
# digest      of the files of a traverse: `vpr-bench data verify` compares it, and so sees whether they changed.
#
# `vpr-bench data init --force` writes the file anew.

"""


@dataclass(frozen=True, eq=False)
class Description:
    """What a folder was recognised as.

    Attributes
    ----------
    folder : Path
        Holds the traverses.
    content : dict
        Of the card, as it can be written to a file.
    card : Card
        The same, checked.
    others : dict of str to str
        Further layouts that recognise the folder, with what they find.
    """

    folder: Path
    content: dict[str, Any]
    card: Card
    others: dict[str, str]

    @property
    def file(self) -> Path:
        """Where the card goes."""
        return self.folder / CARD_FILE

    def with_digests(self, digest_of: Callable[[str], str]) -> str:
        """Return the card as text, with the digest of each traverse, which ``digest_of`` returns by its name.

        Raises
        ------
        DataError
            If it cannot be written down, as where a name is not text.
        """
        import tomli_w

        traverses = [{**one, "digest": digest_of(one["name"])} for one in self.content["traverses"]]
        text = _HEADER + tomli_w.dumps({**self.content, "traverses": traverses})
        with blaming(f"{self.folder} cannot be described", DataError):
            text.encode()
            Card.model_validate(tomllib.loads(text))
        return text


def describe_own(
    folder: Path,
    layout: str | None = None,
    *,
    dataset_id: str | None = None,
    radius: float | None = None,
    **stated: str | None,
) -> Description:
    """Look at a folder and describe it; nothing is written.

    Parameters
    ----------
    folder : Path
        Holds the images, in folders.
    layout : str, optional
        Read it as this one; by default the most specific layout that recognises it.
    dataset_id : str, optional
        By default made from the folder's name.
    radius : float, optional
        Of all protocols that have one.
    **stated : str, optional
        Other fields of the card: ``name``, ``licence``, ``citation``.

    Raises
    ------
    UsageError
        If there is no such layout, the id is not one or is taken, or there is nothing with a radius.
    DataError
        If the folder is not recognised.
    """
    said = _recognised(folder, layout)
    name = layout or next(iter(said))
    content = card_content(folder, name, said[name])
    content |= {key: one_line(value) for key, value in stated.items() if value}
    content |= {"name": one_line(content["name"]) or "own data", "id": _free_id(dataset_id, content["id"])}
    if radius is not None:
        content["protocols"] = _reaching(content, radius)
    content = _plain(content)
    try:
        card = Card.model_validate(content)
    except ValidationError as error:
        raise DataError(f"{folder} cannot be described: {first_fault(error)}.") from None
    return Description(folder, content, card, {key: one.found for key, one in said.items() if key != name})


def _recognised(folder: Path, layout: str | None) -> dict[str, Recognised]:
    """Return what the layouts say about a folder, of which one is asked for; all others may fail then."""
    said = dict(recognise(folder, layout))
    if layout is not None:
        if find_layout(layout).recognise is None:
            raise UsageError(f"The layout {layout!r} recognises no folders: it needs a card, see docs/own_data.md.")
        with suppress(VprBenchError):
            said = dict(recognise(folder)) | said
    if layout not in (None, *said) or not said:
        raise DataError(unrecognised(folder, layout, list(said)))
    return said


def card_content(folder: Path, layout: str, recognised: Recognised) -> dict[str, Any]:
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


def _free_id(asked: str | None, usual: str) -> str:
    """Return an id that no installed dataset has: their results must not stand in one table."""
    taken = {entry.name for entry in DATASETS.entries()}
    if asked is None:
        return f"my-{usual}" if usual in taken else usual
    if not re.fullmatch(r"[a-z0-9][a-z0-9-]*", asked):
        hint = f" Try {slug(asked, '-')!r}." if slug(asked, "-") else ""
        raise UsageError(f"An id is made of lower-case letters, digits and '-'. Got {asked!r} instead.{hint}")
    if asked in taken:
        raise UsageError(f"There is a dataset {asked!r} already, and results must tell them apart: choose another id.")
    return asked


def _reaching(content: dict[str, Any], radius: float) -> list[dict[str, Any]]:
    protocols: list[dict[str, Any]] = content["protocols"]
    units = [one.get("unit") or content["unit"] for one in protocols]
    if not 0 <= radius < float("inf"):
        raise UsageError(f"The radius must be a number of at least 0. Got {radius:g} instead.")
    if not {"f", "m"} & set(units):
        raise UsageError(f"{content['summary']}: nothing that has a radius.")
    return [
        {**one, "radius": radius} if unit in ("f", "m") else one for one, unit in zip(protocols, units, strict=True)
    ]


def _plain(value: Any) -> Any:
    """Return only what a file can hold: without None, and without the number types of other libraries."""
    if isinstance(value, dict):
        return {str(key): _plain(one) for key, one in value.items() if one is not None and one != {}}
    if isinstance(value, list | tuple):
        return [_plain(one) for one in value]
    if isinstance(value, Path):
        return value.as_posix()
    return value.item() if hasattr(value, "item") else value
