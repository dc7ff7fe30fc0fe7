"""Telling the images of a folder from what else lies there."""

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
