"""The name of an image file that says where it was taken: ``@UTM_east@UTM_north@….jpg``."""

import math
from dataclasses import dataclass

from vpr_datasets.layouts.metres import is_northern
from vpr_datasets.layouts.texts import parse_number


@dataclass(frozen=True)
class Name:
    """What a file's name says.

    Attributes
    ----------
    east, north : float
        Metres.
    zone : str
        Zone number and hemisphere, ``33N``; empty where the name has none.
    heading : float
        Degrees clockwise from north, NaN where the name has none.
    """

    east: float
    north: float
    zone: str = ""
    heading: float = math.nan


def parse_name(name: str) -> Name:
    """Read a file's name. Only the first two fields must be filled.

    Raises
    ------
    ValueError
        If they are not there, or are no numbers.

    Examples
    --------
    >>> parse_name("@0@00002.3@@@@@1@@@@@@@@.jpg")
    Name(east=0.0, north=2.3, zone='', heading=nan)
    """
    before, *fields = name.split("@")[:-1] or [name]
    if before or len(fields) < 2:
        raise ValueError("the name is not like @UTM_east@UTM_north@.jpg")
    fields += [""] * 9
    return Name(parse_number(fields[0]), parse_number(fields[1]), _zone(fields[2], fields[3]), _heading(fields[8]))


def _zone(number: str, letter: str) -> str:
    """Write a zone so that two are equal if their metres can be compared; bands of latitude do not matter for that."""
    hemisphere = ("N" if is_northern(letter.upper()) else "S") if len(letter) == 1 else letter
    return f"{number.lstrip('0')}{hemisphere}"


def _heading(text: str) -> float:
    try:
        return parse_number(text)
    except ValueError:
        return math.nan
