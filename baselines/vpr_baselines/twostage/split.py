"""Which samples train, which say when to stop, and which are kept for the report."""

import numpy as np
from numpy.typing import NDArray

from vpr_bench.types.clusters import Clusters

TRAINING, VALIDATION, TEST = range(3)
"""The parts of a split."""

_HELD_BACK = 0.1  # of all samples, for each of validation and test (thesis, ch. 3)


def split(clusters: Clusters, variants: int, seed: int) -> NDArray[np.int8]:
    """Divide the variants of references 80 : 10 : 10, cluster by cluster.

    The original of every reference trains, so that every class of every part has something to learn from; what is
    held back are augmentations. Accuracy on them says how well altered copies of the training images are recognised,
    and nothing about other times of day.

    Parameters
    ----------
    clusters : Clusters
        Of the references.
    variants : int
        How many there are of each reference, the first of which is the original. With a single one all train.
    seed : int
        Each cluster's part is drawn from it and the cluster's number alone: clusters that are added do not change it.

    Returns
    -------
    (n, variants) int8
        ``TRAINING``, ``VALIDATION`` or ``TEST``.
    """
    parts = np.full((len(clusters.labels), variants), TRAINING, dtype=np.int8)
    for cluster in range(len(clusters)):
        members = clusters.members(cluster)
        altered = len(members) * (variants - 1)
        held_back = min(round(_HELD_BACK * len(members) * variants), altered // 2)
        drawn = np.random.default_rng([seed, cluster]).permutation(altered)[: 2 * held_back]
        rows, columns = np.divmod(drawn, max(variants - 1, 1))
        parts[members[rows], columns + 1] = np.repeat([VALIDATION, TEST], held_back)
    return parts
