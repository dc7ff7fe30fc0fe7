"""K-means."""

import warnings

import numpy as np
from numpy.typing import NDArray

_STARTS = 4
"""How often K-means begins anew; the best outcome is taken."""


def kmeans(rows: NDArray[np.float32], count: int, seed: int) -> NDArray[np.int64]:
    """Put (n, D) rows into ``count`` clusters of least squared Euclidean distance to their means: (n,) int64 labels.

    Raises
    ------
    ValueError
        If fewer rows than that differ from each other.
    """
    from sklearn.cluster import KMeans
    from sklearn.exceptions import ConvergenceWarning

    if count > len(rows):
        raise ValueError(f"{len(rows)} references cannot be put into {count} clusters.")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)  # of too few different rows, which is told below
        labels = KMeans(count, n_init=_STARTS, random_state=seed).fit_predict(_turned(rows))
    found = len(np.unique(labels))
    if found < count:
        raise ValueError(f"K-means finds {found} clusters, not {count}: no more of the references differ.")
    return np.asarray(labels, dtype=np.int64)


def _turned(rows: NDArray[np.float32]) -> NDArray[np.float32]:
    """Turn n rows of many more numbers into n rows of n numbers, as far apart as before: they span no more space."""
    if rows.shape[1] <= 2 * len(rows):
        return rows
    return np.ascontiguousarray(np.asarray(np.linalg.qr(rows.T, mode="r")).T)
