"""New runs among the rows that are there: which are new, which replace others, which stay."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from vpr_bench.errors import DamagedError, UsageError, VprBenchError
from vpr_bench.leaderboard.collect import cell_of, collect
from vpr_bench.leaderboard.entry import Cell, Entry, moment
from vpr_bench.leaderboard.protocols import protocols_of
from vpr_bench.progress import track
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol

Told = Callable[[VprBenchError], None]


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
        Rows that stand for a newer run, or for all queries, where before there was another.
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

    Of one cell, a complete run comes before a partial one, then the newer one; what a row says already is not
    computed again. A run has a row on each of :func:`~vpr_bench.leaderboard.protocols.protocols_of` that its places
    say anything about.

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
    for run, protocol in track(_wanted(held, runs, leave_out), "Scoring"):
        with _leaving_out(leave_out, failed, run), _served(run, protocol):
            if run.folder not in failed:
                found[cell_of(run, protocol)] = collect(run, protocol)
    rows = {**held, **found}
    whole = {cell[:2] for cell, entry in rows.items() if not entry.partial}
    stay = {cell: entry for cell, entry in rows.items() if not entry.partial or cell[:2] not in whole}
    return Merge(
        entries=list(stay.values()),
        new=[entry for cell, entry in found.items() if cell in stay and cell not in held],
        replaced=[entry for cell, entry in found.items() if cell in stay and cell in held],
        kept=[entry for cell, entry in held.items() if cell in stay and cell not in found],
        dropped=[entry for cell, entry in held.items() if cell not in stay],
    )


def _wanted(
    held: dict[Cell, Entry], runs: Sequence[StoredRun], leave_out: Told | None
) -> list[tuple[StoredRun, Protocol]]:
    """Return the runs whose rows are to be made: the best of each cell, if it comes before the row there is."""
    best: dict[Cell, tuple[tuple[bool, datetime, str], StoredRun, Protocol]] = {}
    for run in runs:
        with _leaving_out(leave_out, set(), run):
            precedence = _precedence(run)
            for protocol in protocols_of(run):
                cell = cell_of(run, protocol)
                if cell not in best or precedence > best[cell][0]:
                    best[cell] = precedence, run, protocol
    return [
        (run, protocol)
        for cell, (precedence, run, protocol) in best.items()
        if cell not in held or precedence > held[cell].precedence
    ]


@contextmanager
def _served(run: StoredRun, protocol: Protocol) -> Iterator[None]:
    """Pass over a protocol that the run was not asked for, and does not have the places for."""
    try:
        yield
    except UsageError:
        if protocol == run.protocol:
            raise


def _precedence(run: StoredRun) -> tuple[bool, datetime, str]:
    """Return what :attr:`Entry.precedence` would be."""
    try:
        created = moment(run.record.created)
    except ValueError:
        raise DamagedError(f"{run.folder} is damaged: {run.record.created!r} is no time.") from None
    return not run.record.partial, created, run.record.key.digest()


@contextmanager
def _leaving_out(told: Told | None, failed: set[Path], run: StoredRun) -> Iterator[None]:
    try:
        yield
    except VprBenchError as error:
        if told is None:
            raise
        failed.add(run.folder)
        told(error)
