"""Histograms of oriented gradients, compared by cosine."""

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_baselines.photometry import grey, resized
from vpr_baselines.retrieval import Retrieval


@dataclass
class Hog(Retrieval):
    """HOG of the whole image (Dalal and Triggs, CVPR 2005) with cosine similarity.

    The defaults are VPR-Bench's (Zaffar et al., IJCV 2021): 512 × 512 grey, cells of 16, blocks of 2 × 2 cells,
    9 bins, 34,596 numbers per image.

    Parameters
    ----------
    size : int
        Side in pixels of the square that images are resized to; a multiple of ``cell``.
    cell : int
        Side of a cell in pixels.
    bins : int
        Orientations per cell.
    """

    version: ClassVar[str] = "1"

    size: int = 512
    cell: int = 16
    bins: int = 9

    def __post_init__(self) -> None:
        """Check the parameters.

        Raises
        ------
        ValueError
            If the size does not hold whole cells, at least two.
        """
        if self.cell < 1 or self.bins < 1 or self.size % self.cell or self.size < 2 * self.cell:
            raise ValueError(
                "size must be a multiple of cell and hold at least two, bins at least 1. "
                f"Got size={self.size}, cell={self.cell}, bins={self.bins} instead."
            )

    @cached_property
    def _extractor(self) -> cv2.HOGDescriptor:
        window, cell = (self.size, self.size), (self.cell, self.cell)
        return cv2.HOGDescriptor(window, (2 * self.cell, 2 * self.cell), cell, cell, self.bins)

    def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into its (D,) float32 HOG, D = (size/cell - 1)² · 4 · bins."""
        square = resized(grey(image), self.size, self.size)
        return np.asarray(self._extractor.compute(square), dtype=np.float32).ravel()
