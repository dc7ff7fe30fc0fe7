"""The precision-recall curve of a run as a picture."""

from collections.abc import Sequence
from pathlib import Path

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.precision_recall import pr_auc, precision_recall_curve
from vpr_bench.report.figure import FORMATS, diagram
from vpr_bench.report.rows import Row
from vpr_bench.types.protocol import Protocol


def draw_curve(rows: Sequence[Row], folder: Path) -> list[Path]:
    """Draw the curves of one run, one per radius, as ``precision_recall.png`` and ``.svg``.

    Parameters
    ----------
    rows : sequence of Row
        Of the same run, on protocols that differ in the radius.
    folder : Path
        Where to write.

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    DataError
        If they cannot be written.
    """
    files = [folder / f"precision_recall.{kind}" for kind in FORMATS]
    with diagram(5.6, 4.6, *files) as figure:
        axes = figure.add_subplot()
        for row in rows:
            truth = row.run.places.ground_truth(row.protocol)
            answers = Answers.from_matches(row.run.indices, row.run.scores, truth, row.protocol.unmatched)
            curve = precision_recall_curve(answers)
            axes.plot(
                curve.recall,
                curve.precision,
                linewidth=2,
                label=f"{_reach(row.protocol)}: pr_auc {pr_auc(answers):.3f}",
            )
        axes.set(xlabel="recall", ylabel="precision", xlim=(0, 1), ylim=(0, 1.02))
        where = rows[0].protocol if len(rows) == 1 else f"{rows[0].protocol.source}/{rows[0].protocol.pairing}"
        axes.set_title(f"{rows[0].method}\n{where}", fontsize=10, loc="left")
        axes.grid(alpha=0.3)
        axes.legend(loc="best")
    return files


def _reach(protocol: Protocol) -> str:
    unit = {"f": "frames", "m": "metres"}.get(protocol.unit)
    return f"radius {protocol.radius:g} {unit}" if unit else protocol.reach
