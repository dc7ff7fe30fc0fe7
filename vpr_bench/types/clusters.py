"""Which cluster each reference belongs to."""

from dataclasses import dataclass, field
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, eq=False, init=False)
class Clusters:
    """Every reference in exactly one cluster; clusters are numbered by first appearance.

    Sequential clustering makes stretches of the sequence (:attr:`contiguous`); K-means, for one, need not.

    Parameters
    ----------
    labels : (n,) integers
        Cluster of each reference, in 0..C-1, every number used, numbered by first appearance. See
        :meth:`from_labels` for labels that are not.
    cohesion : (C,) floats, optional
        Mean cosine similarity of a cluster's descriptors to their normalised mean, in [-1, 1]; 1 if all are alike.

    Raises
    ------
    ValueError
        If the labels are no such numbering, or there is not one cohesion per cluster.

    Examples
    --------
    >>> clusters = Clusters([0, 0, 0, 1, 1])
    >>> len(clusters), clusters.members(1), clusters.starts, clusters.stops
    (2, array([3, 4]), array([0, 3]), array([3, 5]))
    """

    labels: NDArray[np.int64]
    cohesion: NDArray[np.float32] | None
    starts: NDArray[np.int64] = field(repr=False)
    """(C,) int64, the first member of each cluster; ascending."""
    stops: NDArray[np.int64] = field(repr=False)
    """(C,) int64, the last member of each cluster, plus 1."""
    sizes: NDArray[np.int64] = field(repr=False)
    """(C,) int64, how many members each cluster has; at least 1."""

    def __init__(self, labels: ArrayLike, cohesion: ArrayLike | None = None) -> None:
        given = _as_labels(labels)
        used, starts, sizes = np.unique(given, return_index=True, return_counts=True)
        if not np.array_equal(used, np.arange(len(used))) or np.any(np.diff(starts) < 0):
            raise ValueError(
                "the labels of clusters must be numbered 0, 1, 2, … in the order in which they first appear. "
                f"Got {given[:20].tolist()}{'…' if len(given) > 20 else ''} instead."
            )
        of_clusters = None if cohesion is None else np.array(cohesion, dtype=np.float32)
        if of_clusters is not None and (of_clusters.shape != used.shape or not np.isfinite(of_clusters).all()):
            raise ValueError(f"cohesion must be one finite number for each of {len(used)} clusters. Got {of_clusters}.")
        stops = len(given) - np.unique(given[::-1], return_index=True)[1]
        for name, value in (("labels", given), ("starts", starts), ("stops", stops), ("sizes", sizes)):
            value.flags.writeable = False
            object.__setattr__(self, name, value)
        object.__setattr__(self, "cohesion", of_clusters)

    def __len__(self) -> int:
        """Return the number of clusters."""
        return len(self.starts)

    def members(self, cluster: int) -> NDArray[np.int64]:
        """Return the references of one cluster, (m,) int64 ascending."""
        return np.flatnonzero(self.labels == cluster)

    @property
    def contiguous(self) -> bool:
        """Whether every cluster is a stretch of the sequence; one that is has ``stops - starts == sizes``."""
        return bool(np.array_equal(self.stops - self.starts, self.sizes))

    @classmethod
    def from_labels(cls, labels: ArrayLike, cohesion: ArrayLike | None = None) -> Self:
        """Take any integers for labels, and number the clusters anew by first appearance.

        Parameters
        ----------
        labels : (n,) integers
            The same number, the same cluster.
        cohesion : (C,) floats, optional
            One per cluster, in the order of the new numbers.

        Examples
        --------
        >>> Clusters.from_labels([7, 7, 3, 7, -1]).labels
        array([0, 0, 1, 0, 2])
        """
        given = _as_labels(labels)
        _, first, inverse = np.unique(given, return_index=True, return_inverse=True)
        renumbered = np.empty(len(first), dtype=np.int64)
        renumbered[np.argsort(first)] = np.arange(len(first))
        return cls(renumbered[inverse.ravel()], cohesion)

    @classmethod
    def from_starts(cls, starts: ArrayLike, n: int, cohesion: ArrayLike | None = None) -> Self:
        """Cut a sequence of ``n`` references into stretches.

        Parameters
        ----------
        starts : (C,) integers
            The first reference of each cluster: ascending, beginning with 0, below ``n``.
        n : int
            Number of references.
        cohesion : (C,) floats, optional
            One per cluster.

        Raises
        ------
        ValueError
            If the starts are none.

        Examples
        --------
        >>> Clusters.from_starts([0, 2], 5).labels
        array([0, 0, 1, 1, 1])
        """
        given = _as_labels(starts)
        bounds = np.append(given, n)
        if len(given) < 1 or given[0] != 0 or np.any(np.diff(bounds) < 1):
            raise ValueError(f"starts must ascend from 0 and stay below {n}. Got {given} instead.")
        return cls(np.repeat(np.arange(len(given)), np.diff(bounds)), cohesion)


def _as_labels(given: ArrayLike) -> NDArray[np.int64]:
    values = np.asarray(given)
    if values.ndim != 1 or (values.size and not np.issubdtype(values.dtype, np.integer)):
        raise ValueError(f"clusters are given as a row of integers. Got {values.shape} {values.dtype} instead.")
    return values.astype(np.int64)
