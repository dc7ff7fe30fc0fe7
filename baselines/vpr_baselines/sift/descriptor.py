"""All key points of an image stacked into one vector."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.retrieval import Retrieval
from vpr_baselines.sift.keypoints import LENGTH, detect


@dataclass
class StackedSift(Retrieval):
    """What :class:`~vpr_baselines.sift.method.Sift` does in the mode ``descriptor``; it describes the parameters."""

    size: int
    n_features: int

    def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return the SIFT of the strongest key points, then zeros: (n_features · 128,) float32 in [0, 255]."""
        stacked = np.zeros((self.n_features, LENGTH), dtype=np.float32)
        descriptors = detect(image, self.size, self.n_features).descriptors
        stacked[: len(descriptors)] = descriptors
        return stacked.ravel()
