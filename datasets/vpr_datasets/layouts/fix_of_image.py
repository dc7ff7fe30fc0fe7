"""Which line of a GPS file is which image's."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError
from vpr_datasets.layouts.alignment import number_in
from vpr_datasets.layouts.gps_text import read_fixes


def fixes_of(
    files: Sequence[Path],
    gps: Path,
    zone: str,
    flip_latitude: bool,
    stride: int | None = None,
    first_frame: int | None = None,
) -> NDArray[np.float64]:
    """Return where each image was taken.

    Parameters
    ----------
    files : sequence of Path
        The images, in order.
    gps : Path
        The file with the positions.
    zone, flip_latitude
        See :func:`~vpr_datasets.layouts.gps_text.read_fixes`.
    stride : int, optional
        Image ``i`` has line ``i × stride``, counted from 0.
    first_frame : int, optional
        The number in an image's name is that of the frame, and the first line belongs to this one. By default there
        is one line per image.

    Returns
    -------
    (n, 2) float64
        Easting and northing, in metres.

    Raises
    ------
    DataError
        If there are more or fewer lines than images and no option says which are whose, or an image has none.
    """
    fixes = read_fixes(gps, zone, flip_latitude=flip_latitude)
    if stride is not None and (stride < 1 or first_frame is not None):
        raise DataError(f"The option stride must be at least 1, and goes without first_frame. Got {stride} instead.")
    if stride is None and first_frame is None:
        if len(fixes) != len(files):
            raise DataError(
                f"{gps} has {len(fixes)} positions for {len(files)} images. Restore what is missing or, if the images "
                "are only some of the frames, say which: option stride, or first_frame for numbers in their names."
            )
        return fixes
    lines = [index * (stride or 1) for index in range(len(files))]
    if first_frame is not None:
        lines = [_frame(file) - first_frame for file in files]
    for file, line in zip(files, lines, strict=True):
        if not 0 <= line < len(fixes):
            raise DataError(
                f"{gps} has {len(fixes)} positions, and {file.name} would need number {line + 1}. Check the option "
                f"{'stride' if stride else 'first_frame'}, or restore the file."
            )
    return fixes[lines]


def _frame(file: Path) -> int:
    number = number_in(file)
    if number is None:
        raise DataError(f"{file} has no number in its name, by which the option first_frame looks for its position.")
    return number
