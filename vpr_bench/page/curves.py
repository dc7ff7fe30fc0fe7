"""What the charts of one run are drawn from, computed from its stored answers."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.losses import Step, losses
from vpr_bench.metrics.precision_recall import pr_auc, precision_recall_curve
from vpr_bench.metrics.ranking import recall_at_k
from vpr_bench.page.radii import drawn
from vpr_bench.report.rows import answers_of
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol

DEEPEST = 20
"""The largest k of the recall@k that are drawn."""

POINTS = 150
"""How many points of a curve are drawn at most; of more, some are left out evenly."""

LEVELS = (0.1, 0.25, 0.5, 0.75, 0.9)
"""The recalls at which precision is looked up."""


@dataclass(frozen=True)
class AtRadius:
    """A run at one radius.

    Attributes
    ----------
    radius : float
        In the protocol's unit.
    recall, precision : list of float
        The curve, thinned.
    recall_at_1, pr_auc : float
        In [0, 1]; NaN where no query has a true match.
    """

    radius: float
    recall: list[float]
    precision: list[float]
    recall_at_1: float
    pr_auc: float


@dataclass(frozen=True)
class Curves:
    """Everything that is drawn of one run.

    Attributes
    ----------
    at : list of AtRadius
        By ascending radius.
    recalls : list of float
        recall@1, recall@2 …, as deep as answers are known.
    reached : list of float
        The best precision at which recall is at least 0.1, 0.25, 0.5, 0.75 and 0.9; NaN where it never is.
    steps : list of Step
        Where the right place was lost; empty for most methods.
    """

    at: list[AtRadius]
    recalls: list[float]
    reached: list[float]
    steps: list[Step]

    def as_dict(self) -> dict[str, Any]:
        """Return what the page's script needs, rounded to what can be seen."""
        return {
            "curves": [[_rounded(one.recall), _rounded(one.precision)] for one in self.at],
            "radii": [one.radius for one in self.at],
            "recall@1": _rounded([one.recall_at_1 for one in self.at]),
            "pr_auc": _rounded([one.pr_auc for one in self.at]),
            "recalls": _rounded(self.recalls),
            "steps": [[step.name, *_rounded([step.lost.value, step.recall.value])] for step in self.steps],
        }


def curves_of(run: StoredRun, protocol: Protocol) -> Curves:
    """Compute what is drawn of a run.

    Raises
    ------
    UsageError
        If the run's places do not say what is right in this protocol.
    DataError
        If they cannot be read.
    """
    answers = answers_of(run, protocol)
    curve = precision_recall_curve(answers)
    deepest = min(DEEPEST, answers.depth, run.indices.shape[1])
    steps: list[Step] = []
    if run.survivors:
        truth = run.places.ground_truth(protocol)
        steps = losses(run.survivors, run.indices, run.scores, truth, protocol.unmatched)
    return Curves(
        [_at(one.radius, answers_of(run, one)) for one in drawn(protocol, run.places)],
        [float(recall_at_k(answers, k)) for k in range(1, deepest + 1)],
        [_highest(curve.precision[curve.recall >= level]) for level in LEVELS],
        steps,
    )


def _highest(values: NDArray[np.float64]) -> float:
    return float(values.max()) if len(values) else math.nan


def _at(radius: float, answers: Answers) -> AtRadius:
    curve = precision_recall_curve(answers)
    shown = np.unique(np.linspace(0, len(curve.recall) - 1, POINTS).round().astype(np.int64))
    recall, precision = curve.recall[shown].tolist(), curve.precision[shown].tolist()
    return AtRadius(radius, recall, precision, float(recall_at_k(answers, 1)), float(pr_auc(answers)))


def _rounded(values: list[float]) -> list[float]:
    return [round(value, 4) for value in values]
