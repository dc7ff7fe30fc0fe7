"""``results.csv``: the rows that a leaderboard is made from, and its only source."""

import csv
import io
import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from vpr_bench.errors import DataError, closest, one_line
from vpr_bench.files.atomic import write_bytes
from vpr_bench.files.disk import disk_errors
from vpr_bench.leaderboard.columns import HEADER, SCHEMA, SCHEMA_COLUMN, as_values, digest_of, read_row, write_row
from vpr_bench.leaderboard.entry import Cell, Entry
from vpr_bench.metrics.undefined import or_none
from vpr_bench.report.foreign import shortened
from vpr_bench.types.protocol import Protocol

RESULTS = "results.csv"

_CONFLICT = ("<<<<<<<", "|||||||", "=======", ">>>>>>>")
_RESTORE = "Restore the file from where it was committed"


def read_results(path: Path) -> list[Entry]:
    """Read all rows, and check each against its digest.

    Raises
    ------
    DataError
        If the file is missing or holds anything that this program did not write; names the line.
    """
    if path.is_dir():
        raise DataError(
            f"{path} is a folder, where the file of the rows belongs. Move it away, or give another --output."
        )
    if not path.is_file():
        raise DataError(f"There is no {path}. `vpr-bench leaderboard` makes it from stored runs.")
    with disk_errors(path, "read"):
        content = path.read_bytes()
    try:
        text = content.decode()
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise DataError(f"{path}, line {line}: not UTF-8. {_RESTORE}.") from None
    try:
        return _parse(text)
    except DataError as error:
        raise DataError(f"{path}, {error}") from None


def write_results(path: Path, entries: Sequence[Entry]) -> None:
    """Write all rows, in place of those that are there.

    Raises
    ------
    DataError
        If the disk refuses.
    """
    write_bytes(path, to_csv(entries).encode())


def is_written(path: Path, entries: Sequence[Entry]) -> bool:
    """Say whether the file holds just these rows, in their order; how version control ends lines does not matter."""
    if not path.is_file():
        return False
    with disk_errors(path, "read"):
        return _unix(path.read_bytes()) == _unix(to_csv(entries).encode())


def _unix(content: bytes) -> bytes:
    return content.replace(b"\r\n", b"\n")


def to_json(entries: Iterable[Entry]) -> str:
    """Write rows as a JSON array of objects, one member per column; what is undefined or not known is null."""
    rows = [as_values(entry) for entry in sorted(entries, key=_order)]
    plain = [{name: _jsonable(value) for name, value in row.items()} for row in rows]
    return json.dumps(plain, indent=2, ensure_ascii=False, allow_nan=False)


def _jsonable(value: Any) -> Any:
    if isinstance(value, Protocol):
        return str(value)
    return or_none(value) if isinstance(value, float) else value


def to_csv(entries: Iterable[Entry]) -> str:
    """Return what ``results.csv`` holds: rows by protocol, method and machine, whatever order they come in."""
    rows = [write_row(entry) for entry in sorted(entries, key=_order)]
    return "".join(_line(cells) for cells in (HEADER, *rows))


def _line(cells: Sequence[str]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\r\n").writerow(cells)  # so that a cell with either mark in it is quoted
    return text.getvalue().removesuffix("\r\n") + "\n"


def _order(entry: Entry) -> tuple[str, str, str]:
    return str(entry.protocol), entry.method, entry.machine


def _parse(text: str) -> list[Entry]:
    """Read the whole file; every error begins with its line."""
    (_, header), *rows = _lines(text) or [(1, [])]
    if header[:1] != [SCHEMA_COLUMN]:
        raise DataError(
            f"line 1: the first column is {(header or [''])[0][:40]!r} and not {SCHEMA_COLUMN!r}: this is no file of a "
            "leaderboard. Move it away, or give another --output."
        )
    for number, cells in rows:
        if cells[:1] != [str(SCHEMA)]:
            raise DataError(
                f"line {number}: schema {(cells or [''])[0][:20]!r}; this vpr-bench reads {SCHEMA}. "
                f"If a newer one wrote it, update vpr-bench. Else: {_RESTORE}."
            )
    _check_header(header)
    entries: list[Entry] = []
    seen: dict[Cell, int] = {}
    for number, cells in rows:
        entry = _read_line(number, cells)
        if entry.cell in seen:
            raise DataError(
                f"line {number}: {shortened(entry.method)} on {entry.protocol} and machine {entry.machine} stands in "
                f"line {seen[entry.cell]} already. Delete one of the two rows."
            )
        seen[entry.cell] = number
        entries.append(entry)
    return entries


def _lines(text: str) -> list[tuple[int, list[str]]]:
    """Take the text apart: each row with the line that it begins in."""
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    rows: list[tuple[int, list[str]]] = []
    number = 1
    try:
        for cells in reader:
            if cells and cells[0].startswith(_CONFLICT):
                raise DataError(
                    f"line {number}: {cells[0][:20]!r} is the mark of a merge conflict. Keep the rows of both sides "
                    "without the marks, and `vpr-bench leaderboard` makes the tables anew."
                )
            rows.append((number, cells))
            number = reader.line_num + 1
    except csv.Error as error:
        raise DataError(f"line {number}: not CSV: {error}. {_RESTORE}.") from None
    return rows


def _check_header(header: list[str]) -> None:
    if header == HEADER:
        return
    unknown = [name for name in header if name not in HEADER]
    missing = [name for name in HEADER if name not in header]
    if unknown:
        found = f"an unknown column {unknown[0][:40]!r}. {closest(unknown[0], missing or HEADER)}"
    elif missing:
        found = f"no column {missing[0]!r}."
    else:
        found = "the columns stand in another order, or twice."
    raise DataError(f"line 1: {found} {_RESTORE}.")


def _read_line(number: int, cells: list[str]) -> Entry:
    if len(cells) != len(HEADER):
        raise DataError(f"line {number}: {len(cells)} cells instead of {len(HEADER)}. {_RESTORE}.")
    try:
        entry = read_row(dict(zip(HEADER, cells, strict=True)))
    except ValueError as error:
        raise DataError(f"line {number}: {one_line(error)}. {_RESTORE}, or delete the row.") from None
    if cells[-1] != digest_of(cells[:-1]):
        raise DataError(
            f"line {number}: the row of {shortened(entry.method)} was changed after it was written: its digest is not "
            f"that of its cells. {_RESTORE}, or delete the row and collect its run again."
        )
    return entry
