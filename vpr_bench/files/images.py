"""The image files of a folder, and the order in which a camera or a person numbers files."""

import re
from pathlib import Path

from vpr_bench.errors import DataError
from vpr_bench.files.disk import disk_errors
from vpr_bench.types.image import SUFFIXES


def image_files(folder: Path) -> list[Path]:
    """Return the image files of a folder, sorted by name.

    Hidden files are no images: copying from a Mac leaves a ``._Image000.jpg`` beside each image.

    Raises
    ------
    DataError
        If the folder is missing or cannot be read.
    """
    if not folder.is_dir():
        raise DataError(f"The folder {folder} is missing. Restore it, or fetch the dataset again.")
    with disk_errors(folder, "read"):
        return sorted(
            file
            for file in folder.iterdir()
            if file.suffix.lower() in SUFFIXES and not file.name.startswith(".") and file.is_file()
        )


def listed(folder: Path) -> list[Path]:
    """Return the image files of a folder in natural order, ``img2`` before ``img10``.

    Raises
    ------
    DataError
        If the folder is missing or cannot be read.
    """
    return sorted(image_files(folder), key=lambda file: natural_key(file.name))


def some_listed(folder: Path) -> list[Path]:
    """Return the image files of a folder in natural order; at least one.

    Raises
    ------
    DataError
        If the folder is missing, cannot be read, or has none.
    """
    files = listed(folder)
    if not files:
        raise DataError(f"{folder} holds no images.")
    return files


def natural_key(name: str) -> tuple[list[str | int], str]:
    """Return a sorting key by which ``2.jpg`` comes before ``10.jpg``.

    Examples
    --------
    >>> sorted(["b-10.jpg", "b-2.jpg", "a-11.jpg"], key=natural_key)
    ['a-11.jpg', 'b-2.jpg', 'b-10.jpg']
    """
    # Text and numbers take turns, so that two keys are always compared like with like.
    parts: list[str | int] = list(re.split(r"([0-9]+)", name))
    parts[1::2] = [int(part) for part in parts[1::2]]
    return parts, name  # the name itself tells 01.jpg from 1.jpg
