"""Area under precision-recall with every query-reference pair as one decision, exactly, at any size.

Recall changes only at the scores of the true pairs, so the curve is known from how many false pairs lie at or
above, and how many strictly above, each of those scores. Two passes over the scores are enough: the first
collects the scores of the true pairs, the second sorts each block of scores and looks the true ones up in it.
Memory grows with the true pairs and one block per thread, and not with the pairs.
"""

from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from functools import partial

import numpy as np
from numpy.typing import NDArray

from vpr_bench.cores import available_cores
from vpr_bench.metrics.counts import ratio
from vpr_bench.progress import track
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Unmatched

Scores = Callable[[slice], NDArray[np.float32]]
"""From a slice of queries (no step) to their (rows, n_references) float32 scores, higher is better.

It is called twice with the same slices, from several threads, and must answer the same. A pair that the
method did not consider scores -inf: it is never retrieved.
"""

BLOCK_ELEMENTS = 1 << 24
"""Scores per block (64 MiB): large enough that the look-up of the true scores costs less than the sorting."""

MAX_THREADS = 8
"""Bounds the number of blocks in memory."""


def pr_auc_pairs(
    scores: Scores, ground_truth: GroundTruth, unmatched: Unmatched = "exclude", threads: int | None = None
) -> float:
    """Compute the area by the trapezoid rule; one threshold per distinct score, from (R=0, P=1) on.

    Recall is over all true pairs. This is what the tutorial of Schubert et al. (Visual Place Recognition: A
    Tutorial, 2023) calls multi-match, there with evenly spaced thresholds and here with all of them.

    Parameters
    ----------
    scores : callable
        From a slice of queries to their scores, see ``Scores``.
    ground_truth : GroundTruth
        Its soft pairs are left out.
    unmatched : {"exclude", "miss", "reject"}
        Whether the pairs of queries without a true match are left out (``exclude``) or are negatives.
    threads : int, optional
        Blocks worked on at once; by default one per core, at most 8. BLAS is held to one thread meanwhile.

    Returns
    -------
    float
        In [0, 1]; NaN if there is no true pair.

    Raises
    ------
    ValueError
        If a score is NaN, or a block has the wrong shape.

    Examples
    --------
    >>> table = np.array([[0.9, 0.1], [0.8, 0.7]], dtype=np.float32)
    >>> truth = GroundTruth.from_lists([[0], [1]], n_references=2)
    >>> round(pr_auc_pairs(lambda rows: table[rows], truth), 3)  # (0, 1), (.5, 1), (.5, .5), (1, .67)
    0.792
    """
    if len(ground_truth.references) == 0:
        return float("nan")
    from threadpoolctl import threadpool_limits

    rows_per_block = max(1, BLOCK_ELEMENTS // ground_truth.n_references)
    starts = range(0, ground_truth.n_queries, rows_per_block)
    blocks = [slice(start, min(start + rows_per_block, ground_truth.n_queries)) for start in starts]
    threads = threads or min(available_cores(), MAX_THREADS)
    with threadpool_limits(1, user_api="blas"), ThreadPoolExecutor(threads) as pool:
        found = pool.map(partial(_true_scores, scores, ground_truth), blocks)
        true_scores = np.concatenate(list(track(found, "Scoring true pairs", total=len(blocks))))
        thresholds, true_at = np.unique(true_scores[true_scores > -np.inf], return_counts=True)
        counted = pool.map(partial(_false_counts, scores, ground_truth, unmatched, thresholds), blocks)
        counted = track(counted, "Ranking false pairs", total=len(blocks))
        false_from, false_above = _sum(counted, len(thresholds))
    return _area(true_at[::-1], false_from[::-1], false_above[::-1], len(true_scores))


def pr_auc_pairs_of_matches(
    indices: NDArray[np.int64],
    scores: NDArray[np.floating],
    ground_truth: GroundTruth,
    unmatched: Unmatched = "exclude",
) -> float:
    """Compute :func:`pr_auc_pairs` from stored matches; NaN unless every match ranks all references.

    Parameters
    ----------
    indices : (n_queries, n_references) int64
        Ranked references of each query.
    scores : (n_queries, n_references) float
        Their scores.
    """
    if indices.shape[1] != ground_truth.n_references or (indices < 0).any():
        return float("nan")

    def in_order_of_references(rows: slice) -> NDArray[np.float32]:
        block = np.empty(indices[rows].shape, dtype=np.float32)
        np.put_along_axis(block, indices[rows], scores[rows].astype(np.float32), axis=1)
        return block

    return pr_auc_pairs(in_order_of_references, ground_truth, unmatched)


def _read(scores: Scores, ground_truth: GroundTruth, rows: slice) -> tuple[NDArray[np.float32], NDArray[np.int64]]:
    """Return the (rows, n_references) scores of a block and the flat positions of its true pairs."""
    block = np.asarray(scores(rows), dtype=np.float32)
    shape = (rows.stop - rows.start, ground_truth.n_references)
    if block.shape != shape:
        raise ValueError(f"the scores of queries {rows} must have shape {shape}. Got {block.shape} instead.")
    return block, _positions(ground_truth, rows)


def _positions(pairs: GroundTruth, rows: slice) -> NDArray[np.int64]:
    """Return where the pairs of some queries lie in their flattened block of scores."""
    offsets = pairs.offsets[rows.start : rows.stop + 1]
    local = np.repeat(np.arange(rows.stop - rows.start), np.diff(offsets))
    return np.asarray(local * pairs.n_references + pairs.references[offsets[0] : offsets[-1]])


def _true_scores(scores: Scores, ground_truth: GroundTruth, rows: slice) -> NDArray[np.float32]:
    block, true_pairs = _read(scores, ground_truth, rows)
    found = block.reshape(-1)[true_pairs]
    _refuse_nan(found)
    return found


def _false_counts(
    scores: Scores,
    ground_truth: GroundTruth,
    unmatched: Unmatched,
    thresholds: NDArray[np.float32],
    rows: slice,
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Count the false pairs of a block at or above, and strictly above, each ascending threshold."""
    block, true_pairs = _read(scores, ground_truth, rows)
    false = block.flatten()
    false[true_pairs] = -np.inf
    if ground_truth.soft is not None:
        false[_positions(ground_truth.soft, rows)] = -np.inf
    if unmatched == "exclude":
        false.reshape(block.shape)[~ground_truth.has_match[rows]] = -np.inf
    del block
    false.sort()
    _refuse_nan(false[-1:])  # NaN sorts last
    below = np.searchsorted(false, thresholds, side="left")
    not_above = below.copy()
    tied = np.flatnonzero(false[np.minimum(below, len(false) - 1)] == thresholds)
    not_above[tied] = np.searchsorted(false, thresholds[tied], side="right")
    return len(false) - below, len(false) - not_above


def _refuse_nan(scores: NDArray[np.float32]) -> None:
    if np.isnan(scores).any():
        raise ValueError("the score of a pair must be a number. Got NaN.")


def _sum(
    counts: Iterable[tuple[NDArray[np.int64], NDArray[np.int64]]], length: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    first, second = np.zeros(length, dtype=np.int64), np.zeros(length, dtype=np.int64)
    for one, other in counts:
        first += one
        second += other
    return first, second


def _area(
    true_at: NDArray[np.int64], false_from: NDArray[np.int64], false_above: NDArray[np.int64], n_true: int
) -> float:
    """Integrate over (t,) int64 counts by descending threshold.

    ``true_at`` counts the true pairs at the threshold, ``false_from`` the false pairs at or above it and
    ``false_above`` those above it. On the way from one true score down to the next only false pairs come in:
    recall stands still and precision falls, so each trapezoid starts just above its threshold.
    """
    true_from = np.cumsum(true_at)
    true_above = true_from - true_at
    before = ratio(true_above.astype(float), (true_above + false_above).astype(float), undefined=1.0)
    after = true_from / (true_from + false_from)
    return float((true_at * (before + after)).sum() / 2 / n_true)
