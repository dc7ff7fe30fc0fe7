"""What the metrics see of a run: per query its best match, and whether that match is right.

This is the one place that says what becomes of a query without a true match:

``exclude``
    It is dropped before anything is counted.
``miss``
    It is a place that was not found, whatever is answered: it stays in every denominator, that of recall
    included, so that recall cannot reach 1, and an answer to it is a false positive.
``reject``
    It is a true negative: it is not in the denominator of recall, an answer to it is a false positive above
    the threshold and right to be rejected below it, and to answer nothing is right.

========================  ============  ==========  ===================
what                      exclude       miss        reject
========================  ============  ==========  ===================
denominator of recall     not counted   counted     not counted
an answer, in precision   not counted   wrong       wrong
an answer, in roc_auc     not counted   a negative  a negative
in accuracy               not counted   wrong       right if unanswered
its pairs                 not counted   negatives   negatives
========================  ============  ==========  ===================

An answer that is a soft match, neither right nor wrong, is passed over: the next one moves up, and counts.

``miss`` and ``reject`` therefore coincide for ``pr_auc_matched``, ``average_precision``, ``roc_auc`` and
``pr_auc_pairs``. All three coincide where every query has a true match.
"""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import UsageError, closest
from vpr_bench.metrics.counts import Counts
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Unmatched

NEVER = int(np.iinfo(np.int64).max)
"""The rank of a query whose answers hold no correct reference; larger than every k."""


