"""New runs among the rows that are there: which are new, which replace others, which stay."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from vpr_bench.errors import DamagedError, VprBenchError
from vpr_bench.leaderboard.collect import cell_of, collect
from vpr_bench.leaderboard.entry import Cell, Entry, Precedence, precedence
from vpr_bench.leaderboard.protocols import protocols_of, serves
from vpr_bench.progress import track
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol

Told = Callable[[VprBenchError], None]
Candidate = tuple[StoredRun, Protocol]
Guard = Callable[[StoredRun], AbstractContextManager[None]]
"""Around what is done with a run: if that fails, the run is left out."""


@dataclass(frozen=True)
class Merge:
    """What became of the rows.

    Attributes
    ----------
    entries : list of Entry
        All rows there are now.
    new : list of Entry
        Rows of cells that had none.
    replaced : list of Entry
        Rows that stand for another run than before.
    kept : list of Entry
        Rows as they were.
    dropped : list of Entry
        Rows of some of the queries, of methods that have now been asked all.
    """

    entries: list[Entry]
    new: list[Entry]
    replaced: list[Entry]
    kept: list[Entry]
    dropped: list[Entry]


def merge(existing: Sequence[Entry], runs: Sequence[StoredRun], leave_out: Told | None = None) -> Merge:
    """Add the rows of runs to those there are.

    Of one cell, a complete run comes before a partial one, then the one that kept more answers (``k``), then the
    newer one. Only runs that bring a row are scored. A run has a row on each of
    :func:`~vpr_bench.leaderboard.protocols.protocols_of` that its places say anything about.

    Parameters
    ----------
    existing : sequence of Entry
        One per cell.
    runs : sequence of StoredRun
        In any order; of those of one cell only the first by the rule above counts.
    leave_out : callable, optional
        Told of a run that cannot be scored, which is then left out; by default the error is raised.

    Raises
    ------
    VprBenchError
        If a run cannot be scored.
    """
    held = {entry.cell: entry for entry in existing}
    found: dict[Cell, Entry] = {}
    failed: set[Path] = set()
    guard = partial(_leaving_out, leave_out, failed)
    for run, protocol in track(_wanted(held, runs, guard), "Scoring"):
        with guard(run):
            if run.folder not in failed:
                found[cell_of(run, protocol)] = collect(run, protocol)
    rows = {**held, **found}
    whole = _whole({cell: entry.partial for cell, entry in rows.items()})
    stay = {cell: entry for cell, entry in rows.items() if not entry.partial or cell[:2] not in whole}
    return Merge(
        entries=list(stay.values()),
        new=[entry for cell, entry in found.items() if cell in stay and cell not in held],
        replaced=[entry for cell, entry in found.items() if cell in stay and cell in held],
        kept=[entry for cell, entry in held.items() if cell in stay and cell not in found],
        dropped=[entry for cell, entry in held.items() if cell not in stay],
    )


def _wanted(held: Mapping[Cell, Entry], runs: Sequence[StoredRun], guard: Guard) -> list[Candidate]:
    """Return the runs whose rows are to be made; partial ones only of methods that nobody has asked everything."""
    best = _best(held, runs, guard)
    rows = {cell: entry.partial for cell, entry in held.items()}
    whole = _whole(rows | {cell: run.record.partial for cell, (run, _) in best.items()})
    return [one for cell, one in best.items() if not one[0].record.partial or cell[:2] not in whole]


def _best(held: Mapping[Cell, Entry], runs: Sequence[StoredRun], guard: Guard) -> dict[Cell, Candidate]:
    """Return the best run of each cell, where it comes before the row there is."""
    first = {cell: entry.precedence for cell, entry in held.items()}
    best: dict[Cell, Candidate] = {}
    for run in runs:
        with guard(run):
            own = _precedence(run)
            for protocol in protocols_of(run):
                cell = cell_of(run, protocol)
                if (cell not in first or own > first[cell]) and (protocol == run.protocol or serves(run, protocol)):
                    first[cell], best[cell] = own, (run, protocol)
    return best


def _whole(rows: Mapping[Cell, bool]) -> set[tuple[str, str]]:
    """Return methods, each with a protocol, that some machine has asked all queries; rows are True if partial."""
    return {cell[:2] for cell, is_partial in rows.items() if not is_partial}


def _precedence(run: StoredRun) -> Precedence:
    """Return what :attr:`Entry.precedence` would be."""
    record = run.record
    try:
        return precedence(record.partial, record.key.k, record.created, record.key.digest())
    except ValueError:
        raise DamagedError(f"{run.folder} is damaged: {record.created!r} is no time.") from None


@contextmanager
def _leaving_out(told: Told | None, failed: set[Path], run: StoredRun) -> Iterator[None]:
    try:
        yield
    except VprBenchError as error:
        if told is None:
            raise
        failed.add(run.folder)
        told(error)
