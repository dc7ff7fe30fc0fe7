"""Telling from files' names and order which images of several folders show the same place."""

import hashlib
import re
import unicodedata
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError
from vpr_bench.files.images import natural_key

Align = Literal["order", "number", "stem"]

_EXACT = 2**53
"""Labels are float64, which tell whole numbers apart up to here."""


def number_in(file: Path) -> int | None:
    """Return the last number in a file's name, without the ending; None if there is none.

    Examples
    --------
    >>> number_in(Path("cam0_image00202.png")), number_in(Path("library.jpg"))
    (202, None)
    """
    digits = re.findall("[0-9]+", file.stem)
    return int(digits[-1]) if digits else None


def id_of(file: Path) -> int:
    """Return a number for a file's name without its ending: the number that it is, else one made of its letters.

    The same on every machine, and below 2⁵³; names of letters never meet those of digits.

    Examples
    --------
    >>> id_of(Path("0042.png")), id_of(Path("library.jpg")) == id_of(Path("old/library.png"))
    (42, True)
    """
    stem = unicodedata.normalize("NFC", file.stem)  # a Mac takes accents apart
    if re.fullmatch("[0-9]+", stem) and int(stem) < _EXACT // 2:
        return int(stem)
    digest = hashlib.sha256(stem.encode("utf-8", "surrogateescape")).digest()
    return _EXACT // 2 + int.from_bytes(digest[:8], "big") % (_EXACT // 2)


def aligned(files: Sequence[Path], align: Align) -> tuple[list[Path], NDArray[np.float64]]:
    """Return the images of one folder in order, and the label of each.

    Parameters
    ----------
    files : sequence of Path
        In natural order.
    align : {"order", "number", "stem"}
        A label is the position in this order, the last number in the name, or a number made of the name.

    Returns
    -------
    list of Path, (n,) float64
        Sorted by number if that is the label.

    Raises
    ------
    DataError
        If a name has no number or too large a one, or two images have the same label.
    """
    if align == "order":
        return list(files), np.arange(len(files), dtype=np.float64)
    if align == "stem":
        labels = [id_of(file) for file in files]
    else:
        files = sorted(files, key=lambda file: (number_in(file) or 0, natural_key(file.name)))
        labels = [_checked_number(file) for file in files]
    label, count = Counter(labels).most_common(1)[0] if labels else (0, 1)
    if count > 1:
        first, second = [file for file, one in zip(files, labels, strict=True) if one == label][:2]
        raise DataError(
            f"{first} and {second.name} have the same {'number' if align == 'number' else 'name'}, and so would be the "
            "same place. Rename one of them, or set the option align to 'order'."
        )
    return list(files), np.array(labels, dtype=np.float64)


def _checked_number(file: Path) -> int:
    number = number_in(file)
    if number is None or number >= _EXACT:
        what = "no number" if number is None else f"a number above {_EXACT - 1}"
        raise DataError(f"{file} has {what} in its name. Rename it, or set the option align to 'order' or 'stem'.")
    return number


def choose(folders: Sequence[Sequence[Path]]) -> tuple[Align, Literal["f", "pair"]] | None:
    """Say how folders of images, the map's first, are best aligned, and in what unit; None if nothing speaks for any.

    Names say something where they are no mere count of the folder's images, as the names of frames that were cut out
    of any two videos are: where they have gaps, or steps that differ, or no numbers, and are the same nevertheless.
    If the numbers of one folder have no gaps, it is a recording, and neighbours in it are near each other. Else only
    images of the same name are known to show the same place. Where names say nothing, as many images in each folder
    speak for the order.

    Examples
    --------
    >>> choose([[Path("1.jpg"), Path("2.jpg")], [Path("a7.jpg"), Path("a8.jpg")]])
    ('order', 'f')
    """
    numbers = [_numbers(files) for files in folders]
    steps = [_step(one) for one in numbers]
    if len(set(steps)) > 1 or None in steps:
        unit: Literal["f", "pair"] = "pair" if set(steps) == {None} else "f"
        same_names = _overlap([_ids(files) for files in folders])
        if all(numbers) and _overlap([set(one) for one in numbers]):
            return ("stem" if same_names and unit == "pair" else "number"), unit
        if same_names:
            return "stem", "pair"
    return ("order", "f") if len({len(files) for files in folders}) == 1 else None


def _numbers(files: Sequence[Path]) -> list[int]:
    """Return the sorted numbers in the names; nothing unless each image has its own."""
    numbers = [number_in(file) for file in files]
    usable = {one for one in numbers if one is not None and one < _EXACT}
    return sorted(usable) if len(usable) == len(files) else []


def _ids(files: Sequence[Path]) -> set[int]:
    """Return the numbers made of the names; nothing unless each image has its own."""
    ids = {id_of(file) for file in files}
    return ids if len(ids) == len(files) else set()


def _step(numbers: list[int]) -> int | None:
    """Return what is always added from one number to the next, None if that differs or there are no numbers."""
    steps = {second - first for first, second in pairwise(numbers)}
    return steps.pop() if len(steps) == 1 else None


def _overlap(folders: Sequence[set[int]]) -> bool:
    """Say whether every folder shares half of its names with the first, or half of the first's if it has fewer."""
    map_ = folders[0]
    return all(2 * len(map_ & other) >= min(len(map_), len(other)) > 0 for other in folders[1:])
