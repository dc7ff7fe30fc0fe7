"""A leaderboard's folder as it is to be: its rows with those of more runs, and the tables that are made of them."""

from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path

from vpr_bench.errors import DataError
from vpr_bench.files.lock import held
from vpr_bench.leaderboard.folder import check_room, stale_tables, tables, write_tables
from vpr_bench.leaderboard.merge import Merge, Told, merge
from vpr_bench.leaderboard.results import RESULTS, is_written, read_results, write_results
from vpr_bench.leaderboard.standing import Board, boards
from vpr_bench.runner.store import StoredRun

LOCK = f".{RESULTS}.lock"


@dataclass(frozen=True)
class Renewal:
    """What belongs in the folder.

    Attributes
    ----------
    root : Path
        The folder.
    merge : Merge
        Its rows, and what became of them.
    boards : list of Board
        The rows, ranked.
    tables : dict
        Every Markdown file, by its name in the folder.
    """

    root: Path
    merge: Merge
    boards: list[Board]
    tables: dict[str, str]

    def stale(self) -> list[Path]:
        """Return the files that :meth:`write` would write or remove.

        Raises
        ------
        DataError
            If a file in the way is none of ours, and :meth:`write` would write nothing.
        """
        check_room(self.root, self.tables)
        results = self.root / RESULTS
        rows = [] if is_written(results, self.merge.entries) else [results]
        return [*rows, *stale_tables(self.root, self.tables)]

    def write(self) -> None:
        """Write what is not there yet; only what is :func:`claimed` is safe from other processes.

        Raises
        ------
        DataError
            If a file in the way is none of ours, and then nothing is written; or if the disk refuses.
        """
        check_room(self.root, self.tables)
        results = self.root / RESULTS
        if not is_written(results, self.merge.entries):
            write_results(results, self.merge.entries)
        write_tables(self.root, self.tables)


def claimed(root: Path) -> AbstractContextManager[None]:
    """Hold a folder against other processes inside the ``with`` block, from reading its rows to writing them.

    Raises
    ------
    DataError
        If it cannot be written to.
    """
    return held(root / LOCK, "Waiting for another process that writes the same leaderboard")


def renewal(root: Path, runs: Sequence[StoredRun], leave_out: Told | None = None) -> Renewal:
    """Read the rows of a folder and add those of runs; nothing is written.

    Parameters
    ----------
    root : Path
        The folder; without ``results.csv`` there are no rows yet.
    runs : sequence of StoredRun
        As in :func:`~vpr_bench.leaderboard.merge.merge`, and so is ``leave_out``.

    Raises
    ------
    VprBenchError
        If there are no rows at all, the rows are damaged or contradict each other, or a run cannot be scored.
    """
    results = root / RESULTS
    merged = merge(read_results(results) if results.exists() else [], runs, leave_out)
    if not merged.entries:
        raise DataError(f"There is nothing to rank: {results} has no rows, and no run could be scored.")
    ranked = boards(merged.entries)
    return Renewal(root, merged, ranked, tables(ranked))
