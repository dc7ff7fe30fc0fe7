"""A method on a board of which more is shown than its row: curves, losses and pictures."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from vpr_bench.errors import DataError, blaming
from vpr_bench.leaderboard.entry import Entry
from vpr_bench.leaderboard.standing import Board
from vpr_bench.page.curves import Curves, curves_of
from vpr_bench.page.looks import displayed
from vpr_bench.runner.store import StoredRun


@dataclass(frozen=True)
class Shown:
    """A method whose stored run is here.

    Attributes
    ----------
    entry : Entry
        Its row.
    name : str
        Its label; with the run's first digits where several rows have the same one.
    run : StoredRun
        What it answered.
    curves : Curves
        Computed from that.
    """

    entry: Entry
    name: str
    run: StoredRun
    curves: Curves


def shown_methods(board: Board, runs: Mapping[str, StoredRun]) -> list[Shown]:
    """Return what can be shown of a board, best first; each run once, and partial ones not at all.

    Parameters
    ----------
    board : Board
    runs : mapping of StoredRun
        By their 12 digits. One that was made on another machine than the row's is not the one that was measured.

    Raises
    ------
    DataError
        If a run is damaged.
    """
    there = {one.entry.run: one.entry for one in board.standings if not one.entry.partial and _is_of(one.entry, runs)}
    labels = [entry.method for entry in there.values()]
    found = []
    for digits, entry in there.items():
        with blaming(f"{runs[digits].folder} is damaged", DataError):
            curves = curves_of(runs[digits], board.protocol)
        found.append(Shown(entry, _name(entry, labels), runs[digits], curves))
    return found


def _is_of(entry: Entry, runs: Mapping[str, StoredRun]) -> bool:
    return entry.run in runs and runs[entry.run].record.machine.fingerprint == entry.machine


def _name(entry: Entry, labels: Sequence[str]) -> str:
    name = displayed(entry.method)
    return name if labels.count(entry.method) == 1 else f"{name} {entry.run[:6]}"
