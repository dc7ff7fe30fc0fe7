"""How references are to be clustered."""

import math
from dataclasses import dataclass
from typing import Literal, get_args

from vpr_baselines.clustering.closeness import Distance

Kind = Literal["count", "leader", "chain", "kmeans", "focus", "labels"]
"""The ways of clustering; see :class:`ClusteringOptions`."""

_NEEDS: dict[Kind, str] = {
    "count": "n_clusters",
    "leader": "threshold",
    "chain": "threshold",
    "kmeans": "n_clusters",
    "focus": "threshold",
    "labels": "labels",
}


@dataclass(frozen=True)
class ClusteringOptions:
    """How references are to be clustered.

    Parameters
    ----------
    kind : {"count", "leader", "chain", "kmeans", "focus", "labels"}
        - ``count``: ``n_clusters`` stretches of the sequence that are as coherent as possible;
        - ``leader``: a stretch ends where an image is too far from the stretch's first one (thesis, ch. 3);
        - ``chain``: a stretch ends where an image is too far from the one before it;
        - ``kmeans``: ``n_clusters`` by K-means, wherever in the sequence the images are (thesis, ch. 2);
        - ``focus``: the first image that is in no cluster yet is the focus of the next one, and all others within
          the threshold join it, wherever they are (thesis, ch. 2);
        - ``labels``: as ``labels`` say.
    distance : {"cosine", "l1", "l2"}
        What similar means: the angle between descriptors, or their Manhattan or Euclidean distance as they are.
        K-means takes no ``l1``.
    threshold : float, optional
        For ``leader``, ``chain`` and ``focus``: the least cosine similarity, in [-1, 1], or the largest distance, of
        images that belong together, inclusive.
    n_clusters : int, optional
        For ``count`` and ``kmeans``: how many, before sizes are limited (``count`` keeps to both).
    labels : sequence of int, optional
        For ``labels``: one number per reference; the same number, the same cluster.
    min_size, max_size : int, optional
        How many references a cluster has at least and at most; ``None`` is no limit.
    seed : int
        Of K-means.

    Raises
    ------
    ValueError
        If a value makes no sense, or an option that the kind needs is missing or one that it does not use is given.
    """

    kind: Kind = "count"
    distance: Distance = "cosine"
    threshold: float | None = None
    n_clusters: int | None = None
    labels: tuple[int, ...] | None = None
    min_size: int = 1
    max_size: int | None = None
    seed: int = 0

    def __post_init__(self) -> None:
        """Check the combination."""
        if self.labels is not None:
            object.__setattr__(self, "labels", tuple(self.labels))
        for name, value, known in (("kind", self.kind, Kind), ("distance", self.distance, Distance)):
            if value not in get_args(known):
                raise ValueError(f"{name} must be one of {', '.join(get_args(known))}. Got {value!r} instead.")
        needed = _NEEDS[self.kind]
        for name in ("threshold", "n_clusters", "labels"):
            if (getattr(self, name) is not None) != (name == needed):
                verb = "needs" if name == needed else "does not use"
                raise ValueError(f"clustering by {self.kind!r} {verb} {name}.")
        self._check_values()

    def _check_values(self) -> None:
        if self.threshold is not None:
            low, high = (-1.0, 1.0) if self.distance == "cosine" else (0.0, math.inf)
            if not low <= self.threshold <= high:
                allowed = "from -1 to 1" if self.distance == "cosine" else "at least 0"
                raise ValueError(f"a threshold of {self.distance} must be {allowed}. Got {self.threshold} instead.")
        if self.n_clusters is not None and self.n_clusters < 1:
            raise ValueError(f"n_clusters must be at least 1. Got {self.n_clusters} instead.")
        if self.min_size < 1 or (self.max_size is not None and self.max_size < self.min_size):
            raise ValueError(
                "min_size must be at least 1 and max_size at least min_size. "
                f"Got min_size={self.min_size}, max_size={self.max_size} instead."
            )
        if self.kind == "kmeans" and self.distance == "l1":
            raise ValueError("K-means compares by cosine or l2. Got distance='l1' instead.")
