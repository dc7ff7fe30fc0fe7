"""Tables of images and their positions, as a spreadsheet saves them."""

import csv
import io
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path, PurePosixPath

from vpr_bench.errors import DataError, one_line
from vpr_datasets.layouts.table_header import NEEDED, Columns, find_columns
from vpr_datasets.layouts.texts import parse_number, quoted, read_text

_PEEK = 20
"""Rows in which an image must be found for a file to be taken for a table of images."""


@dataclass(frozen=True)
class Row:
    """One line of a table.

    Attributes
    ----------
    line : int
        In the file, from 1.
    image : str
        Path inside the table's folder, with ``/``.
    traverse : str
        To which the image belongs; by default the first folder of its path.
    position : (float, float)
        Metres east and north, or latitude and longitude in degrees.
    compass : float or None
        Degrees.
    """

    line: int
    image: str
    traverse: str
    position: tuple[float, float]
    compass: float | None


@dataclass(frozen=True)
class Table:
    """A table that was read and found to be sound; the images need not exist.

    Attributes
    ----------
    rows : list of Row
        In the order of the file.
    degrees : bool
        Positions are latitude and longitude.
    """

    rows: list[Row]
    degrees: bool


def is_table(file: Path) -> bool:
    """Say whether a file has the header of such a table, and an image of its first rows lies beside it."""
    try:
        header, _, text = read_text(file).partition("\n")
        found = find_columns(header)
        if found is None:
            return False
        rows = islice(csv.reader(io.StringIO(text), delimiter=found[0]), _PEEK)
        return any(_is_beside(file, cells[found[1].image]) for cells in rows if len(cells) > found[1].image)
    except (DataError, csv.Error):
        return False


def _is_beside(file: Path, written: str) -> bool:
    try:
        return (file.parent / _image(written.strip())).is_file()
    except (OSError, ValueError):
        return False


def read_table(file: Path) -> Table:
    """Read a table with a header; cells are separated by comma, semicolon or tab.

    Raises
    ------
    DataError
        If it is no such table, or a line is wrong: names the line.
    """
    text = read_text(file)
    header = text.partition("\n")[0]
    found = find_columns(header)
    if found is None:
        raise DataError(f"{file} must have a header with {NEEDED}. Found {quoted(header)} instead.")
    separator, columns = found
    rows: list[Row] = []
    seen: dict[str, int] = {}
    for line, cells in _lines(file, text, separator):
        try:
            row = _row(line, cells, columns)
        except ValueError as error:
            raise DataError(f"{file}, line {line}: {error}. Correct the table.") from None
        if row.image in seen:
            raise DataError(f"{file}, line {line}: {quoted(row.image)} is in line {seen[row.image]} already.")
        seen[row.image] = line
        rows.append(row)
    if not rows:
        raise DataError(f"{file} has a header and no images.")
    return Table(rows, columns.degrees)


def _lines(file: Path, text: str, separator: str) -> Iterator[tuple[int, list[str]]]:
    """Yield the rows below the header with their line numbers; empty lines are passed by."""
    reader = csv.reader(io.StringIO(text), delimiter=separator, strict=True)
    try:
        next(reader)
        for cells in reader:
            if any(cell.strip() for cell in cells):
                yield reader.line_num, cells
    except csv.Error as error:
        raise DataError(f"{file}, line {reader.line_num}: {one_line(error)}. Correct the table.") from None


def _row(line: int, cells: list[str], columns: Columns) -> Row:
    if len(cells) != columns.width:
        raise ValueError(
            f"found {len(cells)} cells, but the header has {columns.width} "
            "(a name that holds the separator must be in quotes)"
        )
    image = _image(cells[columns.image].strip())
    compass = None if columns.compass is None else parse_number(cells[columns.compass])
    traverse = image.parts[0] if columns.traverse is None else cells[columns.traverse].strip()
    if columns.traverse is None and len(image.parts) == 1:
        raise ValueError(f"the image {quoted(str(image))} lies in no folder, so that a column traverse is needed")
    if not traverse:
        raise ValueError("the traverse is missing")
    east, north = (parse_number(cells[column]) for column in columns.position)
    return Row(line, image.as_posix(), traverse, (east, north), compass)


def _image(written: str) -> PurePosixPath:
    if not written:
        raise ValueError("the image is missing")
    path = PurePosixPath(written.replace("\\", "/"))
    if path.is_absolute() or ".." in path.parts or not path.parts or "\0" in written:
        raise ValueError(f"the path {quoted(written)} leads out of the folder")
    return path