@dataclass(frozen=True, eq=False)
class Answers:
    """One row per query that counts; the input of every metric.

    Every metric is a function of this: its result has the leading shape of ``weight``, a number for a run and
    one number per resample in a bootstrap.

    Attributes
    ----------
    correct : (n,) bool
        The best match lies in the query's ground truth.
    score : (n,) float64
        Score of the best match, higher is better; -inf where the method answered nothing.
    has_match : (n,) bool
        The query has at least one true match.
    rank : (n,) int64
        Position of the first correct reference among the ranked answers, from 0; ``NEVER`` when none.
    unmatched : {"exclude", "miss", "reject"}
        Policy for queries without a true match, as explained at the top of this module.
    depth : int
        How many answers per query are known; a recall@K deeper than that cannot be.
    weight : (..., n) float64
        How often each query counts; ones unless resampled. Whole numbers, so that sums are exact.
    queries : (n,) int64
        Which query each row is about, in the numbering of the query traverse; 0 to n - 1 unless given.

    Examples
    --------
    >>> truth = GroundTruth.from_lists([[0], [1, 2], []], n_references=3)
    >>> indices, scores = np.array([[0, 1], [0, 2], [1, 0]]), np.array([[0.9, 0.1], [0.8, 0.7], [0.3, 0.2]])
    >>> answers = Answers.from_matches(indices, scores, truth, unmatched="exclude")
    >>> answers.correct.tolist(), answers.rank.tolist()
    ([True, False], [0, 1])
    """

    correct: NDArray[np.bool_]
    score: NDArray[np.float64]
    has_match: NDArray[np.bool_]
    rank: NDArray[np.int64]
    unmatched: Unmatched = "exclude"
    depth: int = NEVER
    weight: NDArray[np.float64] = field(default_factory=lambda: np.ones(()))
    queries: NDArray[np.int64] = field(default_factory=lambda: np.zeros((), np.int64))

    def __post_init__(self) -> None:
        """Check that the columns belong together, and give every query the weight 1 if none is given."""
        if self.unmatched not in get_args(Unmatched):
            known = get_args(Unmatched)
            raise UsageError(f"Unknown unmatched policy {self.unmatched!r}. {closest(self.unmatched, known)}")
        shape = self.correct.shape
        if len(shape) != 1 or not shape == self.score.shape == self.has_match.shape == self.rank.shape:
            raise ValueError("correct, score, has_match and rank must all have shape (n,)")
        if np.isnan(self.score).any():
            raise ValueError("the score of a match must be a number. Got NaN.")
        if self.weight.ndim == 0:
            object.__setattr__(self, "weight", np.ones(shape))
        if self.weight.shape[-1:] != shape:
            raise ValueError(f"weight must have shape (..., {shape[0]}). Got {self.weight.shape} instead.")
        if self.queries.ndim == 0:
            object.__setattr__(self, "queries", np.arange(*shape, dtype=np.int64))
        if self.queries.shape != shape:
            raise ValueError(f"queries must have shape {shape}. Got {self.queries.shape} instead.")

    @classmethod
    def from_matches(
        cls,
        indices: NDArray[np.int64],
        scores: NDArray[np.floating],
        ground_truth: GroundTruth,
        unmatched: Unmatched = "exclude",
        queries: NDArray[np.int64] | None = None,
    ) -> "Answers":
        """Judge the stored matches of a run.

        Parameters
        ----------
        indices : (n_queries, k) int64
            Ranked references, best first; a query with fewer answers is padded with -1.
        scores : (n_queries, k) float
            Their scores, higher is better; padded with -inf.
        ground_truth : GroundTruth
            Of the same queries.
        unmatched : {"exclude", "miss", "reject"}
            Policy for queries without a true match.
        queries : (n_queries,) int64, optional
            Which they are, in the numbering of the query traverse; by default the first.

        Raises
        ------
        ValueError
            If shapes differ or an index is outside the map.
        UsageError
            If all answers to a query are soft matches, so that its first answer that counts is not known.
        """
        n, n_references = ground_truth.n_queries, ground_truth.n_references
        if indices.ndim != 2 or indices.shape != scores.shape or indices.shape[1] == 0 or len(indices) != n:
            raise ValueError(
                f"indices and scores must both have shape ({n}, k), one row per query of the ground truth. "
                f"Got {indices.shape} and {scores.shape} instead."
            )
        if indices.size and (indices.min() < -1 or indices.max() >= n_references):
            raise ValueError(f"reference indices must lie in [0, {n_references}), or be -1 for no answer")
        k = indices.shape[1]
        cut_off = (indices[:, -1] >= 0) & (k < n_references)
        indices, scores = without_soft(indices, scores, ground_truth)
        known = (indices >= 0).sum(axis=1)[cut_off].min(initial=NEVER)
        if known == 0:
            raise UsageError(f"All {k} answers to a query are soft matches: what comes next is not known. Raise --k.")
        hits = ground_truth.contains(np.arange(n)[:, None], indices)
        answers = cls(
            correct=hits[:, 0],
            score=np.where(indices[:, 0] >= 0, scores[:, 0], -np.inf).astype(np.float64),
            has_match=ground_truth.has_match,
            rank=np.where(hits.any(axis=1), hits.argmax(axis=1), NEVER),
            unmatched=unmatched,
            depth=int(known),
            queries=np.arange(n) if queries is None else queries,
        )
        return answers.take(np.flatnonzero(answers.has_match)) if unmatched == "exclude" else answers

    def __len__(self) -> int:
        """Return the number of queries that count."""
        return len(self.correct)

    def take(self, queries: NDArray[np.int64]) -> "Answers":
        """Return the given rows, in that order; a row named twice counts twice."""
        return replace(
            self,
            correct=self.correct[queries],
            score=self.score[queries],
            has_match=self.has_match[queries],
            rank=self.rank[queries],
            weight=self.weight[..., queries],
            queries=self.queries[queries],
        )

    @property
    def answered(self) -> NDArray[np.bool_]:
        """(n,) bool: whether the method named any reference."""
        return self.score > -np.inf

    @property
    def expected(self) -> NDArray[np.bool_]:
        """(n,) bool: whether the query is in the denominator of recall."""
        return np.ones_like(self.has_match) if self.unmatched == "miss" else self.has_match

    def total(self, queries: NDArray[np.bool_]) -> NDArray[np.float64]:
        """(...) float64: the weight of the queries where the (n,) bool mask holds."""
        return np.asarray(self.weight @ queries.astype(np.float64))

    @cached_property
    def counts(self) -> Counts:
        """True and false positives at every threshold; shared by the metrics that sweep one."""
        answered = self.answered
        return Counts.sweep(self.correct[answered], self.score[answered], self.weight[..., answered])


def without_soft(
    indices: NDArray[np.int64], scores: NDArray[np.floating], ground_truth: GroundTruth
) -> tuple[NDArray[np.int64], NDArray[np.floating]]:
    """Take soft matches out of ranked answers, so that the first column holds the answers that count.

    Parameters
    ----------
    indices, scores : (n_queries, k)
        As in :meth:`Answers.from_matches`.
    ground_truth : GroundTruth
        Of the same queries.

    Returns
    -------
    indices, scores : (n_queries, k)
        The other answers moved up, and the end padded.
    """
    if ground_truth.soft is None:
        return indices, scores
    passed_over = ground_truth.soft.contains(np.arange(len(indices))[:, None], indices)
    order = np.argsort(passed_over, axis=1, kind="stable")
    gone = np.take_along_axis(passed_over, order, axis=1)
    indices = np.where(gone, -1, np.take_along_axis(indices, order, axis=1))
    return indices, np.where(gone, -np.inf, np.take_along_axis(scores, order, axis=1))
