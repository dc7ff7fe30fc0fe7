"""Where a sequence is cut: the similarity of images, of neighbours, and which image is in which cluster."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from vpr_bench.method.clustering import Clustered
from vpr_bench.report.ink import BLUE, GREY, INK, PAPER, RED
from vpr_bench.report.plot import plot
from vpr_bench.types.clusters import Clusters

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_CELLS = 600
"""At most so many rows and columns of the matrix: of more images, some are left out evenly."""

_BORDERS = 150
"""Up to so many clusters, each border is a line of its own."""


def draw_cluster_plot(found: Clustered, width: int) -> Image.Image:
    """Draw the plots side by side; without descriptors, only which image is in which cluster.

    Parameters
    ----------
    found : Clustered
        What is drawn.
    width : int
        Of the picture, in pixels.
    """
    if found.descriptors is None:
        with plot(width, 300) as drawn:
            _draw_members(drawn.figure.subplots(), found.clusters)
        return drawn.picture()
    rows = found.descriptors.astype(np.float32)
    rows = rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-12)
    with plot(width, 620) as drawn:
        panels = drawn.figure.subplot_mosaic([["matrix", "neighbours"], ["matrix", "members"]], width_ratios=(62, 90))
        _draw_matrix(panels["matrix"], rows, found.clusters)
        _draw_neighbours(panels["neighbours"], rows, found.clusters)
        _draw_members(panels["members"], found.clusters)
        panels["neighbours"].sharex(panels["members"])
    return drawn.picture()


def _draw_matrix(axes: "Axes", rows: NDArray[np.float32], clusters: Clusters) -> None:
    n = len(rows)
    some = np.linspace(0, n - 1, min(n, _CELLS)).round().astype(np.int64)
    alike = rows[some] @ rows[some].T
    others = alike[~np.eye(len(some), dtype=bool)]
    low, high = np.percentile(others, (1, 99.5)) if len(others) else (0.0, 1.0)
    extent = (-0.5, n - 0.5, n - 0.5, -0.5)
    shown = axes.imshow(alike, cmap="magma", vmin=low, vmax=high, extent=extent, interpolation="nearest")
    colours = axes.figure.colorbar(shown, ax=axes, shrink=0.6, pad=0.02)
    colours.outline.set_visible(False)
    if clusters.contiguous:
        corners = list(zip(clusters.starts - 0.5, clusters.stops - 0.5, strict=True))
        for start, stop in corners:
            axes.plot([start, stop, stop, start, start], [start, start, stop, stop, start], color=PAPER, lw=1.1)
    axes.set_title("Cosine similarity of references, and the clusters", fontsize=10, loc="left", color=INK)
    axes.set(xlabel="reference", ylabel="reference", xlim=(-0.5, n - 0.5), ylim=(n - 0.5, -0.5))


def _draw_neighbours(axes: "Axes", rows: NDArray[np.float32], clusters: Clusters) -> None:
    neighbours = np.einsum("nd,nd->n", rows[1:], rows[:-1])
    axes.plot(np.arange(1, len(rows)) - 0.5, neighbours, color=BLUE, linewidth=1.1)
    cuts = np.flatnonzero(np.diff(clusters.labels))
    if len(clusters) <= _BORDERS:
        axes.vlines(cuts + 0.5, 0, 1, transform=axes.get_xaxis_transform(), color=GREY, linewidth=0.6, alpha=0.6)
    axes.plot(cuts + 0.5, neighbours[cuts], "o", color=RED, markersize=3.5)
    title = "Similarity of neighbours; a dot where the cluster changes"
    axes.set_title(title, fontsize=10, loc="left", color=INK)
    axes.set_ylabel("cosine")
    axes.tick_params(labelbottom=False)
    axes.grid(axis="y", alpha=0.3)


def _draw_members(axes: "Axes", clusters: Clusters) -> None:
    """Draw each run of images of one cluster as a bar at the cluster's number."""
    from matplotlib.ticker import MaxNLocator

    labels = clusters.labels
    bounds = np.concatenate([[0], np.flatnonzero(np.diff(labels)) + 1, [len(labels)]])
    numbers = labels[bounds[:-1]]
    size = max(1.0, 0.02 * len(clusters))  # a bar is seen even where there are very many
    cohesion = clusters.cohesion
    if cohesion is None:
        axes.barh(numbers, np.diff(bounds), size, left=bounds[:-1] - 0.5, color=BLUE)
        title = "Which references each cluster has"
    else:
        from matplotlib import colormaps
        from matplotlib.cm import ScalarMappable
        from matplotlib.colors import Normalize

        scale = ScalarMappable(Normalize(float(cohesion.min()), float(cohesion.max())), colormaps["viridis"])
        axes.barh(numbers, np.diff(bounds), size, left=bounds[:-1] - 0.5, color=scale.to_rgba(cohesion[numbers]))
        if cohesion.min() < cohesion.max():
            colours = axes.figure.colorbar(scale, ax=axes, pad=0.01)
            colours.outline.set_visible(False)
        title = "Which references each cluster has; its colour is its cohesion"
    axes.set_title(title, fontsize=10, loc="left", color=INK)
    axes.set(xlabel="reference", ylabel="cluster", xlim=(-0.5, len(labels) - 0.5), ylim=(len(clusters) - 0.5, -0.5))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(integer=True, steps=[1, 2, 5, 10]))
    axes.grid(alpha=0.3)
    axes.set_axisbelow(True)
