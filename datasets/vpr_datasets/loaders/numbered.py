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
    found = {file.name for file in folder.iterdir() if file.suffix.lower() in SUFFIXES}
    missing = [name for name in expected if name not in found]
    surplus = sorted(found.difference(expected))
    if missing or surplus:
        lacks = f"{missing[0]} and {len(missing) - 1} more are missing" if missing[1:] else f"{missing[:1]} is missing"
        has = f"{surplus[0]} is not one of them" if surplus else ""
        facts = "; ".join(fact for fact in (lacks if missing else "", has) if fact)
        raise DataError(
            f"{folder} must hold the {card.images} images {expected[0]} to {expected[-1]}: "
            f"found {len(found)}, {facts}. Restore them, or fetch the dataset again."
        )
    return Traverse(card.name, [folder / name for name in expected]), np.array(numbers, dtype=np.float64)
