"""Where queries and references are, and which belong together, as plots: the map, and query against reference."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.load import Case
from vpr_bench.report.ink import AMBER, BLUE, GREEN, GREY, INK, PAPER, cut, font
from vpr_bench.report.plot import plot
from vpr_bench.report.sheet_columns import Column
from vpr_bench.types.ground_truth import GroundTruth

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from PIL import Image

_DOTS, _LINES, _NUMBERED = 20_000, 200, 40
"""At most so many dots of a traverse, lines from a query, and queries with a number."""

_CELLS = (120, 320)
"""At most so many cells upwards and across: fewer than the plot has pixels, or some of them would not be drawn."""


def draw_plots(case: Case, columns: Sequence[Column], width: int) -> "Image.Image":
    """Draw the plots side by side; the map only where places are positions.

    Parameters
    ----------
    case : Case
        What is drawn.
    columns : sequence of Column
        The queries to point out; they are numbered from 1.
    width : int
        Of the picture, in pixels.
    """
    positions = _positions(case)
    with plot(width, 480 if positions else 280) as drawn:
        if positions:
            on_map, pairs = drawn.figure.subplots(1, 2, width_ratios=(3, 2))
            _draw_map(on_map, *positions, case.ground_truth, columns)
        else:
            pairs = drawn.figure.subplots()
        _draw_pairs(pairs, case, columns)
    return drawn.picture()


def _positions(case: Case) -> tuple[NDArray[np.float64], NDArray[np.float64]] | None:
    """Return where queries and references are, in metres from the map's corner; None if labels are no positions."""
    queries, references = case.places.queries, case.places.references
    if queries is None or references is None or queries.ndim != 2 or queries.shape[1] < 2 or not len(references):
        return None
    corner = np.minimum(queries[:, :2].min(axis=0), references[:, :2].min(axis=0))
    return queries[:, :2] - corner, references[:, :2] - corner


def _draw_map(
    axes: "Axes",
    queries: NDArray[np.float64],
    references: NDArray[np.float64],
    truth: GroundTruth,
    columns: Sequence[Column],
) -> None:
    from matplotlib.collections import LineCollection

    for places, colour, label in ((references, "#8b93a1", "references"), (queries, "#6fb3dc", "queries")):
        some = places[:: -(-len(places) // _DOTS)]
        axes.scatter(some[:, 0], some[:, 1], s=10, color=colour, linewidths=0, label=label)
    chosen = queries[[column.query for column in columns]]
    lines = [
        [queries[column.query], references[one]] for column in columns for one in truth[column.query][:_LINES].tolist()
    ]
    misses = [
        [queries[column.query], references[one.reference]]
        for column in columns
        for one in column.shown
        if one.kind == "miss"
    ]
    axes.add_collection(LineCollection(lines, colors=GREEN, linewidths=0.9, label="true matches"))
    axes.add_collection(LineCollection(misses, colors=GREY, linewidths=0.9, linestyles=":"))
    ends = np.array([end for _, end in lines]).reshape(-1, 2)
    axes.scatter(ends[:, 0], ends[:, 1], s=9, color=GREEN, linewidths=0, zorder=3)
    axes.scatter(chosen[:, 0], chosen[:, 1], s=26, color=BLUE, linewidths=0, zorder=4, label="queries shown")
    axes.set_aspect("equal", adjustable="datalim")
    axes.set(xlabel="metres", ylabel="metres")
    axes.set_title("Where they are", fontsize=10, loc="left", color=INK)
    axes.margins(0.06)
    axes.grid(alpha=0.25)
    axes.legend(
        loc="upper left",
        bbox_to_anchor=(0, -0.12),
        ncols=4,
        frameon=False,
        borderpad=0,
        handlelength=1.2,
        markerscale=1.5,
    )
    _number(axes, chosen)


def _number(axes: "Axes", points: NDArray[np.float64]) -> None:
    """Write each query's number beside it, where no other number stands."""
    if len(points) > _NUMBERED:
        return
    from matplotlib.patheffects import withStroke

    axes.apply_aspect()
    pixels = axes.transData.transform(points)
    taken: list[NDArray[np.float64]] = []
    turns = np.pi * (np.arange(8) / 4 + 0.25)
    around = [(reach * np.cos(turn), reach * np.sin(turn)) for reach in (13, 26, 39) for turn in turns]
    for number, (point, pixel) in enumerate(zip(points, pixels, strict=True), start=1):
        others = np.delete(pixels, number - 1, axis=0)
        crowding = [_crowding(pixel + offset, [*taken, *others]) for offset in around]
        offset = around[int(np.argmin(crowding))]
        taken.append(pixel + offset)
        axes.annotate(
            str(number),
            tuple(point),
            offset,
            textcoords="offset pixels",
            ha="center",
            va="center",
            color=BLUE,
            fontsize=9,
            fontweight="bold",
            zorder=5,
            path_effects=[withStroke(linewidth=2.5, foreground=PAPER)],
        )


def _crowding(spot: NDArray[np.float64], others: list[Any]) -> float:
    """Return by how much a number there would overlap others."""
    apart = np.abs(np.array(others).reshape(-1, 2) - spot)
    return float(np.clip(1 - apart / (16, 13), 0, None).prod(axis=1).sum())


def _draw_pairs(axes: "Axes", case: Case, columns: Sequence[Column]) -> None:
    """Draw which references are right for which query: a diagonal where both walked the same way."""
    from matplotlib.ticker import MaxNLocator

    truth = case.ground_truth
    for pairs, colour in ((truth.soft, AMBER), (truth, GREEN)):
        if pairs is not None:
            _draw_cells(axes, pairs, colour)
    shown = np.array([column.query for column in columns], dtype=np.float64)
    axes.vlines(shown, 0, 1, transform=axes.get_xaxis_transform(), color=BLUE, linewidth=0.7, alpha=0.6)
    if len(shown) <= _NUMBERED:
        for number, (query, place) in enumerate(zip(shown, _spread(shown, truth.n_queries * 0.022), strict=True), 1):
            axes.annotate(
                str(number),
                (query, 1),
                (place, 1.02),
                xycoords=axes.get_xaxis_transform(),
                textcoords=axes.get_xaxis_transform(),
                ha="center",
                va="bottom",
                color=BLUE,
                fontsize=9,
                fontweight="bold",
            )
    axes.set(
        xlabel=f"query of {cut(case.protocol.queries, 240, font(12))}",
        ylabel=f"reference of {cut(case.protocol.references, 110, font(12))}",
    )
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(integer=True, steps=[1, 2, 5, 10]))
    axes.set_title("Which references match which query", fontsize=10, loc="left", color=INK, pad=18)


def _draw_cells(axes: "Axes", pairs: GroundTruth, colour: str) -> None:
    from matplotlib.colors import to_rgba

    size = (max(pairs.n_references, 1), max(pairs.n_queries, 1))
    rows, columns = (min(one, most) for one, most in zip(size, _CELLS, strict=True))
    cells = np.zeros((rows, columns, 4))
    cells[pairs.references * rows // size[0], pairs.query_of_pair * columns // size[1]] = to_rgba(colour)
    extent = (-0.5, size[1] - 0.5, -0.5, size[0] - 0.5)
    axes.imshow(cells, origin="lower", aspect="auto", interpolation="nearest", extent=extent)


def _spread(places: NDArray[np.float64], gap: float) -> NDArray[np.float64]:
    """Move ascending places apart until neighbours have a gap between them, as little as that takes going right."""
    steps = gap * np.arange(len(places))
    spread: NDArray[np.float64] = np.maximum.accumulate(places - steps) + steps
    return spread
