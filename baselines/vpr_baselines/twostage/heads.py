"""Linear classifiers on descriptors: the last layer, which is all that learns while the trunk is frozen."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.matrices import product


@dataclass(frozen=True, eq=False)
class LinearHead:
    """One linear layer.

    Attributes
    ----------
    weight : (classes, D) float32
    bias : (classes,) float32
    """

    weight: NDArray[np.float32]
    bias: NDArray[np.float32]

    def logits(self, descriptors: NDArray[np.float32]) -> NDArray[np.float32]:
        """Score a (D,) descriptor or (n, D) of them: (classes,) or (n, classes) float32."""
        return product(descriptors, self.weight.T) + self.bias

    def before(self, mean: NDArray[np.float32], scale: float) -> "LinearHead":
        """Return the layer that does to ``x`` what this one does to ``(x - mean) / scale``.

        Parameters
        ----------
        mean : (D,) float32
            What this layer expects to have been taken away.
        scale : float
            What it then expects to have been divided by.
        """
        weight = (self.weight / scale).astype(np.float32)
        return LinearHead(weight, (self.bias - weight @ mean).astype(np.float32))
