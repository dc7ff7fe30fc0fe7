"""How similar one image is to every reference, and what of it stands out."""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter1d

from vpr_bench.method.interfaces import Method, Scoring

_EVEN = 1e-6  # of a row's largest value: what varies less is rounding


def similarity_row(method: Method, image: NDArray[np.uint8], n_references: int) -> NDArray[np.float32]:
    """Ask a method how similar an image is to all references.

    Parameters
    ----------
    method : Method
        Its ``scores`` are taken if it has them, else its answer for as many references as there are.
    image : (H, W, 3) uint8
        RGB.
    n_references : int
        Size of the map.

    Returns
    -------
    (n_references,) float32
        Higher is more similar. References that were not answered get the lowest score that was.

    Raises
    ------
    ValueError
        If there is not one finite score per reference.
    """
    if isinstance(method, Scoring):
        row = np.asarray(method.scores(image), dtype=np.float32)
        if row.shape != (n_references,) or not np.isfinite(row).all():
            raise ValueError(f"the scores must be ({n_references},) and finite. Got shape {row.shape} instead.")
        return row
    match = method.match(image, n_references)
    row = np.full(n_references, match.scores[-1] if len(match) else 0, dtype=np.float32)
    row[match.indices] = match.scores
    return row


def contrasted(row: NDArray[np.float32], width: int) -> NDArray[np.float32]:
    """Compare every similarity with its neighbourhood, so that dark and bright stretches of the map count alike.

    The local contrast enhancement of SeqSLAM (Milford and Wyeth, ICRA 2012): minus the local mean, by the
    local standard deviation. To the latter we add the deviation of the whole row: where neighbours look all alike,
    the quotient would be noise, magnified.

    Parameters
    ----------
    row : (N,) float32
        Similarities of one query to all references.
    width : int
        Size of the neighbourhood in references; 0 takes the whole row.

    Returns
    -------
    (N,) float32
        Without unit; zero where nothing stands out.
    """
    values = row - row.mean(dtype=np.float64)
    spread = values.std()
    if spread <= _EVEN * np.abs(row).max():
        return np.zeros_like(row)
    if not 0 < width < len(row):
        return np.asarray(values / (2 * spread), dtype=np.float32)
    mean = uniform_filter1d(values, width, mode="reflect")
    variance = uniform_filter1d(values**2, width, mode="reflect") - mean**2
    return np.asarray((values - mean) / (np.sqrt(np.maximum(variance, 0)) + spread), dtype=np.float32)
