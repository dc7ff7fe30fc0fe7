"""What a camera writes into the header of a photograph: where, when and in which direction it was taken."""

import math
import re
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from vpr_bench.errors import DataError, one_line
from vpr_bench.files.disk import disk_errors

_FORMATS = ("JPEG", "PNG", "TIFF")
_GPS, _DETAILS = 0x8825, 0x8769  # where the header's two tables begin
_LATITUDE, _LONGITUDE, _DIRECTION = 2, 4, 17
_TAKEN, _FRACTION = 0x9003, 0x9291  # DateTimeOriginal, SubSecTimeOriginal
_DATE = re.compile(r"[0-9]{4}:[0-9]{2}:[0-9]{2} [0-9]{2}:[0-9]{2}:[0-9]{2}")


@dataclass(frozen=True)
class Photograph:
    """What the header says.

    Attributes
    ----------
    latitude, longitude : float
        In degrees, south and west negative; NaN where the header has no fix.
    direction : float
        Degrees clockwise from north (true or magnetic, as the camera knows it), NaN where it has none.
    taken : str
        Date and time, such that earlier ones sort first; empty where it has none.
    """

    latitude: float = math.nan
    longitude: float = math.nan
    direction: float = math.nan
    taken: str = ""


def read_header(file: Path) -> Photograph:
    """Read a photograph's header. Its pixels are never decoded, however many it claims to have.

    Raises
    ------
    DataError
        If it is no JPEG, PNG or TIFF, or its header is damaged.
    """
    from PIL import Image

    with disk_errors(file, "read"), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of large images and odd headers: what is needed is checked below
        try:
            with Image.open(file, formats=_FORMATS) as image:
                # Pillow decodes a whole PNG to look for a header behind its pixels: only one before them is taken.
                if image.format == "PNG" and "exif" not in image.info:
                    return Photograph()
                header = image.getexif()
                return _photograph(header.get_ifd(_GPS), header.get_ifd(_DETAILS))
        except Image.DecompressionBombError as error:
            raise DataError(f"{file} is refused as an image bomb: {one_line(error)}") from None
        except OSError as error:
            if error.errno is not None:
                raise
            raise DataError(f"{file} is no photograph (known: {', '.join(_FORMATS)})") from None
        except Exception as error:  # whatever a damaged header makes Pillow's parsers raise
            raise DataError(f"{file} has a damaged header: {one_line(error)}") from None


def _photograph(gps: Mapping[int, Any], details: Mapping[int, Any]) -> Photograph:
    latitude = _degrees(gps.get(_LATITUDE)) * _sign(gps.get(_LATITUDE - 1), "NS")
    longitude = _degrees(gps.get(_LONGITUDE)) * _sign(gps.get(_LONGITUDE - 1), "EW")
    if math.isnan(latitude + longitude):
        latitude = longitude = math.nan
    taken, fraction = _text(details.get(_TAKEN)), _text(details.get(_FRACTION))
    known = _DATE.fullmatch(taken) is not None and not taken.startswith("0000")
    return Photograph(
        latitude,
        longitude,
        _rational(gps.get(_DIRECTION)),
        f"{taken}.{fraction if fraction.isdigit() else ''}" if known else "",
    )


def _degrees(written: Any) -> float:
    """Add up degrees, minutes and seconds; some programs write degrees alone. NaN where it is none of these."""
    parts = [_rational(part) for part in (written if isinstance(written, tuple | list) else (written,))]
    if not 1 <= len(parts) <= 3 or not all(part >= 0 for part in parts) or any(part > 60 for part in parts[1:]):
        return math.nan
    return math.fsum(part / 60.0**power for power, part in enumerate(parts))


def _sign(written: Any, marks: str) -> float:
    """Return 1 for north and east and -1 for south and west, NaN where the header does not say."""
    mark = _text(written).upper()
    return {marks[0]: 1.0, marks[1]: -1.0}.get(mark, math.nan)


def _rational(written: Any) -> float:
    try:
        value = float(written)
    except (TypeError, ValueError, ArithmeticError):
        return math.nan
    return value if math.isfinite(value) else math.nan


def _text(written: Any) -> str:
    text = written.decode("ascii", "replace") if isinstance(written, bytes) else written
    return text.strip(" \0") if isinstance(text, str) else ""
