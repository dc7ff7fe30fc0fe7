"""Which queries one run answers right and another one wrong."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.bootstrap import check_paired


@dataclass(frozen=True, eq=False)
class Flips:
    """The queries on which two runs disagree, in the numbering of the query traverse, ascending.

    Attributes
    ----------
    lost : (n,) int64
        Answered right by the first run, and wrong or not at all by the second.
    gained : (n,) int64
        The other way round.
    """

    lost: NDArray[np.int64]
    gained: NDArray[np.int64]


def flips(first: Answers, second: Answers) -> Flips:
    """Find the queries that only one of two runs answers right, by the best match of each.

    Parameters
    ----------
    first, second : Answers
        To the same queries, under the same policy.

    Raises
    ------
    ValueError
        If the two are not about the same queries, with and without a match, or differ in policy.

    Examples
    --------
    >>> def judged(*correct):
    ...     right = np.array(correct, bool)
    ...     return Answers(right, np.ones(3), np.ones(3, bool), np.where(right, 0, 9), queries=np.array([4, 7, 9]))
    >>> flips(judged(True, True, False), judged(False, True, True))
    Flips(lost=array([4]), gained=array([9]))
    """
    check_paired(first, second)
    return Flips(
        np.sort(first.queries[first.correct & ~second.correct]), np.sort(first.queries[second.correct & ~first.correct])
    )
