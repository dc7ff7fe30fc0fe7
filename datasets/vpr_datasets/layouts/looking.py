"""Looking around in a folder that may hold anything: what cannot be read is as good as not there."""

import os
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from vpr_bench.errors import DataError
from vpr_bench.files.images import image_files
from vpr_bench.types.image import SUFFIXES

_ENOUGH = 20_000
"""Folders and files that are looked at before the search for an image is given up."""


def folders_in(folder: Path) -> list[Path]:
    """Return the folders in a folder, sorted by name, without hidden ones."""
    try:
        return sorted(one for one in folder.iterdir() if one.is_dir() and not one.name.startswith((".", "__")))
    except OSError:
        return []


def images_in(folder: Path) -> list[Path]:
    """Return the image files of a folder, sorted by name."""
    try:
        return image_files(folder)
    except (DataError, OSError):
        return []


def walk_images(folder: Path) -> Iterator[Path]:
    """Yield the image files in a folder and all folders below it, in the order in which they lie on disk.

    Hidden files and folders are passed by, and links to folders are not followed: they may lead in circles.
    """
    return (file for file in _walk(folder) if _is_image(file))


def some_images(folder: Path, count: int) -> list[Path]:
    """Return the first images from a folder and those below it; fewer where it would take long to find more."""
    return list(islice((file for file in islice(_walk(folder), _ENOUGH) if _is_image(file)), count))


def _walk(folder: Path) -> Iterator[Path]:
    for place, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        yield Path(place)  # counted too: folders without files take their time
        yield from (Path(place, name) for name in names if not name.startswith("."))


def _is_image(file: Path) -> bool:
    return file.suffix.lower() in SUFFIXES and file.is_file()
