"""Stage two: one component per cluster, all in one matrix, so that a component is a slice of it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.twostage.clusters import Clusters
from vpr_baselines.twostage.heads import LinearHead, train_head
from vpr_bench.progress import track


@dataclass(frozen=True, eq=False)
class Components:
    """The classifiers image → reference within the cluster, stacked in the order of the references.

    Attributes
    ----------
    clusters : Clusters
        The index: which rows belong to which component.
    head : LinearHead
        One row per reference.
    """

    clusters: Clusters
    head: LinearHead

    def answer(self, descriptor: NDArray[np.float32], triggered: NDArray[np.int64], best: int) -> NDArray[np.int64]:
        """Let each triggered component name its ``best`` references.

        Parameters
        ----------
        descriptor : (D,) float32
            The query's.
        triggered : (c,) int64
            Clusters, without repetition.
        best : int
            Answers per component; a smaller cluster gives all it has.

        Returns
        -------
        (m,) int64
            Reference numbers, unique, component by component.
        """
        answers = []
        for cluster in triggered:
            stretch = self.clusters.stretch(int(cluster))
            logits = self.head.weight[stretch] @ descriptor + self.head.bias[stretch]
            answers.append(np.argsort(-logits, kind="stable")[:best] + stretch.start)
        return np.concatenate(answers)


def train_components(
    clusters: Clusters, descriptors: NDArray[np.float32], references: NDArray[np.int64], penalty: float
) -> Components:
    """Train every component on the images of its own cluster.

    Parameters
    ----------
    clusters : Clusters
        Of the reference sequence.
    descriptors : (n, D) float32
        Of the references and their augmentations, unit length.
    references : (n,) int64
        Which reference each descriptor belongs to.
    penalty : float
        See :func:`~vpr_baselines.twostage.heads.train_head`.
    """
    heads = []
    for cluster in track(range(len(clusters)), "Training components"):
        stretch = clusters.stretch(cluster)
        inside = (references >= stretch.start) & (references < stretch.stop)
        size = stretch.stop - stretch.start
        heads.append(train_head(descriptors[inside], references[inside] - stretch.start, size, penalty))
    weight = np.concatenate([head.weight for head in heads])
    return Components(clusters, LinearHead(weight, np.concatenate([head.bias for head in heads])))
