"""Where the right place was lost as a picture: one bar per run, from all queries down to those answered rightly."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from vpr_bench.errors import UsageError
from vpr_bench.metrics.losses import NO_MATCH, RANKING
from vpr_bench.report.figure import diagram
from vpr_bench.report.ink import AMBER, BLUE, GREEN, GREY, INK, RED
from vpr_bench.report.rows import Row

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_STEPS = (AMBER, BLUE, "#cc79a7", "#56b4e9", "#f0e442")
_FIXED = {RANKING: RED, NO_MATCH: GREY}
_NARROW = 3.5  # per cent of the width in which a number still fits


def draw_waterfall(rows: Sequence[Row], file: Path) -> Path:
    """Draw one stacked bar per row: found, then what each step lost, the last step next to what was found.

    Parameters
    ----------
    rows : sequence of Row
        Those of runs that noted no shortlists are left out.
    file : Path
        Ends in .png or .svg.

    Raises
    ------
    UsageError
        If no run noted any.
    DataError
        If it cannot be written.
    """
    rows = [row for row in rows if row.steps]
    if not rows:
        raise UsageError("None of these runs noted which references were still in the running: nothing to draw.")
    names = dict.fromkeys(step.name for row in rows for step in row.steps if step.name not in _FIXED)
    colours = {name: _STEPS[number % len(_STEPS)] for number, name in enumerate(names)} | _FIXED
    with diagram(8.4, 1.5 + 0.72 * len(rows), file) as figure:
        axes = figure.add_subplot()
        for line, row in enumerate(rows):
            _draw_bar(axes, line, row, colours)
        axes.set(xlim=(0, 100), xlabel="% of the queries", ylim=(len(rows) - 0.45, -0.75), yticks=[])
        axes.spines[["left", "right", "top"]].set_visible(False)
        handles = dict(zip(*axes.get_legend_handles_labels()[::-1], strict=True))
        legend = figure.legend(handles.values(), handles.keys(), loc="outside lower left", ncols=4, frameon=False)
        for text in legend.get_texts():
            text.set_parse_math(False)
    return file


def _draw_bar(axes: "Axes", line: int, row: Row, colours: dict[str, str]) -> None:
    start = 0.0
    parts = [("found (recall@1)", row.steps[-1].recall.value, GREEN)]
    parts += [(f"lost by {step.name}", step.lost.value, colours[step.name]) for step in reversed(row.steps)]
    for name, lost, colour in parts:
        width = 100 * lost
        axes.barh(line, width, left=start, height=0.42, color=colour, label=name)
        if width >= _NARROW:
            ink = INK if colour in ("#f0e442", "#56b4e9", AMBER) else "white"
            axes.text(start + width / 2, line, f"{width:.1f}", ha="center", va="center", color=ink, fontsize=9)
        start += width
    title = f"{row.method}  {row.protocol}"
    axes.text(0, line - 0.27, title, ha="left", va="bottom", fontsize=9, parse_math=False)
