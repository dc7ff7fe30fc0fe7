"""Clusters of images that are alike enough."""

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.clustering.closeness import Distance, closeness, neighbour_closeness


def leader(rows: NDArray[np.float32], least: float, distance: Distance) -> NDArray[np.int64]:
    """Start a stretch where an image is less close than ``least`` to the first one of the stretch (thesis, ch. 3).

    Parameters
    ----------
    rows : (n, D) float32
        See :func:`~vpr_baselines.clustering.closeness.prepared`.
    least : float
        Least closeness: a cosine similarity, or minus a distance.
    distance : {"cosine", "l1", "l2"}
        What closeness is.

    Returns
    -------
    (n,) int64
        Cluster of each image.

    Examples
    --------
    >>> leader(np.array([[0], [2], [4], [6]], np.float32), -3, "l1")
    array([0, 0, 1, 1])
    """
    begins = np.zeros(len(rows), dtype=np.int64)
    first = 0
    for index in range(1, len(rows)):
        if closeness(rows[index : index + 1], rows[first], distance)[0] < least:
            begins[index], first = 1, index
    return np.cumsum(begins)


def chain(rows: NDArray[np.float32], least: float, distance: Distance) -> NDArray[np.int64]:
    """Start a stretch where an image is less close than ``least`` to the one before it; parameters as of `leader`.

    Examples
    --------
    >>> chain(np.array([[0], [2], [4], [9]], np.float32), -3, "l1")
    array([0, 0, 0, 1])
    """
    begins = np.zeros(len(rows), dtype=np.int64)
    begins[1:] = neighbour_closeness(rows, distance) < least
    return np.cumsum(begins)


def focus(rows: NDArray[np.float32], least: float, distance: Distance) -> NDArray[np.int64]:
    """Let every image that is close enough to the first one left join it, wherever it is (thesis, ch. 2).

    Parameters as of `leader`. The clusters need not be stretches of the sequence.

    Examples
    --------
    >>> focus(np.array([[0], [9], [2], [8]], np.float32), -3, "l1")
    array([0, 1, 0, 1])
    """
    labels = np.full(len(rows), -1, dtype=np.int64)
    left = np.arange(len(rows))
    number = 0
    while len(left):
        joins = closeness(rows[left], rows[left[0]], distance) >= least
        joins[0] = True  # even one that is not like itself, as a zero descriptor by the cosine
        labels[left[joins]] = number
        left, number = left[~joins], number + 1
    return labels
