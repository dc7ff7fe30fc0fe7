"""Text files of unknown origin, and the numbers in them."""

import math
import re
from pathlib import Path

from vpr_bench.errors import DataError
from vpr_bench.files.disk import disk_errors

LARGEST = 64_000_000
"""Bytes: a larger text file is not read. It is a million lines, ten hours of video."""

_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")


def read_text(file: Path) -> str:
    r"""Read a UTF-8 file, with or without a byte order mark; all ends of lines become ``\n``.

    Raises
    ------
    DataError
        If it is missing, not a file, too large, or of another encoding.
    """
    with disk_errors(file, "read"):
        if not file.is_file():  # a pipe would never end
            raise DataError(f"The file {file} is missing. Restore it, or fetch the dataset again.")
        size = file.stat().st_size
        if size > LARGEST:
            raise DataError(f"{file} is refused: it has {size:,} bytes, more than the {LARGEST:,} that are read.")
        content = file.read_bytes()
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise DataError(f"{file} is not UTF-8 text (at byte {error.start:,}). Save it as UTF-8.") from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def parse_number(text: str) -> float:
    """Read a finite decimal number, as people and receivers write one: no ``nan``, ``inf`` or ``1_000``.

    Raises
    ------
    ValueError
        If it is something else; the message says what was found.

    Examples
    --------
    >>> parse_number(" -27.5"), parse_number("0500987.81")
    (-27.5, 500987.81)
    """
    value = float(text) if _NUMBER.fullmatch(text.strip()) else math.nan
    if not math.isfinite(value):
        raise ValueError(f"{quoted(text)} is not a number")
    return value


def quoted(text: object) -> str:
    """Write a foreign value for a message: on one line, in quotes if it is text, and not too long."""
    written = repr(text)
    return written if len(written) <= 60 else f"{written[:57]}…"
