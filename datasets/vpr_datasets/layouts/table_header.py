"""The first line of a table: which column holds what."""

import csv
from dataclasses import dataclass

_IMAGE = ("image", "file", "filename", "path")
_METRES = (("x", "y"), ("easting", "northing"), ("utm_east", "utm_north"))
_DEGREES = (("lat", "lon"), ("latitude", "longitude"))
_TRAVERSE = ("traverse", "split", "role", "set")
_COMPASS = ("heading", "compass", "ca")
NEEDED = (
    "a column image (or file, filename, path), and columns x and y, easting and northing, or lat and lon, each once"
)
"""What a header must have, for a person."""


@dataclass(frozen=True)
class Columns:
    """Where in a row what stands.

    Attributes
    ----------
    width : int
        How many cells a row has.
    image : int
        The image's path.
    position : (int, int)
        Metres east and north, or latitude and longitude in degrees.
    degrees : bool
        Which of the two.
    traverse, compass : int or None
        None where there is no such column.
    """

    width: int
    image: int
    position: tuple[int, int]
    degrees: bool
    traverse: int | None
    compass: int | None


def find_columns(header: str) -> tuple[str, Columns] | None:
    """Find the separator with which a header makes sense, and its columns; None if there is none.

    Where a table has metres and degrees, the metres are taken.

    Examples
    --------
    >>> find_columns("Image;lat;lon")
    (';', Columns(width=3, image=0, position=(1, 2), degrees=True, traverse=None, compass=None))
    """
    for separator in (",", ";", "\t"):
        try:
            names = [name.strip().lower() for name in next(csv.reader([header], delimiter=separator, strict=True), [])]
        except csv.Error:
            continue
        columns = _columns(names)
        if columns is not None:
            return separator, columns
    return None


def _columns(names: list[str]) -> Columns | None:
    image = next((name for name in _IMAGE if name in names), None)
    pair = next((pair for pair in (*_METRES, *_DEGREES) if set(pair) <= set(names)), None)
    if image is None or pair is None:
        return None
    traverse, compass = (
        next((names.index(name) for name in known if name in names), None) for known in (_TRAVERSE, _COMPASS)
    )
    if any(names.count(name) > 1 for name in (image, *pair)):
        return None
    position = names.index(pair[0]), names.index(pair[1])
    return Columns(len(names), names.index(image), position, pair in _DEGREES, traverse, compass)
