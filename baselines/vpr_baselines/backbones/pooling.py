"""From a feature map to one vector."""

from collections.abc import Callable
from typing import Literal

import numpy as np
from numpy.typing import NDArray

_SMALLEST = 1e-6

Pooling = Literal["gem", "average", "grid1x3", "grid2x3"]
"""How a map becomes a vector: its generalised mean, its mean, or the generalised means of its left, middle and right
part, whole or cut into an upper and a lower one."""


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
    positive = np.maximum(maps, _SMALLEST)
    if power == 3:  # twenty times as fast as raising to a power
        return np.asarray(np.cbrt((positive * positive * positive).mean(axis=(2, 3))), dtype=np.float32)
    return np.asarray((positive**power).mean(axis=(2, 3)) ** (1 / power), dtype=np.float32)


def average(maps: NDArray[np.float32]) -> NDArray[np.float32]:
    """Pool (B, C, H, W) feature maps by their mean: (B, C) float32."""
    return np.asarray(maps.mean(axis=(2, 3)), dtype=np.float32)


def grid(maps: NDArray[np.float32], rows: int, columns: int) -> NDArray[np.float32]:
    """Pool every cell of a grid by its generalised mean, so that it counts where something is.

    Parameters
    ----------
    maps : (B, C, H, W) float32
        As for :func:`gem`.
    rows, columns : int
        Of the grid. Cells are as even as whole pixels allow; in small maps they overlap.

    Returns
    -------
    (B, rows · columns · C) float32
        Cell by cell, row by row.
    """
    height, width = maps.shape[2:]
    cells = [maps[:, :, down, across] for down in _parts(height, rows) for across in _parts(width, columns)]
    return np.concatenate([gem(cell) for cell in cells], axis=1)


def _parts(side: int, count: int) -> list[slice]:
    return [slice(side * part // count, -(-side * (part + 1) // count)) for part in range(count)]


POOLINGS: dict[Pooling, Callable[[NDArray[np.float32]], NDArray[np.float32]]] = {
    "gem": gem,
    "average": average,
    "grid1x3": lambda maps: grid(maps, 1, 3),
    "grid2x3": lambda maps: grid(maps, 2, 3),
}
"""(B, C, H, W) float32 to (B, D) float32, by name."""

PARTS: dict[Pooling, int] = {"gem": 1, "average": 1, "grid1x3": 3, "grid2x3": 6}
"""Of how many parts the vector consists, each of C numbers."""
