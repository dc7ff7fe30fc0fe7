"""Text files with one GPS fix per frame of a video."""

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.layouts.faults import placed, refuse
from vpr_datasets.layouts.texts import parse_number, quoted, read_text

_BETWEEN = re.compile(r"\s*,\s*|\s+")


def read_fixes(file: Path, zone: str, *, flip_latitude: bool) -> NDArray[np.float64]:
    """Read where each frame was taken.

    Parameters
    ----------
    file : Path
        One line per frame, ``latitude,longitude`` in degrees, with a comma or white space between them; no header.
    zone : str
        UTM zone in which the positions are written, for example ``56J``.
    flip_latitude : bool
        The latitudes are southern, but the file has them without a sign.

    Returns
    -------
    (n, 2) float64
        Easting and northing of each line, in metres.

    Raises
    ------
    DataError
        If the file cannot be read, or a line holds no fix or one that is not near the zone. A fix that is missing
        is not made up: the frames after it would get the places of others.
    """
    lines = read_text(file).rstrip().split("\n")
    advice = "There must be one latitude,longitude per frame: restore the file, or cut it and the images there."
    fixes, faults = [], []
    for number, line in enumerate(lines, start=1):
        try:
            fixes.append(_fix(line))
        except ValueError as error:
            faults.append(f"{file}, line {number}: {error}")
    refuse(faults, advice)
    latitude, longitude = np.array(fixes, dtype=np.float64).T
    names = [f"{file}, line {number}" for number in range(1, len(lines) + 1)]
    return placed(-latitude if flip_latitude else latitude, longitude, zone, names, advice)


def _fix(line: str) -> tuple[float, float]:
    if not line.strip():
        raise ValueError("the line is empty, so the frame has no fix")
    found = _BETWEEN.split(line.strip())
    if len(found) != 2:
        raise ValueError(f"expected two numbers, found {quoted(line)}")
    return parse_number(found[0]), parse_number(found[1])
