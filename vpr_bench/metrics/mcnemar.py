"""Whether two methods find places equally often, from the queries that only one of them answered right.

Source: Q. McNemar, Note on the sampling error of the difference between correlated proportions or percentages,
Psychometrika 12, 1947; the exact form, by the binomial distribution, needs no minimum of such queries.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class McNemar:
    """How many queries only one of two methods answered right, and how likely that is by chance.

    Attributes
    ----------
    only_first, only_second : int
        Queries that only the first, only the second one answered right.
    p_value : float
        Chance, were both equally good, of a split at least as uneven; two-sided, exact, in (0, 1].
    """

    only_first: int
    only_second: int
    p_value: float


def mcnemar(first: NDArray[np.bool_], second: NDArray[np.bool_]) -> McNemar:
    """Compare right and wrong answers to the same queries.

    Parameters
    ----------
    first, second : (n,) bool
        Whether each query was answered right, in the same order.

    Raises
    ------
    ValueError
        If they are not as many.

    Examples
    --------
    >>> mcnemar(np.array([True, True, True, True, False]), np.array([True, False, False, False, False]))
    McNemar(only_first=3, only_second=0, p_value=0.25)
    """
    if first.shape != second.shape or first.ndim != 1:
        raise ValueError(f"both must have the same shape (n,). Got {first.shape} and {second.shape} instead.")
    only_first, only_second = int((first & ~second).sum()), int((second & ~first).sum())
    if only_first == only_second:
        return McNemar(only_first, only_second, 1.0)
    from scipy.stats import binomtest

    result = binomtest(only_first, only_first + only_second)
    return McNemar(only_first, only_second, float(result.pvalue))
