"""Small grey images compared pixel by pixel."""

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.indexes import Metric
from vpr_baselines.photometry import grey, resized
from vpr_baselines.retrieval import Retrieval


@dataclass(kw_only=True)
class Sad(Retrieval):
    """Minus the mean absolute difference of patch-normalised grey pixels (SeqSLAM: Milford and Wyeth, ICRA 2012).

    Parameters
    ----------
    width, height : int
        What images are resized to, in pixels.
    patch : int
        Side in pixels of the square patches that get mean 0 and standard deviation 1 each; those at the right and
        bottom may be cut off. Patches without contrast become 0.
    raw : bool
        Leave the patches as they are: grey levels from 0 to 255.
    """

    version: ClassVar[str] = "1"
    presets: ClassVar[dict[str, dict[str, Any]]] = {"raw": {"raw": True}}

    width: Annotated[int, Field(ge=1)] = 64
    height: Annotated[int, Field(ge=1)] = 32
    patch: Annotated[int, Field(ge=2)] = 8
    raw: bool = False
    metric: Metric = "manhattan"

    def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into its (width · height,) float32 pixels, each divided by their number.

        The division makes the sum that is the Manhattan distance a mean.
        """
        small = resized(grey(image), self.width, self.height).astype(np.float32)
        if not self.raw:
            for top in range(0, self.height, self.patch):
                for left in range(0, self.width, self.patch):
                    _normalise(small[top : top + self.patch, left : left + self.patch])
        return small.ravel() / np.float32(small.size)


def _normalise(patch: NDArray[np.float32]) -> None:
    """Give one (h, w) float32 patch mean 0 and standard deviation 1, in place."""
    patch -= patch.mean()
    deviation = patch.std()
    if deviation > 0:
        patch /= deviation
