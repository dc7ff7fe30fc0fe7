"""Where the right place was lost: after each step of answering, for how many queries it was still in the running.

Everything is a share of the queries in the denominator of recall, so that the shares follow on from recall@1 and obey
the policy for queries without a true match. A query counts as long as one of its true matches is left; soft matches,
neither right nor wrong, keep no query in the running. What a step loses is the share before it minus the share after
it, and the last step of all is the ranking of what is left, after which the share is recall@1:

    1 = lost by the first step + ... + lost by the ranking of what is left + recall@1
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.bootstrap import Interval, bootstrap, bootstrap_difference
from vpr_bench.metrics.definitions import compute
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Unmatched
from vpr_bench.types.survivors import Survivors

NO_MATCH = "no true match"
"""The step before all others, under the policy ``miss``: the map does not show the place at all."""

RANKING = "ranking"
"""The step behind all others: putting one of those that are left first."""

_FOUND = "recall@1"


@dataclass(frozen=True)
class Step:
    """What one step of answering left, and lost.

    Attributes
    ----------
    name : str
        As the method calls it, ``NO_MATCH`` or ``RANKING``.
    left : float
        References in the running after it, mean over the queries that count; NaN without queries.
    recall : Interval
        Share of the queries whose right place is still in the running, in [0, 1]; NaN without queries.
    lost : Interval
        By how much the step lowered that share. Without a bootstrap, intervals have NaN for their bounds.
    """

    name: str
    left: float
    recall: Interval
    lost: Interval


def losses(
    survivors: Sequence[Survivors],
    indices: NDArray[np.int64],
    scores: NDArray[np.floating],
    ground_truth: GroundTruth,
    unmatched: Unmatched = "exclude",
    resamples: int = 0,
) -> list[Step]:
    """Follow the right places through the steps of answering.

    Parameters
    ----------
    survivors : sequence of Survivors
        What each step left, first step first.
    indices, scores : (n_queries, k)
        The stored matches, as in :meth:`Answers.from_matches`.
    ground_truth : GroundTruth
        Of the same queries.
    unmatched : {"exclude", "miss", "reject"}
        Policy for queries without a true match.
    resamples : int
        Of the bootstrap over queries, with intervals as in :func:`vpr_bench.metrics.bootstrap.bootstrap`. The loss is
        a paired difference: both its shares are of the same draws. 0 for none.

    Returns
    -------
    list of Step
        One for each step, and the ranking of what is left; none if there is no step. With queries that ``miss``
        has no true match for, ``NO_MATCH`` comes first.

    Examples
    --------
    >>> truth = GroundTruth.from_lists([[0], [1], [2], [3]], n_references=4)
    >>> kept = np.array([0, 1, 1, 2, 0, 1], dtype=np.int32)
    >>> step = Survivors("clusters", np.full(4, True), np.array([0, 2, 3, 4, 6]), kept)  # loses the last place only
    >>> indices, scores = np.array([[1], [1], [2], [0]]), np.ones((4, 1))
    >>> [(one.name, one.left, one.recall.value, one.lost.value) for one in losses([step], indices, scores, truth)]
    [('clusters', 1.5, 0.75, 0.25), ('ranking', 1.0, 0.5, 0.25)]
    """
    if not survivors:
        return []
    found = ground_truth.has_match
    left = np.full(ground_truth.n_queries, ground_truth.n_references)
    counted = found | (unmatched == "miss")
    stages = [(NO_MATCH, left, _answers(found, ground_truth, unmatched))]
    for one in survivors:
        found = np.where(one.narrowed, found & _kept(one, ground_truth), found)
        left = np.where(one.narrowed, one.sizes, left)
        stages.append((one.step, left, _answers(found, ground_truth, unmatched)))
    answered = Answers.from_matches(indices, scores, ground_truth, unmatched)
    stages.append((RANKING, (indices[:, 0] >= 0).astype(np.int64), answered))
    before = [_everything(stages[0][2]), *(answers for _, _, answers in stages)]
    steps = [
        Step(name, _mean(left[counted]), _recall(answers, resamples), _loss(former, answers, resamples))
        for (name, left, answers), former in zip(stages, before, strict=False)
    ]
    return steps if steps[0].lost.value > 0 else steps[1:]


def _kept(step: Survivors, truth: GroundTruth) -> NDArray[np.bool_]:
    """(n_queries,) bool: whether a step lists a true match of the query."""
    queries = step.query_of_entry
    right = queries[truth.contains(queries, step.references)]
    return np.bincount(right, minlength=truth.n_queries) > 0


def _answers(found: NDArray[np.bool_], truth: GroundTruth, unmatched: Unmatched) -> Answers:
    """Judge a method that answers rightly wherever ``found`` holds, so that one rule says which queries count."""
    first = np.full(len(found), -1, dtype=np.int64)
    first[found] = truth.references[truth.offsets[:-1][found]]
    return Answers.from_matches(first[:, None], np.where(found, 0.0, -np.inf)[:, None], truth, unmatched)


def _everything(answers: Answers) -> Answers:
    """Return answers that are right for every query in the denominator of recall."""
    return Answers(
        answers.expected, np.zeros(len(answers)), answers.has_match, np.zeros(len(answers), np.int64), answers.unmatched
    )


def _recall(answers: Answers, resamples: int) -> Interval:
    if resamples:
        return bootstrap(answers, [_FOUND], resamples)[_FOUND]
    return Interval(compute([_FOUND], answers)[_FOUND], np.nan, np.nan)


def _loss(before: Answers, after: Answers, resamples: int) -> Interval:
    if resamples:
        return bootstrap_difference(before, after, [_FOUND], resamples)[_FOUND]
    values = [compute([_FOUND], answers)[_FOUND] for answers in (before, after)]
    return Interval(values[0] - values[1], np.nan, np.nan)


def _mean(values: NDArray[np.int64]) -> float:
    return float(values.mean()) if len(values) else float("nan")
