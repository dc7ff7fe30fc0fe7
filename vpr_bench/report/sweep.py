"""Metrics against the radius: one table per metric, with a line per run and a column per radius."""

from collections.abc import Iterator, Sequence
from itertools import groupby

from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.report.grid import Grid
from vpr_bench.report.numbers import bounds, short_share
from vpr_bench.report.rows import Row

_COLUMNS, _WITH_INTERVALS = 11, 6  # radii side by side, so that a table fits a window of 80 columns
_NOTHING = Interval(float("nan"), float("nan"), float("nan"))


def sweep_grids(rows: Sequence[Row]) -> list[Grid]:
    """Lay out every metric against the radius, and the losses of each step where runs noted their shortlists.

    Parameters
    ----------
    rows : sequence of Row
        With the same metrics, of one run or several, each at several radii.

    Returns
    -------
    list of Grid
        Runs on other images, queries or policies are in grids of their own, for only what is alike is compared.
    """
    grids: list[Grid] = []
    for alike in dict.fromkeys(map(comparable, rows)):
        same = [row for row in rows if comparable(row) == alike]
        metrics = list(dict.fromkeys(name for row in same for name in row.metrics))
        for metric in metrics:
            grids += _grids(metric, [[(row, _metric(row, metric)) for row in run] for run in by_run(same)])
        with_steps = [run for run in by_run(same) if run[0].steps]
        for name in dict.fromkeys(step.name for run in with_steps for row in run for step in row.steps):
            grids += _grids(f"lost by {name}", [[(row, _loss(row, name)) for row in run] for run in with_steps])
    return grids


def comparable(row: Row) -> tuple[str, str, str, str, str, int]:
    """Return what rows have to share to be compared at the same radius."""
    protocol, record = row.protocol, row.run.record
    return (
        protocol.source,
        protocol.pairing,
        protocol.unit,
        protocol.unmatched,
        record.key.dataset_digest,
        record.n_queries,
    )


def by_run(rows: Sequence[Row]) -> list[list[Row]]:
    """Sort rows into those of each run, by ascending radius."""
    folders = list(dict.fromkeys(row.run.folder for row in rows))
    ordered = sorted(rows, key=lambda row: (folders.index(row.run.folder), row.protocol.radius))
    return [list(run) for _, run in groupby(ordered, key=lambda row: row.run.folder)]


def run_names(rows: Sequence[Row]) -> list[str]:
    """Name runs by their method, and by as much of their hash as it takes where that is not enough."""
    labels = [row.method + (" (partial)" if row.partial else "") for row in rows]
    return [
        label if labels.count(label) == 1 else f"{label} {row.run.folder.name[:6]}"
        for row, label in zip(rows, labels, strict=True)
    ]


def _metric(row: Row, metric: str) -> Interval:
    return Interval(row.metrics[metric], *row.intervals.get(metric, (_NOTHING.low, _NOTHING.high)))


def _loss(row: Row, name: str) -> Interval:
    return next((step.lost for step in row.steps if step.name == name), _NOTHING)


def _grids(name: str, runs: Sequence[Sequence[tuple[Row, Interval]]]) -> Iterator[Grid]:
    """Lay out one quantity, on as many grids as the radii need."""
    first = runs[0][0][0]
    wide = any(bounds(value.low, value.high) for run in runs for _, value in run)
    radii = sorted({row.protocol.radius for run in runs for row, _ in run})
    names = run_names([run[0][0] for run in runs])
    at_once = _WITH_INTERVALS if wide else _COLUMNS
    for start in range(0, len(radii), at_once):
        shown = radii[start : start + at_once]
        cells = []
        for label, run in zip(names, runs, strict=True):
            of_radius = {row.protocol.radius: value for row, value in run}
            cells.append([label, *(_cell(of_radius.get(radius, _NOTHING)) for radius in shown)])
        unit = first.protocol.unit
        head = [f"radius ({unit})", *(f"{radius:g}" for radius in shown)]
        yield Grid(f"{first.protocol.source}/{first.protocol.pairing}  {name}", head, cells)


def _cell(value: Interval) -> str:
    return "\n".join(part for part in (short_share(value.value), bounds(value.low, value.high)) if part)
