"""The metrics by name: what each id means and how it is computed."""

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import UsageError, closest
from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.pairs import pr_auc_pairs_of_matches
from vpr_bench.metrics.precision_recall import (
    average_precision,
    pr_auc,
    pr_auc_matched,
    recall_at_100_precision,
)
from vpr_bench.metrics.ranking import accuracy, recall_at_k, roc_auc
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Unmatched


@dataclass(frozen=True)
class Metric:
    """One metric: higher is better, in [0, 1], NaN where it is undefined.

    Attributes
    ----------
    id : str
        The name used on the command line, in results and in tables.
    definition : str
        One line that says exactly what is computed.
    function : callable, optional
        From answers to the value; None if the answers do not suffice (``pr_auc_pairs``).
    """

    id: str
    definition: str
    function: Callable[[Answers], NDArray[np.float64]] | None


def _recall_at(k: int) -> Metric:
    first = "first answer" if k == 1 else f"first {k} answers"
    definition = f"share of the queries with a true match that have one among the {first}"
    return Metric(f"recall@{k}", definition, partial(recall_at_k, k=k))


METRICS: dict[str, Metric] = {
    metric.id: metric
    for metric in (
        Metric(
            "pr_auc",
            "area under precision-recall of the best match; recall is over the queries with a true match",
            pr_auc,
        ),
        Metric(
            "pr_auc_matched",
            "the same with recall over the queries answered right, as published by VPR-Bench and others",
            pr_auc_matched,
        ),
        Metric(
            "average_precision",
            "mean precision over the queries answered right, as in scikit-learn",
            average_precision,
        ),
        Metric(
            "pr_auc_pairs",
            "area under precision-recall with every query-reference pair as one decision; needs all scores",
            None,
        ),
        _recall_at(1),
        _recall_at(5),
        _recall_at(10),
        Metric("recall@100p", "highest recall before the first wrong answer", recall_at_100_precision),
        Metric("roc_auc", "chance that a right answer scores higher than a wrong one", roc_auc),
        Metric("accuracy", "share of all queries that end well", accuracy),
    )
}
"""All metrics in the order of listings; :func:`lookup` knows every other ``recall@K`` too."""


def lookup(name: str) -> Metric:
    """Find a metric by its id.

    Raises
    ------
    UsageError
        If there is none of that name.

    Examples
    --------
    >>> lookup("recall@20").definition
    'share of the queries with a true match that have one among the first 20 answers'
    """
    if name in METRICS:
        return METRICS[name]
    recall = re.fullmatch(r"recall@([1-9][0-9]*)", name)
    if recall is None:
        raise UsageError(f"There is no metric {name!r}. {closest(name, METRICS)}")
    return _recall_at(int(recall[1]))


def compute(names: Iterable[str], answers: Answers) -> dict[str, float]:
    """Compute the named metrics; NaN for what is undefined or needs more than the answers.

    Raises
    ------
    UsageError
        If a name is unknown.

    Examples
    --------
    >>> flags = np.array([True, False])
    >>> answers = Answers(flags, np.array([0.9, 0.8]), np.ones(2, bool), np.array([0, 4]))
    >>> compute(["recall@1", "pr_auc", "pr_auc_matched"], answers)
    {'recall@1': 0.5, 'pr_auc': 0.5, 'pr_auc_matched': 1.0}
    """
    functions = {name: lookup(name).function for name in names}
    return {name: float(function(answers)) if function else np.nan for name, function in functions.items()}


def evaluate(
    names: Iterable[str],
    indices: NDArray[np.int64],
    scores: NDArray[np.floating],
    ground_truth: GroundTruth,
    unmatched: Unmatched = "exclude",
) -> dict[str, float]:
    """Compute the named metrics from the stored matches of a run, ``pr_auc_pairs`` among them.

    The parameters are those of :meth:`Answers.from_matches`. ``pr_auc_pairs`` is NaN unless every match ranks
    all references.
    """
    values = compute(names, Answers.from_matches(indices, scores, ground_truth, unmatched))
    if "pr_auc_pairs" in values:
        values["pr_auc_pairs"] = pr_auc_pairs_of_matches(indices, scores, ground_truth, unmatched)
    return values
