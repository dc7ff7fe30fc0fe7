"""Keeping clusters within limits of size."""

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.clustering.closeness import Distance, closeness, prepared
from vpr_baselines.clustering.recut import possible, recut
from vpr_bench.types.clusters import Clusters


def limited(
    rows: NDArray[np.float32], labels: NDArray[np.int64], distance: Distance, min_size: int, max_size: int | None
) -> NDArray[np.int64]:
    """Merge clusters that are too small into the closest one, and split those that are too large.

    Stretches of a sequence stay stretches. Others are merged with the cluster whose mean is closest and that has
    room, and split between those of their images, in the order of the sequence, that are least alike.

    Parameters
    ----------
    rows : (n, D) float32
        See :func:`~vpr_baselines.clustering.closeness.prepared`.
    labels : (n,) int64
        Cluster of each image, any numbers.
    distance : {"cosine", "l1", "l2"}
        What close means.
    min_size, max_size : int
        Limits; ``None`` for none.

    Returns
    -------
    (n,) int64
        Cluster of each image; the labels themselves where they keep the limits.

    Raises
    ------
    ValueError
        If ``n`` cannot be divided into such sizes.
    """
    n, most = len(rows), min(max_size or len(rows), len(rows))
    if not possible(n, min_size, most):
        limits = f"at least {min_size}" if max_size is None else f"{min_size} to {max_size}"
        raise ValueError(f"{n} references cannot be divided into clusters of {limits}.")
    clusters = Clusters.from_labels(labels)
    if _kept(clusters, min_size, most):
        return labels
    if clusters.contiguous:
        return recut(rows, clusters.labels, distance, min_size, most)
    changed = _split(rows, _merged(rows, clusters.labels, distance, min_size, most), distance, min_size, most)
    if _kept(Clusters.from_labels(changed), min_size, most):
        return changed
    # Limits so tight that whole clusters do not fit: lay the clusters end to end, and cut that row.
    row = np.argsort(Clusters.from_labels(changed).labels, kind="stable")
    changed[row] = recut(rows[row], changed[row], distance, min_size, most)
    return changed


def _kept(clusters: Clusters, min_size: int, max_size: int) -> bool:
    return bool(clusters.sizes.min() >= min_size and clusters.sizes.max() <= max_size)


def _merged(
    rows: NDArray[np.float32], labels: NDArray[np.int64], distance: Distance, min_size: int, max_size: int
) -> NDArray[np.int64]:
    """Merge clusters that are too small, the smallest first, each with the closest of those it fits to."""
    labels = labels.copy()
    sizes = np.bincount(labels)
    means = np.stack([rows[labels == number].mean(axis=0) for number in range(len(sizes))])
    while True:
        small = np.flatnonzero((sizes > 0) & (sizes < min_size))
        if not len(small):
            return labels
        one = small[np.argmin(sizes[small])]
        others = np.flatnonzero(sizes)
        others = others[others != one]
        fits = [other for other in others if possible(int(sizes[one] + sizes[other]), min_size, max_size)]
        among = np.array(fits or others)
        other = among[np.argmax(closeness(prepared(means[among], distance), means[one], distance))]
        means[other] = (sizes[one] * means[one] + sizes[other] * means[other]) / (sizes[one] + sizes[other])
        sizes[other] += sizes[one]
        sizes[one] = 0
        labels[labels == one] = other


def _split(
    rows: NDArray[np.float32], labels: NDArray[np.int64], distance: Distance, min_size: int, max_size: int
) -> NDArray[np.int64]:
    """Split each cluster that is too large by itself, where its size allows it."""
    labels = labels.copy()
    sizes = np.bincount(labels)
    for number in np.flatnonzero(sizes > max_size):
        if possible(int(sizes[number]), min_size, max_size):
            members = np.flatnonzero(labels == number)
            parts = recut(rows[members], np.zeros(len(members), np.int64), distance, min_size, max_size)
            labels[members] = np.where(parts > 0, labels.max() + parts, number)
    return labels
