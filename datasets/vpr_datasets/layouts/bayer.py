"""Raw pictures of colour cameras, in which every pixel has recorded only one colour."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError

PATTERNS = ("RGGB", "BGGR", "GRBG", "GBRG")
"""The colours of the upper left two by two pixels, row by row, as GenICam and camera makers name them."""


@dataclass(frozen=True)
class Bayer:
    """Makes a colour image out of a mosaic; two of the same pattern are equal, so that traverses can be joined.

    OpenCV has two names for each pattern. The older ones of two letters start one row and one column further on, so
    that its ``BayerBG`` is ``RGGB``; the ones of four letters are those of GenICam, and are the ones used here.

    Attributes
    ----------
    pattern : {"RGGB", "BGGR", "GRBG", "GBRG"}
        The colours of the upper left two by two pixels.
    """

    pattern: str

    def __post_init__(self) -> None:
        """Check the pattern.

        Raises
        ------
        DataError
            If there is none of that name.
        """
        if self.pattern not in PATTERNS:
            raise DataError(f"A Bayer pattern must be one of {', '.join(PATTERNS)}. Got {self.pattern!r:.50} instead.")

    def __call__(self, image: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Interpolate the two colours that each pixel lacks.

        Parameters
        ----------
        image : (H, W, 3) uint8
            The mosaic as it is decoded: three equal channels.

        Returns
        -------
        (H, W, 3) uint8
            RGB.

        Raises
        ------
        DataError
            If the image is in colour already, or has less than 3 × 3 pixels.
        """
        import cv2

        mosaic = np.ascontiguousarray(image[..., 0])
        if min(mosaic.shape) < 3:
            raise DataError(f"A Bayer mosaic must have at least 3 × 3 pixels. Got {mosaic.shape} instead.")
        if not (np.array_equal(mosaic, image[..., 1]) and np.array_equal(mosaic, image[..., 2])):
            raise DataError("An image is in colour, and so no Bayer mosaic. Leave out the option bayer.")
        return np.asarray(cv2.cvtColor(mosaic, getattr(cv2, f"COLOR_Bayer{self.pattern}2RGB")), dtype=np.uint8)
