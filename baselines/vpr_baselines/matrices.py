"""Matrix products between passes through a network."""

from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray


def product(left: NDArray[Any], right: NDArray[Any]) -> NDArray[np.float32]:
    """Multiply as ``left @ right`` does, by torch's threads and not by NumPy's.

    The threads of NumPy's BLAS go on spinning for tens of milliseconds after a product. The next pass through a
    network shares the cores with them, and takes up to four times as long.

    Parameters
    ----------
    left, right : float32
        Of shapes that ``@`` takes. Not those of a read-only memory map.
    """
    with torch.inference_mode():
        return np.asarray(torch.matmul(torch.from_numpy(left), torch.from_numpy(right)).numpy(), dtype=np.float32)
