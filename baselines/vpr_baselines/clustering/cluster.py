"""From descriptors to clusters: the one function that others call."""

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.clustering.closeness import prepared
from vpr_baselines.clustering.count import by_count
from vpr_baselines.clustering.kmeans import kmeans
from vpr_baselines.clustering.options import ClusteringOptions
from vpr_baselines.clustering.sizes import limited
from vpr_baselines.clustering.threshold import chain, focus, leader
from vpr_baselines.retrieval import normalised
from vpr_bench.types.clusters import Clusters

_BY_THRESHOLD = {"leader": leader, "chain": chain, "focus": focus}


def cluster_descriptors(descriptors: NDArray[np.float32], options: ClusteringOptions) -> Clusters:
    """Cluster references by their descriptors.

    Parameters
    ----------
    descriptors : (n, D) float32
        One per reference, in the order of the sequence, of any length.
    options : ClusteringOptions
        How.

    Returns
    -------
    Clusters
        Every size within the limits, with cohesion.

    Raises
    ------
    ValueError
        If there is no reference, the options do not fit so many references, or a descriptor is not finite.

    Examples
    --------
    >>> walk = np.array([[0.0], [1.0], [5.0], [6.0], [9.0]], np.float32)
    >>> cluster_descriptors(walk, ClusteringOptions("leader", "l1", threshold=3)).labels
    array([0, 0, 1, 1, 2])
    """
    rows = prepared(descriptors, options.distance)
    if not len(rows):
        raise ValueError("there are no references to cluster.")
    labels = limited(rows, _labels(rows, options), options.distance, options.min_size, options.max_size)
    clusters = Clusters.from_labels(labels)
    return Clusters(clusters.labels, cohesion(descriptors, clusters))


def cohesion(descriptors: NDArray[np.float32], clusters: Clusters) -> NDArray[np.float32]:
    """Return the mean cosine similarity of each cluster's descriptors to their mean, all of unit length: (C,) float32.

    1 if all are alike; 0 for a cluster of zero descriptors.
    """
    rows = normalised(np.asarray(descriptors, dtype=np.float32))
    members = (rows[clusters.members(number)] for number in range(len(clusters)))
    means = [(own, normalised(own.mean(axis=0))) for own in members]
    return np.array([np.clip((own @ mean).mean(), -1, 1) for own, mean in means], dtype=np.float32)


def _labels(rows: NDArray[np.float32], options: ClusteringOptions) -> NDArray[np.int64]:
    """Cluster without minding sizes, except by count, which minds them from the start."""
    if options.threshold is not None:
        least = options.threshold if options.distance == "cosine" else -options.threshold
        return _BY_THRESHOLD[options.kind](rows, least, options.distance)
    if options.labels is not None:
        if len(options.labels) != len(rows):
            raise ValueError(f"labels must be one per reference, {len(rows)}. Got {len(options.labels)} instead.")
        return np.array(options.labels, dtype=np.int64)
    count = options.n_clusters or 1
    if options.kind == "kmeans":
        return kmeans(rows, count, options.seed)
    return by_count(rows, count, options.distance, options.min_size, options.max_size)
