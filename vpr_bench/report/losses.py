"""Where the right place was lost, in words and as a table."""

from collections.abc import Sequence

from vpr_bench.metrics.losses import RANKING, Step
from vpr_bench.report.grid import Grid
from vpr_bench.report.numbers import bounds, share, short_share
from vpr_bench.report.rows import Row


def losses_line(row: Row) -> str:
    """Say in one line what each step lost of all that could be found.

    Parameters
    ----------
    row : Row
        Of a run that noted its shortlists.
    """
    lost = ", ".join(f"{step.name} {short_share(step.lost.value)}" for step in row.steps)
    return f"{row.run.folder.name[:6]} lost the right place by: {lost}"


def losses_grid(row: Row) -> Grid:
    """Lay out one step per line: what it left, for how many queries the right place was among that, and its loss.

    Parameters
    ----------
    row : Row
        Of a run that noted its shortlists.
    """
    intervals = any(bounds(step.lost.low, step.lost.high) for step in row.steps)
    head = ["step", "references left", "right place among them", "lost by it"]
    cells = [_cells(step, intervals) for step in row.steps]
    if intervals:
        head = [*head[:3], "95 %", head[3], "95 %"]
    return Grid(
        f"{row.method}  {row.run.folder.name[:6]}  {row.protocol}: where the right place was lost",
        head,
        cells,
        f"references: mean per query; shares: of the queries that recall counts; after the {RANKING}: recall@1",
    )


def _cells(step: Step, intervals: bool) -> Sequence[str]:
    recall, lost = step.recall, step.lost
    if not intervals:
        return [step.name, f"{step.left:.1f}", share(recall.value), share(lost.value)]
    between = [bounds(one.low, one.high) for one in (recall, lost)]
    return [step.name, f"{step.left:.1f}", share(recall.value), between[0], share(lost.value), between[1]]
