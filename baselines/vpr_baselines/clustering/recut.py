"""Moving as few cuts of a sequence as possible so that all stretches have the right size."""

from collections import deque
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.clustering.closeness import Distance, neighbour_closeness, prepared


def possible(n: int, min_size: int, max_size: int) -> bool:
    """Say whether ``n`` is a sum of sizes within the limits.

    Examples
    --------
    >>> possible(6, 3, 4), possible(5, 3, 4), possible(7, 3, 4)
    (True, False, True)
    """
    return -(-n // max_size) <= n // min_size


def recut(
    rows: NDArray[np.float32], labels: NDArray[np.int64], distance: Distance, min_size: int, max_size: int
) -> NDArray[np.int64]:
    """Take away and add as few cuts as possible: between the closest clusters, and the least close images.

    Parameters
    ----------
    rows : (n, D) float32
        See :func:`~vpr_baselines.clustering.closeness.prepared`.
    labels : (n,) int64
        Clusters that are stretches of the sequence.
    distance : {"cosine", "l1", "l2"}
        What close means.
    min_size, max_size : int
        Limits that :func:`possible` allows.

    Returns
    -------
    (n,) int64
        Clusters that are stretches, numbered from 0.
    """
    n = len(rows)
    cuts = np.flatnonzero(np.diff(labels)) + 1
    images = neighbour_closeness(rows, distance)
    # The number of changes decides; how natural they are, between 0 and 1, only between equal numbers.
    adding, removing = np.zeros(n + 1), np.zeros(n + 1)
    adding[1:n] = 1 + _ranks(images) / (n + 1)
    adding[cuts] = 0
    removing[cuts] = 1 + _ranks(-_cluster_closeness(rows, cuts, distance)) / (n + 1)
    starts = _cheapest(adding, removing, min_size, max_size)
    begins = np.zeros(n, dtype=np.int64)
    begins[starts[1:]] = 1
    return np.cumsum(begins)


def _cluster_closeness(rows: NDArray[np.float32], cuts: NDArray[np.int64], distance: Distance) -> NDArray[np.float32]:
    """Compare the means of the clusters on both sides of each cut."""
    bounds = [0, *cuts.tolist(), len(rows)]
    means = np.stack([rows[start:stop].mean(axis=0) for start, stop in pairwise(bounds)])
    return neighbour_closeness(prepared(means, distance), distance)


def _ranks(values: NDArray[np.float32]) -> NDArray[np.float64]:
    """Scale to [0, 1], the smallest to 0."""
    if not len(values):
        return np.zeros(0)
    span = float(values.max() - values.min())
    return np.asarray((values.astype(np.float64) - values.min()) / (span or 1.0))


def _cheapest(adding: NDArray[np.float64], removing: NDArray[np.float64], min_size: int, max_size: int) -> list[int]:
    """Find the cuts of least cost, given what cutting and not cutting costs before each of n images and at the end."""
    n = len(adding) - 1
    removed = np.cumsum(removing)  # of all cuts up to and including this place
    cost = np.full(n + 1, np.inf)
    cost[0] = 0.0
    before = np.zeros(n + 1, dtype=np.int64)
    window: deque[int] = deque()  # places the last stretch may begin at, the cheapest first
    for stop in range(min_size, n + 1):
        start = stop - min_size
        while window and cost[window[-1]] - removed[window[-1]] > cost[start] - removed[start]:
            window.pop()
        window.append(start)
        while window[0] < stop - max_size:
            window.popleft()
        start = window[0]
        before[stop] = start
        cost[stop] = cost[start] - removed[start] + removed[stop - 1] + adding[stop]
    starts = [n]
    while starts[-1] > 0:
        starts.append(int(before[starts[-1]]))
    return starts[:0:-1]
