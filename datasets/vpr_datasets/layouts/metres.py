"""From degrees to metres: latitude and longitude as UTM easting and northing, all in one zone."""

import re

import numpy as np
from numpy.typing import ArrayLike, NDArray

from vpr_bench.errors import DataError

_ZONE = re.compile(r"(0?[1-9]|[1-5][0-9]|60)([C-HJ-NP-X])")
_FARTHEST = 6.0
"""Degrees from the zone's central meridian: up to there the projection is good to millimetres. A zone has 3."""
_AROUND_EQUATOR = 0.5
"""Degrees: so close to the equator a walk may cross it, and either sign of the latitude is taken."""


class PositionError(ValueError):
    """A position that cannot be one; the caller knows which file and line it comes from.

    Attributes
    ----------
    row : int
        Where the first of them stands in the arrays.
    count : int
        How many there are, at least 1.
    """

    def __init__(self, message: str, row: int = 0, count: int = 1) -> None:
        super().__init__(message)
        self.row = row
        self.count = count


def to_metres(latitude: ArrayLike, longitude: ArrayLike, zone: str) -> NDArray[np.float64]:
    """Project positions.

    Parameters
    ----------
    latitude, longitude : (n,) floats
        WGS84, in degrees; south and west are negative.
    zone : str
        UTM zone in which all of them are written, as ``33U``: a border of zones may run through the positions.

    Returns
    -------
    (n, 2) float64
        Easting and northing, in metres.

    Raises
    ------
    PositionError
        If a position is not finite, not on earth, (0, 0) as receivers write that have none, or not near the zone.
    DataError
        If there is no such zone.

    Examples
    --------
    >>> to_metres([52.489175], [13.298339], "33U").round(2).tolist()
    [[384462.04, 5816809.06]]
    """
    import utm

    number, letter = parse_zone(zone)
    # Arrays, even of one element: the package takes nothing else for a column.
    north, east = (np.asarray(column, dtype=np.float64).reshape(-1) for column in (latitude, longitude))
    _check(north, east, number, letter)
    if len(north) == 0:
        return np.empty((0, 2))
    # Number and letter are forced: the package would take both from the first position.
    easting, northing, _, _ = utm.from_latlon(north, east, force_zone_number=number, force_zone_letter=letter)
    return np.stack([easting, northing], axis=1)


def zone_of(latitude: float, longitude: float) -> str:
    """Name the UTM zone of a position.

    Raises
    ------
    PositionError
        If it is not finite, not on earth, or (0, 0).

    Examples
    --------
    >>> zone_of(52.5, 13.3), zone_of(-27.5, 153.0)
    ('33U', '56J')
    """
    import utm

    _check(np.array([latitude], dtype=np.float64), np.array([longitude], dtype=np.float64))
    return f"{utm.latlon_to_zone_number(latitude, longitude)}{utm.latitude_to_zone_letter(latitude)}"


def parse_zone(zone: object) -> tuple[int, str]:
    """Take a zone apart.

    Raises
    ------
    DataError
        If it is none.

    Examples
    --------
    >>> parse_zone("33U")
    (33, 'U')
    """
    found = _ZONE.fullmatch(zone.strip().upper()) if isinstance(zone, str) else None
    if found is None:
        raise DataError(
            f"The zone must be a UTM zone, its number with the letter of its latitude band: 33U. Got {zone!r} instead."
        )
    return int(found[1]), found[2]


def is_northern(letter: str) -> bool:
    """Say whether a latitude band is north of the equator."""
    return letter >= "N"


def _check(
    north: NDArray[np.float64], east: NDArray[np.float64], number: int | None = None, letter: str | None = None
) -> None:
    """Refuse the first position that has something wrong, and say what."""
    checks = [
        (~(np.isfinite(north) & np.isfinite(east)), "is not a position"),
        ((north == 0) & (east == 0), "means that the receiver had no fix"),
        ((north < -80) | (north > 84), "is out of range: the latitude must lie between -80 and 84"),
        (np.abs(east) > 180, "is out of range: the longitude must lie between -180 and 180"),
    ]
    if number is not None and letter is not None:
        named = f"the zone {number}{letter}"
        signed = north if is_northern(letter) else -north
        half = "north" if is_northern(letter) else "south"
        with np.errstate(invalid="ignore"):  # infinity, which is refused above
            away = np.abs((east - _central(number) + 180) % 360 - 180)
        checks += [
            (signed < -_AROUND_EQUATOR, f"is not in {named}, {half} of the equator: the latitude's sign looks wrong"),
            (away > _FARTHEST, f"is more than {_FARTHEST:g} degrees of longitude from the middle of {named}"),
        ]
    wrong = np.any([mask for mask, _ in checks], axis=0)
    if wrong.any():
        row = int(np.argmax(wrong))
        why = next(text for mask, text in checks if mask[row])
        raise PositionError(f"({north[row]:.10g}, {east[row]:.10g}) {why}", row, int(wrong.sum()))


def _central(number: int) -> int:
    """Return the longitude of a zone's central meridian, in degrees."""
    return 6 * number - 183
