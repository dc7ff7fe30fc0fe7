"""Whether answers are right, many at once; what Gymnasium calls the reward."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Unmatched


@dataclass(frozen=True, eq=False)
class Judgement:
    """What became of ``n`` answers.

    Attributes
    ----------
    answer : (n,) int64
        The reference that counts: the first that is not a soft match; -1 if none was named.
    correct : (n,) bool
        Whether it lies in the query's ground truth.
    has_match : (n,) bool
        Whether the query has a true match at all.
    truth : (n, m) int64
        The references that are right, ascending, padded with -1 to the most that any query has.
    reward : (n,) float64
        1 for a right answer, else 0. Where queries without a match are to be rejected, to answer nothing to one of
        them is right too, as the metric ``accuracy`` has it.
    """

    answer: NDArray[np.int64]
    correct: NDArray[np.bool_]
    has_match: NDArray[np.bool_]
    truth: NDArray[np.int64]
    reward: NDArray[np.float64]


class Judge:
    """Compares answers with a ground truth.

    Parameters
    ----------
    ground_truth : GroundTruth
        Of all queries.
    unmatched : {"exclude", "miss", "reject"}
        Policy for queries without a true match.

    Examples
    --------
    >>> judge = Judge(GroundTruth.from_radius([0, 5], [0, 1, 5, 9], radius=1), "exclude")
    >>> judged = judge(np.array([0, 1]), np.array([[1, 0], [0, 2]]))
    >>> judged.correct.tolist(), judged.truth.tolist()
    ([True, False], [[0, 1], [2, -1]])
    """

    def __init__(self, ground_truth: GroundTruth, unmatched: Unmatched) -> None:
        self._right = _Rows(ground_truth)
        self._soft = None if ground_truth.soft is None else _Rows(ground_truth.soft)
        self._rejects = unmatched == "reject"

    def __call__(self, queries: NDArray[np.int64], indices: NDArray[np.int64]) -> Judgement:
        """Judge the (n, k) ranked ``indices`` that were answered to the (n,) ``queries``."""
        counts = indices >= 0
        if self._soft is not None:
            counts &= ~(indices[:, :, None] == self._soft.of(queries)[:, None, :]).any(axis=2)
        first = indices[np.arange(len(indices)), counts.argmax(axis=1)]
        answer = np.where(counts.any(axis=1), first, -1)
        truth = self._right.of(queries)
        correct = (answer >= 0) & (truth == answer[:, None]).any(axis=1)
        has_match = truth[:, 0] >= 0
        well = correct | ~(has_match | (answer >= 0)) if self._rejects else correct
        return Judgement(answer, correct, has_match, truth, well.astype(np.float64))


class _Rows:
    """The references of each query as rows of one length."""

    def __init__(self, truth: GroundTruth) -> None:
        self._first, self._references = truth.offsets[:-1], truth.references
        self._lengths = np.diff(truth.offsets)
        self._columns = np.arange(max(1, int(self._lengths.max(initial=0))))

    def of(self, queries: NDArray[np.int64]) -> NDArray[np.int64]:
        """Return the references of some queries, (n, m), each row padded with -1."""
        inside = self._columns < self._lengths[queries, None]
        rows = np.full(inside.shape, -1, dtype=np.int64)
        rows[inside] = self._references[(self._first[queries, None] + self._columns)[inside]]
        return rows
