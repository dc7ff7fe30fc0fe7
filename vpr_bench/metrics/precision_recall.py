"""Precision and recall of the best match while the threshold on its score falls.

Ties are exact: one point per distinct score. No point is interpolated or sampled, so the values do not change
under a strictly monotone rescaling of the scores. Where no query has a true match, everything here is NaN;
where there are such queries and none is answered right, everything is 0.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.counts import Counts, ratio


class Curve(NamedTuple):
    """Points of a precision-recall curve from the start at (0, 1) on: recall never falls.

    Attributes
    ----------
    recall, precision : (..., t + 1) float64
        In [0, 1].
    thresholds : (t + 1,) float64
        Lowest score accepted at each point, descending from inf.
    """

    recall: NDArray[np.float64]
    precision: NDArray[np.float64]
    thresholds: NDArray[np.float64]


def precision_recall_curve(answers: Answers) -> Curve:
    """Sweep the threshold over every distinct score; recall is over the queries that have a true match.

    A query answered wrongly costs recall, so the curve ends at recall@1 and not at 1.

    Examples
    --------
    >>> column = np.array([True, False, True])
    >>> answers = Answers(column, np.array([0.9, 0.8, 0.7]), np.ones(3, bool), np.zeros(3, int))
    >>> curve = precision_recall_curve(answers)
    >>> curve.recall.round(2).tolist(), curve.precision.round(2).tolist()
    ([0.0, 0.33, 0.33, 0.67], [1.0, 1.0, 0.5, 0.67])
    """
    counts = answers.counts
    recall = ratio(counts.true_positives, answers.total(answers.expected)[..., None])
    thresholds = np.concatenate([[np.inf], counts.thresholds])
    return Curve(_starting_at(0.0, recall), _starting_at(1.0, counts.precision), thresholds)


def pr_auc(answers: Answers) -> NDArray[np.float64]:
    """Area under :func:`precision_recall_curve` by the trapezoid rule, in [0, 1]; our headline."""
    return _over(answers, _trapezoid(answers.counts), answers.total(answers.expected))


def pr_auc_matched(answers: Answers) -> NDArray[np.float64]:
    """Area as VPR-Bench and Region-VLAD compute it, in [0, 1]: recall is over the queries answered right.

    It is scikit-learn's ``precision_recall_curve(correct, score)`` and then ``auc``, apart from one value:
    where nothing is answered right scikit-learn sets recall to 1 and arrives at 0.5, and we say 0.
    The curve always reaches recall 1, so wrong answers with low scores cost nothing:
    ``pr_auc == pr_auc_matched * recall@1``.
    """
    return _over(answers, _trapezoid(answers.counts), answers.total(answers.correct))


def average_precision(answers: Answers) -> NDArray[np.float64]:
    """Mean of the precision over the queries answered right, in [0, 1].

    It is scikit-learn's ``average_precision_score(correct, score)``.
    """
    counts = answers.counts
    steps = np.diff(counts.true_positives, axis=-1, prepend=0.0)
    return _over(answers, (steps * counts.precision).sum(axis=-1), answers.total(answers.correct))


def recall_at_100_precision(answers: Answers) -> NDArray[np.float64]:
    """Highest recall that is reached before the first wrong answer, in [0, 1].

    A wrong answer that ties with right ones takes them all away.
    """
    counts = answers.counts
    flawless = np.where(counts.false_positives == 0, counts.true_positives, 0.0).max(axis=-1, initial=0.0)
    return _over(answers, flawless, answers.total(answers.expected))


def _trapezoid(counts: Counts) -> NDArray[np.float64]:
    """(...) float64: area with true positives, not recall, along the axis; from precision 1 on."""
    steps = np.diff(counts.true_positives, axis=-1, prepend=0.0)
    precision = _starting_at(1.0, counts.precision)
    return np.asarray((steps * (precision[..., :-1] + precision[..., 1:])).sum(axis=-1) / 2)


def _starting_at(start: float, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """(..., t + 1) float64: the values with one more in front."""
    return np.concatenate([np.full((*values.shape[:-1], 1), start), values], axis=-1)


def _over(answers: Answers, area: NDArray[np.float64], whole: NDArray[np.float64]) -> NDArray[np.float64]:
    """Divide by the denominator of recall: 0 where nothing is right, NaN where nothing could be."""
    possible = answers.total(answers.expected) > 0
    return np.where(possible, ratio(area, whole, undefined=0.0), np.nan)[()]
