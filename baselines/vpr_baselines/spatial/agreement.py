"""How well the cells of two images agree on one displacement: Hough voting by mutual nearest neighbours."""

from functools import cache

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.matrices import product
from vpr_baselines.spatial.cells import Cells

_REACH = 2  # cells to which a vote is smoothed, either way


def agreement(
    query: Cells,
    vectors: NDArray[np.float32],
    positions: NDArray[np.int64],
    shape: tuple[int, int],
    *,
    sigma: float = 1.0,
) -> NDArray[np.float32]:
    """Score candidates by how many cells of the query they have, all displaced alike.

    Every cell of the query whose nearest neighbour in a candidate has it for its own nearest neighbour votes for the
    displacement between the two, with its squared similarity. Votes are smoothed, so that a scene whose depth makes
    near things move farther still adds up, and the peak counts: wrong neighbours spread their votes.

    Parameters
    ----------
    query : Cells
        With m cells.
    vectors : (K, n, d) float32
        Descriptors of the candidates' cells, of (about) unit length.
    positions : (K, n) integers
        Where they are, as in :class:`~vpr_baselines.spatial.cells.Cells`.
    shape : (int, int)
        Rows and columns of the feature maps.
    sigma : float
        Deviation of the Gaussian that smooths the votes, in cells.

    Returns
    -------
    (K,) float32
        In [0, 1] but for rounding: 1 for an image compared with itself.
    """
    candidates, cells, dimensions = vectors.shape
    similarity = product(query.vectors, vectors.reshape(-1, dimensions).T)
    by_candidate = similarity.reshape(-1, candidates, cells)
    nearest = by_candidate.argmax(axis=2)
    found = np.take_along_axis(by_candidate, nearest[..., None], axis=2)[..., 0]
    candidate = np.arange(candidates)
    back = similarity.max(axis=0).reshape(candidates, cells)  # of each candidate's cell, to its nearest of the query
    mutual = (found >= back[candidate, nearest]) & (found > 0)
    rows, columns = shape
    there, here = positions[candidate, nearest], query.positions[:, None]
    down = there // columns - here // columns + rows - 1
    across = there % columns - here % columns + columns - 1
    height, width = 2 * rows - 1, 2 * columns - 1
    bins = (candidate * height + down) * width + across
    votes = np.bincount(bins[mutual], weights=found[mutual] ** 2, minlength=candidates * height * width)
    smooth = _gaussian(height, sigma) @ votes.reshape(candidates, height, width) @ _gaussian(width, sigma)
    return np.asarray(smooth.max(axis=(1, 2)) / max(len(query.positions), 1), dtype=np.float32)


@cache
def _gaussian(size: int, sigma: float) -> NDArray[np.float64]:
    """Return the matrix that smooths a row of ``size`` numbers: 1 on the diagonal, falling off beside it."""
    distance = np.abs(np.subtract.outer(np.arange(size), np.arange(size)))
    return np.where(distance <= _REACH, np.exp(-((distance / sigma) ** 2) / 2), 0.0)
