"""Draw one query on its way through both stages: ``python docs/results/stages.py MAP``.

The map is what ``vpr-bench fit --method twostage --dataset gardens:simulated -o MAP`` makes.
"""

import sys
from pathlib import Path

import numpy as np
from cells import HERE
from matplotlib.axes import Axes
from numpy.typing import NDArray

from vpr_baselines.spatial.cells import Cells, from_bytes
from vpr_baselines.twostage.method import TwoStage
from vpr_baselines.twostage.shared import SharedSystem
from vpr_bench import load_case
from vpr_bench.report.figure import diagram
from vpr_bench.report.ink import AMBER, BLUE, GREEN, GREY, PALE

QUERY = 112
_CANDIDATES = 21


def draw(method: TwoStage, file: Path) -> None:
    """Draw what becomes of a query of the simulated walk."""
    case = load_case("gardens:simulated")
    system = method.system_
    assert isinstance(system, SharedSystem)  # noqa: S101
    image = case.queries[QUERY]
    query = system.encode(image)
    logits = system.rank(query)
    triggered = np.argsort(-logits, kind="stable")[: method.n_components]
    answers = system.answers(query, triggered, None)
    candidates = answers.most_likely(logits, _CANDIDATES)
    similarities = system.similarities(query, candidates)
    best = int(candidates[similarities.argmax()])
    with diagram(12, 5.6, file) as figure:
        top, bottom = figure.subplots(2, 3, width_ratios=[1, 1.25, 1.25])
        _picture(top[0], image, f"the query: frame {QUERY}, by night")
        _picture(bottom[0], case.references[best], f"the answer: reference {best}, by day")
        _bars(
            top[1], np.arange(len(logits)), np.exp(logits - logits.max()), triggered, BLUE, "1  stage one: which part?"
        )
        top[1].set(xlabel="cluster along the route", ylabel="relative probability")
        likely = np.exp(logits[answers.components] - logits.max()) * answers.probabilities
        _bars(
            top[2],
            answers.references,
            likely,
            np.flatnonzero(np.isin(answers.references, candidates)),
            AMBER,
            "2  components: which image?",
        )
        top[2].set(xlabel="reference", ylabel="probability, cluster × image")
        _bars(
            bottom[1], candidates, similarities, np.flatnonzero(candidates == best), GREEN, "3  cells: do they agree?"
        )
        bottom[1].set(xlabel="reference", ylabel="similarity")
        assert query.cells is not None  # noqa: S101
        _matches(bottom[2], system, query.cells, best)


def _picture(axes: Axes, image: NDArray[np.uint8], title: str) -> None:
    axes.imshow(image)
    axes.set_axis_off()
    axes.set_title(title, fontsize=10, loc="left")


def _bars(
    axes: Axes,
    places: NDArray[np.int64],
    heights: NDArray[np.floating],
    chosen: NDArray[np.int64],
    colour: str,
    title: str,
) -> None:
    colours = np.full(len(places), GREY, dtype=object)
    colours[chosen] = colour
    axes.bar(places, heights, color=list(colours), width=0.8)
    axes.set_title(title, fontsize=10, loc="left")
    axes.spines[["top", "right"]].set_visible(False)


def _matches(axes: Axes, system: SharedSystem, cells: Cells, best: int) -> None:
    """Draw the displacement of every mutual match; those about the most frequent one are green."""
    local = system.description.local
    columns = local.shape[1]
    similarity = cells.vectors @ from_bytes(local.vectors[best]).T
    there = similarity.argmax(axis=1)
    mutual = similarity.argmax(axis=0)[there] == np.arange(len(there))
    start = np.stack(np.divmod(cells.positions[mutual], columns), axis=1)
    end = np.stack(np.divmod(local.positions[best][there[mutual]].astype(np.int64), columns), axis=1)
    moved = end - start
    kinds, votes = np.unique(moved, axis=0, return_counts=True)
    agree = np.abs(moved - kinds[votes.argmax()]).max(axis=1) <= 1
    for these, colour in ((~agree, GREY), (agree, GREEN)):
        axes.quiver(
            start[these, 1],
            start[these, 0],
            moved[these, 1],
            moved[these, 0],
            color=colour,
            angles="xy",
            scale_units="xy",
            scale=1,
            width=0.004,
        )
    axes.set(xlim=(-1, columns), ylim=(local.shape[0], -1), aspect="equal", facecolor=PALE, xticks=[], yticks=[])
    axes.set_title(f"{agree.sum()} of {len(agree)} matched cells agree", fontsize=10, loc="left")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("Usage: python docs/results/stages.py MAP")
    fitted = TwoStage()
    fitted.load(Path(sys.argv[1]) / "state")
    draw(fitted, HERE / "stages.png")
