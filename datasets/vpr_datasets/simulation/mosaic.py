"""Raw pictures: what a sensor behind a colour filter array records, one colour in each pixel."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

Bayer = Literal["RGGB", "BGGR", "GRBG", "GBRG"]
"""The colours of the upper left two by two pixels, row by row."""


def mosaic(image: NDArray[np.uint8], bayer: Bayer) -> NDArray[np.uint8]:
    """Keep one channel of each pixel of an (H, W, 3) uint8 RGB image; returns (H, W) uint8.

    Examples
    --------
    >>> mosaic(np.array([[[1, 2, 3]] * 2] * 2, dtype=np.uint8), "RGGB").tolist()
    [[1, 2], [2, 3]]
    """
    raw = np.empty(image.shape[:2], dtype=np.uint8)
    for number, colour in enumerate(bayer):
        row, column = divmod(number, 2)
        raw[row::2, column::2] = image[row::2, column::2, "RGB".index(colour)]
    return raw
