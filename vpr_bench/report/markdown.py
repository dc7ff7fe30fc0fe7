"""Rows as Markdown, to be pasted into a page."""

from collections.abc import Sequence

from vpr_bench.report.grid import Grid
from vpr_bench.report.losses import losses_grid
from vpr_bench.report.numbers import bounds, milliseconds, share
from vpr_bench.report.rows import Row


def to_markdown(rows: Sequence[Row]) -> str:
    """Write one line per row, and a table of losses for each run that noted its shortlists.

    Parameters
    ----------
    rows : sequence of Row
        A metric that a row lacks is left empty.
    """
    metrics = list(dict.fromkeys(name for row in rows for name in row.metrics))
    cells = [
        [
            row.method + (" (partial)" if row.partial else ""),
            row.run.folder.name[:6],
            str(row.protocol),
            *(_value(row, metric) for metric in metrics),
            milliseconds(row.latency["latency_total_p50"]) if "latency_total_p50" in row.latency else "",
        ]
        for row in rows
    ]
    grids = [Grid("", ["method", "run", "protocol", *metrics, "total ms (p50)"], cells)]
    grids += [losses_grid(row) for row in rows if row.steps]
    return "\n\n".join(grid.markdown() for grid in grids)


def _value(row: Row, metric: str) -> str:
    if metric not in row.metrics:
        return ""
    interval = bounds(*row.intervals[metric]) if metric in row.intervals else ""
    return f"{share(row.metrics[metric])} {interval}".rstrip()
