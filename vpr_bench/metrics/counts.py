"""How many answers are right and wrong at every threshold: what all curves are made of."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Counts:
    """One column per distinct score, highest first; an answer counts if its score reaches the threshold.

    Attributes
    ----------
    thresholds : (t,) float64
        The distinct scores, descending. Equal scores cannot be told apart, so they are one threshold.
    true_positives, false_positives : (..., t) float64
        Right and wrong answers with a score of at least the threshold; whole numbers.

    Examples
    --------
    >>> counts = Counts.sweep(np.array([True, False, True]), np.array([0.5, 0.5, 0.9]), np.ones(3))
    >>> counts.thresholds.tolist(), counts.true_positives.tolist(), counts.false_positives.tolist()
    ([0.9, 0.5], [1.0, 2.0], [0.0, 1.0])
    """

    thresholds: NDArray[np.float64]
    true_positives: NDArray[np.float64]
    false_positives: NDArray[np.float64]

    @classmethod
    def sweep(cls, correct: NDArray[np.bool_], score: NDArray[np.float64], weight: NDArray[np.float64]) -> "Counts":
        """Count at every distinct score.

        Parameters
        ----------
        correct : (n,) bool
        score : (n,) float64
        weight : (..., n) float64
        """
        order = np.argsort(-score, kind="stable")
        ordered = score[order]
        last_of_tie = np.flatnonzero(np.append(ordered[1:] != ordered[:-1], True)[: len(score)])
        weight = weight[..., order]
        positives = np.cumsum(weight, axis=-1)[..., last_of_tie]
        true_positives = np.cumsum(weight * correct[order], axis=-1)[..., last_of_tie]
        return cls(ordered[last_of_tie], true_positives, positives - true_positives)

    @cached_property
    def precision(self) -> NDArray[np.float64]:
        """(..., t) float64: right answers among those given, 1 where none is given."""
        given = self.true_positives + self.false_positives
        return ratio(self.true_positives, given, undefined=1.0)


def ratio(part: NDArray[np.float64], whole: NDArray[np.float64], undefined: float = np.nan) -> NDArray[np.float64]:
    """Divide element by element, without a warning; ``undefined`` where the whole is 0.

    Examples
    --------
    >>> ratio(np.array([1.0, 0.0]), np.array([2.0, 0.0]))
    array([0.5, nan])
    """
    part, whole = np.broadcast_arrays(part, whole)
    result = np.full(part.shape, undefined)
    np.divide(part, whole, out=result, where=whole > 0)
    return result[()]  # a number, not an array without axes, where there is but one
