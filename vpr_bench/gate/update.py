"""A new baseline from an old one and the runs of today."""

from collections.abc import Iterable
from dataclasses import dataclass

from vpr_bench.errors import DataError
from vpr_bench.gate.baseline import Baseline
from vpr_bench.gate.cell import Cell
from vpr_bench.gate.latency_change import latency_change
from vpr_bench.gate.matching import choose, without_cell
from vpr_bench.gate.recording import record_cell
from vpr_bench.gate.rules import Overrides, Rules
from vpr_bench.runner.store import StoredRun


@dataclass(frozen=True)
class Update:
    """A new baseline, and the ids of the cells in which it differs from the old one.

    Attributes
    ----------
    baseline : Baseline
        The new one.
    recorded : list of str
        Cells that are recorded anew.
    added, dropped : list of str
        Cells that one of the two does not have.
    """

    baseline: Baseline
    recorded: list[str]
    added: list[str]
    dropped: list[str]

    def summary(self) -> str:
        """Say in a few words what is new."""
        counts = ((self.recorded, "recorded anew"), (self.added, "added"), (self.dropped, "dropped"))
        return ", ".join(f"{len(cells)} {word}" for cells, word in counts if cells) or "the rules"


def updated(
    baseline: Baseline,
    runs: Iterable[StoredRun],
    overrides: Overrides | None = None,
    *,
    only: Iterable[str] | None = None,
    prune: bool = False,
    named: bool = False,
) -> Update:
    """Record runs in a baseline.

    A cell is recorded anew only if answers, version, weights or images changed, or its time did by more than its rules
    allow: a repeated run leaves the file as it is.

    Parameters
    ----------
    baseline : Baseline
        The old one; left as it is.
    runs : iterable of StoredRun
        Those of today; cells without one are kept, runs without a cell are added.
    overrides : Overrides, optional
        Become the rules of the file. A cell's own rules stay.
    only : iterable of str, optional
        Ids of the cells that may be recorded or dropped; all others are kept. By default all may.
    prune : bool
        Drop the cells without a run.
    named : bool
        As of :func:`vpr_bench.gate.matching.without_cell`.

    Raises
    ------
    UsageError
        If a run cannot be scored, or the overrides make no sense.
    DataError
        If a run is damaged, or the new baseline would hold no cells.
    """
    runs, old = list(runs), baseline.cells
    asked = set(old if only is None else only)
    rules = (overrides or Overrides()).apply(baseline.rules)
    cells = {name: cell for name, cell in old.items() if name not in asked}
    recorded = []
    for name, cell in old.items():
        run = choose(cell, runs) if name in asked else None
        if run is None:
            if name in asked and not prune:
                cells[name] = cell
            continue
        now = _recorded(cell, run, cell.rules.over(rules))
        cells[name] = _kept(cell, now, cell.rules.over(rules))
        recorded += [name] if cells[name] is not cell else []
    fresh = [record_cell(run, metrics=rules.metrics) for run in without_cell(old.values(), runs, named=named)]
    new = baseline.model_copy(update={"rules": rules}).with_cells([*cells.values(), *fresh])
    if not new.cells:
        raise DataError("There is nothing to record: a baseline without cells would pass whatever happens.")
    return Update(new, recorded, [cell.id for cell in fresh], [name for name in old if name not in new.cells])


def _recorded(cell: Cell, run: StoredRun, rules: Rules) -> Cell:
    """Record a run in place of a cell, with the metrics that the file already shows for it."""
    metrics = dict.fromkeys([*cell.metrics, *rules.metrics])
    return record_cell(run, cell.asked, metrics).model_copy(update={"rules": cell.rules})


def _kept(cell: Cell, now: Cell, rules: Rules) -> Cell:
    """Return the old cell if the new one says nothing new."""
    if not cell.same_answers(now):
        return now
    times = latency_change(cell, now, rules.latency_ratio)
    if times.limit is None or times.doubt or times.ratio is None or not times.ratio:
        return cell
    return now if max(times.ratio, 1 / times.ratio) > times.limit else cell
