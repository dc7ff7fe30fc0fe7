"""The most coherent stretches of a sequence, so and so many of them."""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.clustering.closeness import Distance, scatter

_PIECE = 800
"""A longer sequence is first cut into even pieces: the work grows with the square of a piece's length."""


def by_count(
    rows: NDArray[np.float32], count: int, distance: Distance, min_size: int = 1, max_size: int | None = None
) -> NDArray[np.int64]:
    """Cut a sequence into ``count`` stretches of least scatter, all sizes within the limits.

    Cutting where neighbours differ most instead makes clusters of one image wherever something passes the camera,
    and leaves others of half the sequence. The optimum is found by dynamic programming (Bellman, "On the
    approximation of curves by line segments using dynamic programming", CACM 1961).

    Parameters
    ----------
    rows : (n, D) float32
        See :func:`~vpr_baselines.clustering.closeness.prepared`.
    count : int
        How many stretches.
    distance : {"cosine", "l1", "l2"}
        What is scattered; see :func:`~vpr_baselines.clustering.closeness.scatter`.
    min_size, max_size : int, optional
        Of a stretch.

    Returns
    -------
    (n,) int64
        Cluster of each image.

    Raises
    ------
    ValueError
        If so many clusters within these limits do not make ``n``.

    Examples
    --------
    >>> by_count(np.array([[0], [1], [5], [6], [9]], np.float32), 3, "l2")
    array([0, 0, 1, 1, 2])
    """
    n, most = len(rows), max_size or len(rows)
    if not count * min_size <= n <= count * most:
        limits = f"of {min_size} to {max_size or 'any number of'} references"
        raise ValueError(f"{n} references cannot be cut into {count} clusters {limits}.")
    pieces = -(-n // _PIECE)
    # With c of the C clusters in a piece of c/C of the images, every piece can keep the limits if the whole can.
    parts = [count * piece // pieces for piece in range(pieces + 1)]
    starts: list[int] = []
    for low, high in pairwise(parts):
        begin, end = n * low // count, n * high // count
        if high > low:
            apart = scatter(rows[begin:end], distance)
            starts += [begin + start for start in _cut(apart, high - low, min_size, min(most, end - begin))]
    begins = np.zeros(n, dtype=np.int64)
    begins[starts] = 1
    return np.cumsum(begins) - 1


def _cut(apart: NDArray[np.float64], count: int, min_size: int, max_size: int) -> list[int]:
    """Return where the stretches of least total scatter start, given (n, n) pairwise scatter."""
    n = len(apart)
    within = _scatter_of_stretches(apart, min_size, max_size)
    best, before = within[0], []
    for _ in range(count - 1):  # one more stretch, which begins anywhere and ends before each image
        totals = best[:, None] + within
        begins = totals.argmin(axis=0)
        before.append(begins)
        best = totals[begins, np.arange(n + 1)]
    starts = [n]
    for begins in reversed(before):
        starts.append(int(begins[starts[-1]]))
    return [0, *sorted(starts[1:])]


def _scatter_of_stretches(apart: NDArray[np.float64], min_size: int, max_size: int) -> NDArray[np.float64]:
    """Return the scatter of every stretch from a to before b, infinite where it has not the right size."""
    n = len(apart)
    sums = np.zeros((n + 1, n + 1))
    sums[1:, 1:] = apart.cumsum(axis=0).cumsum(axis=1)
    ends = np.diag(sums)
    pairs = (ends[None, :] - sums - sums.T + ends[:, None]) / 2
    sizes = np.arange(n + 1)[None, :] - np.arange(n + 1)[:, None]
    right = (sizes >= min_size) & (sizes <= max_size)
    return np.where(right, pairs / np.maximum(sizes, 1), np.inf)
