"""How well clusters hold together and stand apart, by the Euclidean distance of descriptors."""

import numpy as np
from numpy.typing import NDArray

from vpr_bench.types.clusters import Clusters

MOST = 5_000
"""References up to which the silhouette is computed: it compares each with each."""


def silhouette(descriptors: NDArray[np.float32], clusters: Clusters) -> float:
    """Return the mean silhouette coefficient (Rousseeuw, 1987), in [-1, 1]; higher is better.

    Of one image: how much farther the images of the nearest other cluster are, on average, than those of its own,
    relative to the larger of both; 0 for an image that is alone in its cluster.

    Parameters
    ----------
    descriptors : (n, D) float32
        One per reference.
    clusters : Clusters
        Of the same references.

    Returns
    -------
    float
        NaN for a single cluster, for clusters of one image each, and above :data:`MOST` references.
    """
    if not 1 < len(clusters) < len(clusters.labels) <= MOST:
        return float("nan")
    from sklearn.metrics import silhouette_score

    return float(silhouette_score(descriptors, clusters.labels))


def distortion(descriptors: NDArray[np.float32], clusters: Clusters) -> float:
    """Return the sum of squared distances to the means of the clusters, at least 0; lower is better.

    It falls with the number of clusters, to 0 where each image is its own.

    Examples
    --------
    >>> distortion(np.array([[0.0], [2.0], [9.0]], np.float32), Clusters([0, 0, 1]))
    2.0
    """
    groups = (descriptors[clusters.members(number)] for number in range(len(clusters)))
    return float(sum(np.square(one - one.mean(axis=0), dtype=np.float64).sum() for one in groups))


def central_members(clusters: Clusters, descriptors: NDArray[np.float32] | None = None) -> NDArray[np.int64]:
    """Return each cluster's reference that is nearest to its mean: (C,) int64.

    Without descriptors, it is the one in the middle of its members.

    Examples
    --------
    >>> central_members(Clusters([0, 0, 0, 1]), np.array([[0.0], [9.0], [1.0], [5.0]], np.float32))
    array([2, 3])
    """
    central = []
    for number in range(len(clusters)):
        members = clusters.members(number)
        if descriptors is None:
            central.append(members[(len(members) - 1) // 2])
        else:
            own = descriptors[members]
            central.append(members[np.argmin(np.square(own - own.mean(axis=0)).sum(axis=1))])
    return np.array(central, dtype=np.int64)
