"""The stored runs, and what became of those that cannot be read."""

import warnings
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path

from vpr_bench.gate.damaged import DamagedRun
from vpr_bench.gate.rerun import Sources
from vpr_bench.gate.verdict import Judgement, Verdict
from vpr_bench.report.pictures import RunPictures
from vpr_bench.runner.store import RunStore, StoredRun, StoreWarning


def gather(root: Path) -> tuple[list[StoredRun], list[DamagedRun]]:
    """Return the complete runs, oldest first, and those that are damaged or of another schema.

    Parameters
    ----------
    root : Path
        Folder that holds the runs.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StoreWarning)  # each is looked at again below
        runs = RunStore(root).runs()
    whole = {run.folder for run in runs}
    rest = [folder for folder in RunStore(root).folders() if folder not in whole]
    return runs, [damaged for folder in rest if (damaged := DamagedRun.at(folder)) is not None]


def with_names(
    judgement: Judgement, runs: Iterable[StoredRun], sources: Sources, warn: Callable[[str], None]
) -> Judgement:
    """Name the queries that moved, where the images are here.

    Parameters
    ----------
    judgement : Judgement
        What was found.
    runs : iterable of StoredRun
        Those that were judged.
    sources : Sources
        Where images of one's own are.
    warn : callable
        Told once, in one line, why there are no names.
    """
    by_folder, told = {run.folder: run for run in runs}, set[str]()

    def once(message: str) -> None:
        if message not in told:
            told.add(message)
            warn(message)

    def named(verdict: Verdict) -> Verdict:
        moved = {*verdict.lost, *verdict.gained, *(one.query for one in verdict.changed)}
        run = by_folder.get(verdict.run) if verdict.run else None
        if not moved or run is None:
            return verdict
        pictures = RunPictures(run, once, sources.folders.get(run.protocol.dataset), render=False)
        if pictures.case is None:
            return verdict
        return replace(verdict, names={query: pictures.query_name(query) for query in sorted(moved)})

    return replace(judgement, verdicts=[named(one) for one in judgement.verdicts])
