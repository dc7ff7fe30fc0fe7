"""Running what a baseline lists, exactly as it was recorded."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

from vpr_bench.cores import available_cores
from vpr_bench.dataset.load import Case
from vpr_bench.errors import UsageError, VprBenchError, one_line
from vpr_bench.gate.cell import Cell, other_images
from vpr_bench.gate.matching import asked_for
from vpr_bench.gate.verdict import Verdict, error
from vpr_bench.method.build import BuiltMethod, build_method
from vpr_bench.method.rebuild import rebuilding
from vpr_bench.runner.images import OtherImagesError, case_of
from vpr_bench.runner.run import RunOptions, find_run, run, run_key
from vpr_bench.runner.store import RunStore, StoredRun

Say = Callable[[str], None]


@dataclass(frozen=True)
class Sources:
    """Where things are that the ids in a baseline do not find.

    Attributes
    ----------
    methods : dict
        Method id to what the user called it, such as ``path/to/file.py:Class``; their code may be run, though they are
        not installed, also inside other methods.
    folders : dict
        Dataset id to the folder that holds it, for datasets of one's own.
    """

    methods: dict[str, str] = field(default_factory=dict)
    folders: dict[str, str] = field(default_factory=dict)

    def case(self, cell: Cell) -> Case:
        """Load the images and places of a cell.

        Raises
        ------
        UsageError
            If there is no such dataset or protocol.
        DataError
            If they are missing, damaged, or not those of the cell.
        """
        try:
            return case_of(cell.asked, cell.dataset, self.folders.get(cell.asked.dataset))
        except OtherImagesError as fault:
            raise other_images(cell, fault.found, f"in {fault.folder}") from None

    def method(self, cell: Cell) -> BuiltMethod:
        """Build the method of a cell.

        Raises
        ------
        UsageError
            If it does not exist, is not installed and not named by the user, or does not take these parameters.
        """
        with rebuilding(self.methods, option="--trust"):
            built = build_method(cell.method, cell.parameters, cell.seed)
        if built.label != cell.label:
            raise UsageError(f"The baseline's {cell.label!r} is now called {built.label!r}. Record it with --update.")
        return built


def run_cells(
    cells: Iterable[Cell], root: Path, sources: Sources, say: Say = lambda told: None
) -> tuple[list[StoredRun], list[Verdict]]:
    """Run the cells that are not stored yet, each as it was recorded.

    Parameters
    ----------
    cells : iterable of Cell
        What to run.
    root : Path
        Folder that holds the runs.
    sources : Sources
        Where methods and images are.
    say : callable
        Told, in one line, what is being done.

    Returns
    -------
    runs : list of StoredRun
        By the methods and on the images that are here now.
    errors : list of Verdict
        On the cells that could not be run.
    """
    runs, errors = [], []
    for cell in cells:
        try:
            runs.append(run_cell(cell, root, sources, say))
        except VprBenchError as fault:
            errors.append(error(cell.label, cell.protocol, fault))
    return runs, errors


def options_of(cell: Cell) -> RunOptions:
    """Say how a cell is run: as it was recorded, with as many threads as then or, where there are fewer, all cores."""
    return RunOptions(seed=cell.seed, k=cell.k, threads=max(1, min(cell.threads, available_cores())))


def run_cell(cell: Cell, root: Path, sources: Sources, say: Say = lambda told: None) -> StoredRun:
    """Run one cell, or take the stored run, as if it had been asked for the cell's protocol.

    Parameters are those of :func:`run_cells`.

    Raises
    ------
    VprBenchError
        If it cannot be run.
    """
    built, case = sources.method(cell), sources.case(cell)
    store, options = RunStore(root), options_of(cell)
    found = find_run(store, run_key(case, built, options), options.overwrite)
    say(one_line(f"{cell.label} on {cell.protocol}: {'stored already' if found else 'running'}"))
    return asked_for(found or run(case, built, store, options), cell.asked)
