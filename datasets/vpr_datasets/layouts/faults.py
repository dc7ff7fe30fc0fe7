"""Refusing what is wrong with many files: the first by name, the others by their number."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.errors import DataError
from vpr_datasets.layouts.metres import PositionError, to_metres


def refuse(faults: Sequence[str], advice: str) -> None:
    """Raise an error if there are faults.

    Raises
    ------
    DataError
        Says what the first is, how many more there are, and what to do next.
    """
    if faults:
        raise DataError(f"{faults[0]}{_and_more(len(faults))}. {advice}")


def placed(
    latitude: ArrayLike, longitude: ArrayLike, zone: str, names: Sequence[object], advice: str
) -> NDArray[np.float64]:
    """Project positions as :func:`to_metres` does, with errors that name where they come from.

    Parameters
    ----------
    latitude, longitude : (n,) floats
        In degrees.
    zone : str
        UTM zone.
    names : sequence of n
        What to call each position: a file, perhaps with a line.
    advice : str
        What to do next, one sentence.

    Returns
    -------
    (n, 2) float64
        Easting and northing, in metres.

    Raises
    ------
    DataError
        If one cannot be a position in this zone.
    """
    try:
        return to_metres(latitude, longitude, zone)
    except PositionError as error:
        raise DataError(f"{names[error.row]}: {error}{_and_more(error.count)}. {advice}") from None


def check_count(folder: Path, card: TraverseCard, count: int) -> None:
    """Compare how many images there are with what the card says.

    Raises
    ------
    DataError
        If there are none, more or fewer.
    """
    if count == 0:
        raise DataError(f"{folder} holds no images. Restore them, or fetch the dataset again.")
    if card.images not in (None, count):
        raise DataError(
            f"{folder} must hold the {card.images} images of {card.name}: found {count}. "
            "Restore them, or fetch the dataset again."
        )


def _and_more(count: int) -> str:
    return f" (and {count - 1} more with faults)" if count > 1 else ""
