"""Random projections: fewer numbers that keep distances and angles, nearly."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray


@lru_cache(maxsize=1)
def gaussian_projection(inputs: int, outputs: int, seed: int) -> NDArray[np.float32]:
    """Draw a matrix that projects vectors onto random directions (Johnson and Lindenstrauss, 1984).

    Euclidean distances and cosines are kept to about ``1 / sqrt(outputs)``; Manhattan distances are not.

    Parameters
    ----------
    inputs, outputs : int
        How many numbers come in and go out. The matrix takes ``4 · inputs · outputs`` bytes: 1 GB for AlexNet's
        conv3 and 4096 outputs.
    seed : int
        The same seed gives the same matrix.

    Returns
    -------
    (outputs, inputs) float32
    """
    random = np.random.default_rng(seed)
    directions = random.standard_normal((outputs, inputs), dtype=np.float32)
    directions /= np.float32(np.sqrt(outputs))
    return directions
