"""Histograms of oriented gradients."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_baselines.photometry import grey, resized
from vpr_baselines.retrieval import Retrieval


@dataclass
class Hog(Retrieval):
    """HOG of the whole image (Dalal and Triggs, CVPR 2005), blocks of 2 × 2 cells that advance by one cell.

    The defaults are VPR-Bench's (Zaffar et al., IJCV 2021): 512 × 512 grey, cells of 16, 9 bins, 34,596 numbers
    per image. The preset ``thesis`` is 64 × 128, cells of 8, 9 bins, 3,780 numbers.

    Parameters
    ----------
    width, height : int
        What images are resized to, in pixels; multiples of ``cell``.
    cell : int
        Side of a cell in pixels.
    bins : int
        Orientations per cell.
    """

    version: ClassVar[str] = "1"
    presets: ClassVar[dict[str, dict[str, Any]]] = {
        "thesis": {"width": 64, "height": 128, "cell": 8, "bins": 9},
        "vpr-bench": {"width": 512, "height": 512, "cell": 16, "bins": 9},
    }

    width: int = 512
    height: int = 512
    cell: int = 16
    bins: int = 9

    def __post_init__(self) -> None:
        """Check the parameters.

        Raises
        ------
        ValueError
            If a side does not hold whole cells, at least two.
        """
        super().__post_init__()
        sides = (self.width, self.height)
        if self.cell < 1 or self.bins < 1 or any(side % self.cell or side < 2 * self.cell for side in sides):
            raise ValueError(
                "width and height must be multiples of cell and hold at least two, bins at least 1. "
                f"Got width={self.width}, height={self.height}, cell={self.cell}, bins={self.bins} instead."
            )

    @cached_property
    def _extractor(self) -> cv2.HOGDescriptor:
        cell = (self.cell, self.cell)
        return cv2.HOGDescriptor((self.width, self.height), (2 * self.cell, 2 * self.cell), cell, cell, self.bins)

    def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into its (D,) float32 HOG.

        D = (width/cell - 1) · (height/cell - 1) · 4 · bins.
        """
        window = resized(grey(image), self.width, self.height)
        return np.asarray(self._extractor.compute(window), dtype=np.float32).ravel()
