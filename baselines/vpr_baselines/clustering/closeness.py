"""How alike descriptors are: one number that is higher for more alike ones, whatever the distance."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.retrieval import normalised

Distance = Literal["cosine", "l1", "l2"]
"""The angle, the Manhattan or the Euclidean distance."""

_BLOCK = 1 << 24  # numbers in a block of differences: 64 MB


def prepared(descriptors: NDArray[np.float32], distance: Distance) -> NDArray[np.float32]:
    """Return what the other functions take: unit length for the cosine, as they are for the others; (n, D) float32.

    Raises
    ------
    ValueError
        If they are not one finite row per reference.
    """
    rows = np.asarray(descriptors, dtype=np.float32)
    if rows.ndim != 2 or not np.isfinite(rows).all():
        raise ValueError(f"descriptors must be finite, one row per reference. Got shape {rows.shape} instead.")
    return normalised(rows) if distance == "cosine" else rows


def closeness(rows: NDArray[np.float32], one: NDArray[np.float32], distance: Distance) -> NDArray[np.float32]:
    """Compare (n, D) rows with one (D,) row.

    Returns
    -------
    (n,) float32
        The cosine similarity, or minus the distance; rows are those of :func:`prepared`.
    """
    if distance == "cosine":
        return rows @ one
    order = 1 if distance == "l1" else 2
    size = max(_BLOCK // max(len(one), 1), 1)
    blocks = [np.linalg.norm(rows[at : at + size] - one, ord=order, axis=1) for at in range(0, len(rows), size)]
    return -np.concatenate(blocks) if blocks else np.zeros(0, dtype=np.float32)


def neighbour_closeness(rows: NDArray[np.float32], distance: Distance) -> NDArray[np.float32]:
    """Compare each image with the one before it: (n - 1,) float32."""
    pairs = [closeness(rows[at : at + 1], rows[at - 1], distance) for at in range(1, len(rows))]
    return np.concatenate(pairs) if pairs else np.zeros(0, dtype=np.float32)


def scatter(rows: NDArray[np.float32], distance: Distance) -> NDArray[np.float64]:
    """Compare each with each, as what adds up to scatter: 1 - cosine, Manhattan, or squared Euclidean distance.

    Summed over the pairs of a cluster and divided by its size, it is the cluster's sum of squared distances to its
    mean (half of that for unit vectors), and the like of it for Manhattan.

    Returns
    -------
    (n, n) float64
        At least 0, and 0 on the diagonal.
    """
    if distance == "cosine":
        apart = 1 - rows.astype(np.float64) @ rows.T
        np.fill_diagonal(apart, 0)  # a zero descriptor is like itself, too
        return np.asarray(np.maximum(apart, 0))
    from scipy.spatial.distance import cdist

    return np.asarray(cdist(rows, rows, "cityblock" if distance == "l1" else "sqeuclidean"), dtype=np.float64)
