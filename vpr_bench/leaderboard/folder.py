"""The folder of a leaderboard: the tables that belong in it, made from the rows alone."""

import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path, PurePosixPath

from vpr_bench.errors import DataError
from vpr_bench.files.atomic import write_bytes
from vpr_bench.files.disk import disk_errors
from vpr_bench.leaderboard.board_page import board_page
from vpr_bench.leaderboard.machines import machine_letters
from vpr_bench.leaderboard.overview import overview_page
from vpr_bench.leaderboard.standing import Board
from vpr_bench.types.protocol import Protocol

OVERVIEW = "README.md"
MADE_BY_US = "<!-- Made by `vpr-bench leaderboard` from results.csv: what is changed here is lost. -->"
_LONGEST = 150  # characters of a file's name; file systems allow 255 bytes


def table_name(protocol: Protocol) -> str:
    """Return where the table of a protocol lies in the folder; its name always has an ``@`` in it.

    Examples
    --------
    >>> table_name(Protocol("gardens", "day_left", "night_right", 2, "f", "simulated"))
    'gardens.simulated/day_left-night_right@2f.md'
    """
    folder, _, name = str(protocol).replace(":", ".").partition("/")
    if len(name) > _LONGEST:
        name = f"{name[:_LONGEST]}@{hashlib.sha256(name.encode()).hexdigest()[:12]}"
    return f"{folder}/{name}.md"


def tables(boards: Sequence[Board]) -> dict[str, str]:
    """Return every Markdown file that belongs in the folder, by its name in it."""
    letters = machine_letters(one.entry for board in boards for one in board.standings)
    pages = {str(board.protocol): table_name(board.protocol) for board in boards}
    files = {OVERVIEW: overview_page(boards, letters, pages)}
    for board in boards:
        name = pages[str(board.protocol)]
        files[name] = board_page(board, letters, str(PurePosixPath("..", OVERVIEW)))
    return {name: f"{MADE_BY_US}\n\n{text}" for name, text in files.items()}


def stale_tables(root: Path, files: Mapping[str, str]) -> list[Path]:
    """Return the tables that are missing, that say something else, or that no protocol has any more."""
    changed = [root / name for name, text in files.items() if _text(root / name) != text]
    return sorted([*changed, *_leftovers(root, files)])


def check_room(root: Path, files: Mapping[str, str]) -> None:
    """Refuse to write over what somebody else wrote.

    Raises
    ------
    DataError
        If a file in the way of a table is none of ours.
    """
    for name in files:
        text = _text(root / name)
        if text is not None and not _is_ours(text):
            raise DataError(
                f"{root / name} was not made by `vpr-bench leaderboard`, and a table belongs there. "
                "Move it away, or give another --output."
            )


def write_tables(root: Path, files: Mapping[str, str]) -> None:
    """Write every table that is not as it should be, and remove those that no protocol has any more.

    Raises
    ------
    DataError
        As :func:`check_room`, or if the disk refuses.
    """
    check_room(root, files)
    for name, text in files.items():
        path = root / name
        if _text(path) != text:
            with disk_errors(path.parent):
                path.parent.mkdir(parents=True, exist_ok=True)
            write_bytes(path, text.encode())
    for path in _leftovers(root, files):
        with disk_errors(path):
            path.unlink()
            if not any(path.parent.iterdir()):
                path.parent.rmdir()


def _leftovers(root: Path, files: Mapping[str, str]) -> list[Path]:
    """Return tables of ours that no protocol has; the overview of another leaderboard, a folder below, is none."""
    expected = {root / name for name in files}
    there = [path for path in root.glob("*/*@*.md") if path not in expected]
    return [path for path in there if _is_ours(_text(path))]


def _text(path: Path) -> str | None:
    """Return what a file says, whichever line ends a version control gave it; None if there is none."""
    if not path.exists():
        return None
    with disk_errors(path, "read"):
        return path.read_text("utf-8", errors="replace")


def _is_ours(text: str | None) -> bool:
    return text is not None and text.startswith(MADE_BY_US + "\n")
