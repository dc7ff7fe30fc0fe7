"""Cutting a reference sequence into clusters: contiguous stretches that look alike."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, eq=False)
class Clusters:
    """Contiguous stretches of a sequence.

    Attributes
    ----------
    bounds : (n_clusters + 1,) int64
        Cluster ``c`` starts at ``bounds[c]`` and stops before ``bounds[c + 1]``; the first is 0, the last the
        length of the sequence.
    """

    bounds: NDArray[np.int64]

    def __post_init__(self) -> None:
        """Check that the stretches cover the sequence.

        Raises
        ------
        ValueError
            If the bounds do not start at 0 and increase.
        """
        if len(self.bounds) < 2 or self.bounds[0] != 0 or np.any(np.diff(self.bounds) <= 0):
            raise ValueError(f"cluster bounds must start at 0 and increase. Got {self.bounds} instead.")

    def __len__(self) -> int:
        """Return the number of clusters."""
        return len(self.bounds) - 1

    def stretch(self, cluster: int) -> slice:
        """Return the references of one cluster."""
        return slice(int(self.bounds[cluster]), int(self.bounds[cluster + 1]))

    @property
    def labels(self) -> NDArray[np.int64]:
        """(n,) int64: the cluster of each reference."""
        return np.repeat(np.arange(len(self)), np.diff(self.bounds))

    @classmethod
    def from_starts(cls, starts: ArrayLike, length: int) -> "Clusters":
        """Build from the first index of each cluster."""
        return cls(np.append(np.asarray(starts, dtype=np.int64), length))


def by_similarity(descriptors: NDArray[np.float32], threshold: float) -> Clusters:
    """Start a new cluster where an image resembles the first image of the current one too little.

    Parameters
    ----------
    descriptors : (n, D) float32
        Unit length, in the order of the sequence.
    threshold : float
        Least cosine similarity to the cluster's first image, in [-1, 1] (thesis, ch. 3).

    Examples
    --------
    >>> by_similarity(np.array([[1, 0], [1, 0], [0, 1]], np.float32), 0.7).bounds
    array([0, 2, 3])
    """
    starts = [0]
    for index in range(1, len(descriptors)):
        if descriptors[index] @ descriptors[starts[-1]] < threshold:
            starts.append(index)
    return Clusters.from_starts(starts, len(descriptors))


def by_count(descriptors: NDArray[np.float32], count: int) -> Clusters:
    """Cut where neighbours resemble each other least, into ``count`` clusters (at most one per image)."""
    neighbours = np.einsum("nd,nd->n", descriptors[1:], descriptors[:-1])
    cuts = np.argsort(neighbours, kind="stable")[: min(count, len(descriptors)) - 1] + 1
    return Clusters.from_starts(np.concatenate([[0], np.sort(cuts)]), len(descriptors))
