"""The lines of the CSV files beside this one, and how their values are written in the cells of tables."""

import csv
from pathlib import Path

from vpr_bench.report.numbers import bounds, short_share

HERE = Path(__file__).parent

Line = dict[str, str]


def read(name: str) -> list[Line]:
    """Read a table of results, empty if it is not there."""
    path = HERE / name
    if not path.exists():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def called(line: Line) -> str:
    """Name the method of a line, with what was set."""
    return line["variant"].split(" ", 1)[1].replace("()", "").replace("n_components=99", "all components")


def settings(line: Line) -> str:
    """Write what was set as on the command line, one setting after the other."""
    given = line["variant"].split("(", 1)[1].removesuffix(")")
    return ", ".join(f"`{one}`" for one in given.split(", ") if one)


def number(line: Line, name: str) -> str:
    """Write a number of a line with three decimals."""
    return short_share(float(line[name] or "nan"))


def with_bounds(line: Line, name: str) -> str:
    """Write a number of a line with its 95 % interval."""
    return f"{number(line, name)} ({bounds(*(float(line[f'{name}_{end}']) for end in ('low', 'high')))})"


def signed(line: Line, name: str) -> str:
    """Write a difference of a line with its 95 % interval."""
    value, low, high = (float(line[f"{name}{end}"]) for end in ("", "_low", "_high"))
    return f"{value:+z.3f} ({low:+z.3f} to {high:+z.3f})"
