"""What there is to judge: the cells that somebody asks about, the runs for them, and what could not be had."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from vpr_bench.errors import DataError
from vpr_bench.gate.baseline import Baseline
from vpr_bench.gate.cell import Cell
from vpr_bench.gate.damaged import DamagedRun
from vpr_bench.gate.gathering import gather
from vpr_bench.gate.judging import judge
from vpr_bench.gate.matching import belongs, choose
from vpr_bench.gate.rerun import run_cells
from vpr_bench.gate.rules import Overrides
from vpr_bench.gate.selection import Selection, Subject
from vpr_bench.gate.verdict import Judgement, Verdict
from vpr_bench.runner.store import StoredRun


@dataclass(frozen=True)
class Evidence:
    """What a judgement is made of.

    Attributes
    ----------
    asked : Baseline
        The cells that are asked about, but for those that could not be run.
    runs : sequence of StoredRun
        Those that are asked about.
    errors : sequence of Verdict
        On cells that could not be run, and runs that could not be read.
    left_out : int
        Cells that are not asked about.
    named : bool
        The protocols of the runs were named with their radius, as of :func:`vpr_bench.gate.matching.without_cell`.
    """

    asked: Baseline
    runs: Sequence[StoredRun]
    errors: Sequence[Verdict]
    left_out: int
    named: bool = False

    @property
    def partial(self) -> list[Path]:
        """Folders of the runs of some queries only."""
        return list(dict.fromkeys(run.folder for run in self.runs if run.record.partial))

    @property
    def recordable(self) -> bool:
        """Whether there is a run of all queries."""
        return any(not run.record.partial for run in self.runs)

    def judge(self, overrides: Overrides, *, recording: bool = False) -> Judgement:
        """Judge all of it; errors of what could not be had stand with the rest.

        Parameters
        ----------
        overrides : Overrides
            Instead of the baseline's rules.
        recording : bool
            As of :class:`~vpr_bench.gate.verdict.Judgement`.
        """
        verdicts = [*judge(self.asked, self.runs, overrides, named=self.named).verdicts, *self.errors]
        ordered = sorted(verdicts, key=lambda one: (one.outcome == "new", one.protocol, one.label))
        return Judgement(ordered, self.left_out, self.partial, recording)


def collect(baseline: Baseline, selection: Selection, root: Path) -> Evidence:
    """Take the runs that are stored.

    Parameters
    ----------
    baseline : Baseline
        Its cells.
    selection : Selection
        Which of them, and which runs, are asked about.
    root : Path
        Folder that holds the runs.

    Raises
    ------
    UsageError
        If something that the selection names is neither in the baseline nor among the runs.
    DataError
        If there are no runs at all.
    """
    runs, damaged = gather(root)
    if not runs and not damaged:
        raise DataError(
            f"There are no runs under {root}. --run makes those of the baseline, and --runs names another folder."
        )
    cells, wanted = baseline.cells.values(), [one for run in runs for one in selection.asked_of(run)]
    selection.check([*map(Subject.of_cell, cells), *map(Subject.of_run, [*runs, *wanted])])
    asked = [cell for cell in cells if selection.wants(Subject.of_cell(cell))]
    errors, left = _told(damaged, asked, runs, selection)
    return Evidence(baseline.with_cells(left), wanted, errors, len(cells) - len(asked), selection.names_radii)


def run_and_collect(baseline: Baseline, selection: Selection, root: Path, say: Callable[[str], None]) -> Evidence:
    """Run the cells that are asked about and not stored, then take the runs; what is said tells which is run.

    Of each cell that was asked about, the run of the method and the images that are here now counts, and no other one.
    Parameters and errors are those of :func:`collect`.
    """
    selection.check(map(Subject.of_cell, baseline.cells.values()))
    asked = [cell for cell in baseline.cells.values() if selection.wants(Subject.of_cell(cell))]
    fresh, failed = run_cells(asked, root, selection.sources, say)
    left_out = len(baseline.cells) - len(asked)
    if not fresh and failed:
        return Evidence(baseline.with_cells([]), [], failed, left_out)
    evidence = collect(baseline, selection, root)
    others = [run for run in evidence.runs if not any(belongs(run, cell) for cell in asked)]
    unrun = {(one.label, one.protocol) for one in failed}
    cells = [cell for cell in asked if (cell.label, cell.protocol) not in unrun]
    errors = [*failed, *(one for one in evidence.errors if (one.label, one.protocol) not in unrun)]
    return replace(evidence, asked=baseline.with_cells(cells), runs=fresh + others, errors=errors)


def _told(
    damaged: Iterable[DamagedRun], asked: Sequence[Cell], runs: Sequence[StoredRun], selection: Selection
) -> tuple[list[Verdict], list[Cell]]:
    """Return an error for each damaged run that is asked about, and the cells that are not told of by these."""
    left, errors = list(asked), []
    for one in damaged:
        cell = one.cell([cell for cell in left if choose(cell, runs) is None])
        if cell is not None:
            left.remove(cell)
            errors.append(one.verdict(cell.label, cell.protocol))
        elif one.run is None or selection.wants(Subject.of_run(one.run)):
            errors.append(one.verdict())
    return errors, left
