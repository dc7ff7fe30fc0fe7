"""Folders of numbered frames, where the same number is the same place."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.errors import DataError
from vpr_bench.types.image import SUFFIXES
from vpr_bench.types.traverse import Traverse


def load(folder: Path, card: TraverseCard, pattern: str, first: int = 0) -> tuple[Traverse, NDArray[np.float64]]:
    """Find the frames of one traverse; nothing is decoded.

    Parameters
    ----------
    folder : Path
        The traverse's folder.
    card : TraverseCard
        Says how many images there must be.
    pattern : str
        File name with ``{index}``, for example ``Image{index:03d}.jpg``.
    first : int
        Number of the first frame.

    Returns
    -------
    traverse : Traverse
        In the order of the numbers.
    labels : (images,) float64
        Frame numbers.

    Raises
    ------
    DataError
        If the folder is missing, or an image is missing or is one too many.
    """
    if not folder.is_dir():
        raise DataError(f"The folder {folder} of the traverse {card.name!r} is missing. Fetch the dataset again.")
    numbers = range(first, first + card.images)
    expected = [pattern.format(index=number) for number in numbers]
    # Hidden files are no frames: copying from a Mac leaves a ._Image000.jpg beside each image.
    visible = (file for file in folder.iterdir() if not file.name.startswith("."))
    found = {file.name for file in visible if file.suffix.lower() in SUFFIXES}
    missing = [name for name in expected if name not in found]
    surplus = sorted(found.difference(expected))
    if missing or surplus:
        faults = [*_counted(missing, "missing"), *_counted(surplus, "not of them")]
        raise DataError(
            f"{folder} must hold the {card.images} images {expected[0]} to {expected[-1]}: "
            f"found {len(found)}, {'; '.join(faults)}. Restore them, or fetch the dataset again."
        )
    return Traverse(card.name, [folder / name for name in expected]), np.array(numbers, dtype=np.float64)


def _counted(names: list[str], what: str) -> list[str]:
    """Say what the first of some files is, and how many more of its kind there are; nothing where there is none."""
    if len(names) > 1:
        return [f"{names[0]} and {len(names) - 1} more are {what}"]
    return [f"{name} is {what}" for name in names]
