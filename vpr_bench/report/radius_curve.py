"""Metrics against the radius as a picture: a panel per metric, a line per run."""

from collections.abc import Sequence
from pathlib import Path

from vpr_bench.errors import UsageError
from vpr_bench.report.figure import diagram
from vpr_bench.report.ink import AMBER, BLUE, GREEN, GREY, INK, RED
from vpr_bench.report.rows import Row
from vpr_bench.report.sweep import by_run, run_names

_COLOURS = (BLUE, RED, GREEN, AMBER, INK, GREY)
_MARKS = ("o", "s", "^", "D", "v", "X")
_PANEL, _HEIGHT, _LINE = 3.6, 3.4, 0.24  # inches: width and height of a panel, height of a line of the legend


def draw_radius_curve(rows: Sequence[Row], metrics: Sequence[str], file: Path) -> Path:
    """Draw metrics against the radius; with intervals, as bands.

    Parameters
    ----------
    rows : sequence of Row
        With the same unit of the radius.
    metrics : sequence of str
        Which to draw; every row has them.
    file : Path
        Ends in .png or .svg.

    Raises
    ------
    UsageError
        If some radii are in frames and others in metres, or there is but one.
    DataError
        If it cannot be written.
    """
    if len({row.protocol.unit for row in rows}) > 1:
        raise UsageError("These runs measure the radius in different units: draw those of one unit at a time.")
    if len({row.protocol.radius for row in rows}) < 2:
        raise UsageError("A curve against the radius needs several radii, such as --radius 0..10.")
    runs = by_run(rows)
    with diagram(_PANEL * max(len(metrics), 1.6), _HEIGHT + _LINE * len(runs), file) as figure:
        panels = figure.subplots(1, len(metrics), sharey=True, squeeze=False)[0]
        for number, (label, run) in enumerate(zip(_labels(runs), runs, strict=True)):
            colour, mark = _COLOURS[number % len(_COLOURS)], _MARKS[number // len(_COLOURS) % len(_MARKS)]
            radii = [row.protocol.radius for row in run]
            for axes, metric in zip(panels, metrics, strict=True):
                values = [row.metrics[metric] for row in run]
                axes.plot(radii, values, color=colour, marker=mark, markersize=4, linewidth=1.6, label=label)
                if run[0].intervals:
                    low, high = zip(*(row.intervals[metric] for row in run), strict=True)
                    axes.fill_between(radii, low, high, color=colour, alpha=0.15, linewidth=0)
        unit = {"f": " (frames)", "m": " (metres)"}.get(rows[0].protocol.unit, "")
        for axes, metric in zip(panels, metrics, strict=True):
            axes.set_title(metric, fontsize=10, loc="left")
            axes.set(xlabel=f"radius{unit}", ylim=(0, 1.02))
            axes.grid(alpha=0.3)
        legend = figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower left", frameon=False)
        for text in legend.get_texts():
            text.set_parse_math(False)  # what a method is called may hold a dollar
    return file


def _labels(runs: Sequence[Sequence[Row]]) -> list[str]:
    """Name runs; by their protocol, too, unless that is the same for all."""
    first = [run[0] for run in runs]
    where = [f"{row.protocol.source}/{row.protocol.pairing}" for row in first]
    names = run_names(first)
    if len(set(where)) == 1:
        return [f"{name}  {where[0]}" if len(names) == 1 else name for name in names]
    return [f"{row.method}  {place}" for row, place in zip(first, where, strict=True)]
