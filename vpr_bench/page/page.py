"""The page: all protocols of a leaderboard in one HTML file."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING

import vpr_bench
from vpr_bench.errors import DataError, one_line
from vpr_bench.files.atomic import write_bytes
from vpr_bench.files.disk import disk_errors
from vpr_bench.leaderboard.entry import moment
from vpr_bench.leaderboard.machines import machine_letters, machine_names
from vpr_bench.leaderboard.standing import Board
from vpr_bench.page.album import Album
from vpr_bench.page.gallery import Galleries
from vpr_bench.page.libraries import Library, chart_library, script_digest, table_library
from vpr_bench.page.looks import looks
from vpr_bench.page.ranking import COLUMNS
from vpr_bench.page.section import Section, section
from vpr_bench.progress import track
from vpr_bench.runner.store import StoredRun

if TYPE_CHECKING:
    from jinja2 import Environment

LIMIT = 7_800_000
"""Bytes that a page may take; pictures are made as small as it takes, down to ``LEAST`` for all of them."""

LEAST = 500_000

_MARK = b'<meta name="generator" content="vpr-bench leaderboard '
_HEAD = 4096  # bytes of a page that hold the mark

_SCRIPTS = ("unpack", "sections", "tables", "legend", "charts", "gallery", "start")


def check_room(file: Path) -> None:
    """Refuse to write a page over what somebody else wrote.

    Raises
    ------
    DataError
        If the file is there, and is no page of a leaderboard.
    """
    if not file.exists():
        return
    with disk_errors(file, "read"), file.open("rb") as opened:
        head = opened.read(_HEAD)
    if _MARK not in head:
        raise DataError(
            f"{file} was not made by `vpr-bench leaderboard`, and the page belongs there. "
            "Move it away, give another --output, or make no page with --no-page."
        )


def write_page(boards: Sequence[Board], runs: Mapping[str, StoredRun], file: Path, warn: Callable[[str], None]) -> Path:
    """Write a leaderboard as one HTML file, which needs no network and no other file.

    The same boards, runs and images give the same bytes.

    Parameters
    ----------
    boards : sequence of Board
        Each becomes a section, in their order; at least one.
    runs : mapping of StoredRun
        By their 12 digits: those whose curves and pictures can be shown.
    file : Path
        Where to write.
    warn : callable
        Told in one line what cannot be shown.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    DataError
        As :func:`check_room`; or if a run is damaged, a package that the page takes its JavaScript from is not as
        expected, or the file cannot be written.
    """
    check_room(file)
    entries = [one.entry for board in boards for one in board.standings]
    machines, drawn = machine_letters(entries), looks(one.method for one in entries)
    album = Album()
    galleries = Galleries(album, warn)
    sections = [section(board, runs, machines, drawn, galleries) for board in track(boards, "Drawing protocols")]
    newest = max(entries, key=lambda one: moment(one.created))
    about = machine_names(entries)
    page = _Page(sections, {machines[one]: one_line(about[one]) for one in machines}, newest.created)
    room = max(LEAST, LIMIT - len(page.html({}).encode()))
    pictures = album.embedded(room)
    if len(pictures) < len(album):
        warn(f"{file.name} shows {len(pictures)} of {len(album)} pictures: the others are not here, or did not fit.")
    write_bytes(file, page.html(pictures).encode())
    return file


@dataclass(frozen=True)
class _Page:
    sections: list[Section]
    machines: dict[str, str]
    created: str

    def html(self, pictures: Mapping[int, tuple[int, int, str]]) -> str:
        """Write the page with some pictures."""
        libraries: list[Library] = [table_library(), chart_library()]
        scripts = {"theme": asset("theme.js"), "page": _script()}
        digests = [*map(script_digest, scripts.values()), *(library.digest for library in libraries)]
        template = _environment().get_template("page.html.j2")
        return template.render(
            sections=self.sections,
            machines=self.machines,
            date=self.created[:10],
            version=vpr_bench.__version__,
            columns=COLUMNS,
            style=asset("page.css"),
            dark=asset("dark.css"),
            scripts=scripts,
            digests=digests,
            libraries=dict(zip(("tables", "charts"), libraries, strict=True)),
            pictures=pictures,
        )


@cache
def asset(name: str) -> str:
    """Return one of the page's own style sheets and scripts."""
    return (files("vpr_bench.page") / "assets" / name).read_text("utf-8")


def _script() -> str:
    """Return the page's own script, whose parts share one scope."""
    parts = "\n".join(asset(f"{name}.js") for name in _SCRIPTS)
    return f'(() => {{\n"use strict";\n{parts}}})();'


@cache
def _environment() -> "Environment":
    from jinja2 import Environment, PackageLoader, StrictUndefined
    from markupsafe import Markup

    from vpr_bench.page.embedding import as_json, breakable
    from vpr_bench.report.foreign import shortened

    environment = Environment(
        loader=PackageLoader("vpr_bench.page"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {"json": as_json, "breakable": breakable, "shortened": shortened}
    environment.filters["ours"] = Markup  # for what this package brings: its style sheet and scripts
    return environment
