"""From a feature map to one vector."""

import numpy as np
from numpy.typing import NDArray

_SMALLEST = 1e-6


def gem(maps: NDArray[np.float32], power: float = 3.0) -> NDArray[np.float32]:
    """Pool feature maps by their generalised mean (Radenović et al., TPAMI 2018, eq. 3).

    Parameters
    ----------
    maps : (B, C, H, W) float32
        Not negative; smaller values count as 1e-6.
    power : float
        1 is the average, infinity the maximum.

    Returns
    -------
    (B, C) float32

    Examples
    --------
    >>> gem(np.array([[[[1.0, 3.0]]]]), power=1).tolist()
    [[2.0]]
    """
    raised = np.maximum(maps, _SMALLEST) ** power
    return np.asarray(raised.mean(axis=(2, 3)) ** (1 / power), dtype=np.float32)
