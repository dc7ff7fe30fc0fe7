"""The overview: which method reached which recall@1 on which protocol, and no averages."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from vpr_bench.leaderboard.machines import machine_names
from vpr_bench.leaderboard.markdown import link
from vpr_bench.leaderboard.marks import TIED, name_marks, name_notes
from vpr_bench.leaderboard.standing import Board, Standing
from vpr_bench.report.foreign import plain, shortened
from vpr_bench.report.grid import Grid, markdown_table
from vpr_bench.report.numbers import share

_REAL, _SIMULATED = "Real images", "Simulated images"
_NOT_REAL = "Rendered by vpr-bench: these numbers say nothing about the real datasets."
_ROOM = 56  # columns for protocols in a window of 80, beside the names of the methods

_READING = """\
Each number is `recall@1`: the share of the queries whose first answer is the right place. **Bold** is the best of its
column, and every one that is not significantly different from it. A column is a protocol and links to its table, with
intervals, areas and latencies; numbers of different columns do not compare, so there are no averages. Where there is no
number, nobody has measured it on all queries.

Everything here is made from [results.csv](results.csv) by `vpr-bench leaderboard`."""


def overview_page(boards: Sequence[Board], letters: Mapping[str, str], pages: Mapping[str, str]) -> str:
    """Write the overview as Markdown.

    Parameters
    ----------
    boards : sequence of Board
        All protocols.
    letters : dict
        Machine fingerprint to letter.
    pages : dict
        Protocol id to the file of its table, from the overview.
    """
    parts = ["# Leaderboard", _READING]
    for title, same in _sections(boards):
        parts += [f"## {title}", _NOT_REAL] if title == _SIMULATED else [f"## {title}"]
        heads = [link(f"`{board.protocol}`", pages[str(board.protocol)]) for board in same]
        parts.append(markdown_table(["method", *heads], _rows(same, plain, lambda value: f"**{value}**")))
    entries = [one.entry for board in boards for one in board.standings]
    parts += name_notes(entries)
    names = machine_names(entries)
    legend = [f"- {letter}: {plain(names[machine])} (`{machine}`)" for machine, letter in letters.items()]
    return "\n\n".join([*parts, "## Machines", "\n".join(legend)]) + "\n"


def overview_grids(boards: Sequence[Board]) -> list[Grid]:
    """Lay the overview out for a terminal, a few protocols beside each other."""
    grids = [grid for title, same in _sections(boards) for grid in _grids(title, _parts(same))]
    notes = [f"`{TIED}` the best of its column, or not significantly different from it."]
    notes += name_notes([one.entry for board in boards for one in board.standings])
    note = "\n".join(notes).replace("`", "")
    return [*grids[:-1], *(replace(last, note=note) for last in grids[-1:])]


def _grids(title: str, parts: Sequence[Sequence[Board]]) -> Iterator[Grid]:
    for number, part in enumerate(parts, 1):
        which = f" ({number} of {len(parts)})" if len(parts) > 1 else ""
        rows = _rows(part, str, lambda value: f"{value} {TIED}")
        yield Grid(f"{title}: recall@1{which}", ["method", *map(_head, part)], rows)


def _head(board: Board) -> str:
    """Break a protocol's id into lines."""
    source, _, rest = str(board.protocol).partition("/")
    queries = rest.removeprefix(f"{board.protocol.references}-")
    return "\n".join([*source.replace(":", ":\n").splitlines(), f"{board.protocol.references}-", queries])


def _parts(boards: Sequence[Board]) -> list[list[Board]]:
    """Put together what fits beside each other in a terminal."""
    parts: list[list[Board]] = []
    room = 0
    for board in boards:
        width = max(map(len, _head(board).splitlines())) + 2
        if not parts or width > room:
            parts.append([])
            room = _ROOM
        parts[-1].append(board)
        room -= width
    return parts


def _sections(boards: Sequence[Board]) -> list[tuple[str, list[Board]]]:
    real = [board for board in boards if not board.simulated]
    simulated = [board for board in boards if board.simulated]
    return [(title, same) for title, same in ((_REAL, real), (_SIMULATED, simulated)) if same]


def _rows(boards: Sequence[Board], name: Callable[[str], str], best: Callable[[str], str]) -> list[list[str]]:
    methods = {one.entry.method: name_marks(one.entry) for board in boards for one in board.standings}
    columns = [{one.entry.method: one for one in reversed(board.standings)} for board in boards]
    return [
        [name(shortened(method)) + methods[method], *(_cell(column.get(method), best) for column in columns)]
        for method in sorted(methods)
    ]


def _cell(one: Standing | None, best: Callable[[str], str]) -> str:
    if one is None or one.rank is None:
        return ""
    value = share(one.entry.metrics["recall@1"].value)
    return best(value) if one.tied else value
