"""From a similarity to the confidence that two images show the same place."""

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

_ROUNDS = 100
_SETTLED = 1e-9
_RIDGE = 1e-6  # on the slope, for similarities that are all the same


@dataclass(frozen=True)
class Confidence:
    """A logistic curve: confidence = 1 / (1 + exp(-(slope · similarity + offset))).

    Attributes
    ----------
    slope, offset : float
    """

    slope: float
    offset: float

    @classmethod
    def fit(cls, same: NDArray[np.floating], other: NDArray[np.floating]) -> Self:
        """Fit to similarities of images of the same place and of other places.

        The targets are those of Platt, "Probabilistic Outputs for Support Vector Machines", 1999, eq. 13: not quite 1
        and 0, so that the curve stays finite where the two do not overlap. Each kind weighs half.

        Parameters
        ----------
        same, other : (n,), (m,) floats
            At least one of each; otherwise the curve is 1 / (1 + exp(-similarity)).
        """
        if not len(same) or not len(other):
            return cls(1.0, 0.0)
        values = np.concatenate([same, other]).astype(np.float64)
        targets = np.repeat([(len(same) + 1) / (len(same) + 2), 1 / (len(other) + 2)], [len(same), len(other)])
        weights = np.repeat([0.5 / len(same), 0.5 / len(other)], [len(same), len(other)])
        centre, spread = values.mean(), values.std() or 1.0
        design = np.stack([(values - centre) / spread, np.ones_like(values)], axis=1)
        found = np.zeros(2)
        for _ in range(_ROUNDS):  # Newton's method; the problem is convex
            probability = 1 / (1 + np.exp(-design @ found))
            slope = design.T @ (weights * (probability - targets)) + _RIDGE * found
            bend = (design * (weights * probability * (1 - probability))[:, None]).T @ design + _RIDGE * np.eye(2)
            step = np.linalg.solve(bend, slope)
            found -= step
            if np.abs(step).max() < _SETTLED:
                break
        # Higher is better, whatever a handful of unlucky images says.
        steepness = max(found[0], _RIDGE) / spread
        return cls(float(steepness), float(found[1] - steepness * centre))

    def of(self, similarities: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return the confidence of each similarity, in (0, 1); it keeps their order."""
        return np.asarray(1 / (1 + np.exp(-(self.slope * similarities.astype(np.float64) + self.offset))), np.float32)
