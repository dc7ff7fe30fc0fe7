"""Whether two methods give the same answers."""

from collections.abc import Sequence

import numpy as np

from vpr_bench.check.outcome import Failed
from vpr_bench.types.match import Match

TOLERANCE = 1e-4
"""How far two scores may be apart and still be the same, as a share of the largest: sums in another order differ."""


def expect_same(one: Sequence[Match], other: Sequence[Match], what: str, *, exactly: bool = False) -> None:
    """Compare two lists of answers to the same queries.

    Parameters
    ----------
    one, other : sequence of Match
        Answers.
    what : str
        How to say that they differ: "with …".
    exactly : bool
        Bit by bit; else scores may differ by :data:`TOLERANCE`, and places of the same score may be exchanged.

    Raises
    ------
    Failed
        At the first difference.
    """
    if len(one) != len(other):
        raise Failed(f"{what}: {len(other)} answers instead of {len(one)}")
    for query, (expected, found) in enumerate(zip(one, other, strict=True)):
        alike = _identical(expected, found) if exactly else agree(expected, found)
        if not alike:
            raise Failed(f"{what}: query {query} is answered {_told(found)} instead of {_told(expected)}")


def agree(one: Match, other: Match) -> bool:
    """Say whether two answers name the same places with the same scores, up to :data:`TOLERANCE`.

    Examples
    --------
    >>> agree(Match([4, 2], [0.5, 0.5]), Match([2, 4], [0.50001, 0.5]))
    True
    >>> agree(Match([4, 2], [0.9, 0.5]), Match([2, 4], [0.9, 0.5]))
    False
    """
    if len(one) != len(other):
        return False
    if not len(one):
        return True
    room = TOLERANCE * float(max(np.abs(one.scores).max(), np.abs(other.scores).max()))
    if np.abs(one.scores - other.scores).max() > room:
        return False
    here, there = (dict(zip(match.indices.tolist(), match.scores.tolist(), strict=True)) for match in (one, other))
    last = float(min(one.scores[-1], other.scores[-1]))  # of equal scores at the end, either may have been kept
    return all(abs(here.get(place, last) - there.get(place, last)) <= 2 * room for place in here.keys() | there.keys())


def _identical(one: Match, other: Match) -> bool:
    return np.array_equal(one.indices, other.indices) and np.array_equal(one.scores, other.scores)


def _told(match: Match) -> str:
    pairs = zip(match.indices.tolist(), match.scores.tolist(), strict=True)
    told = [f"{place} ({score:.6g})" for place, score in pairs]
    return ", ".join([*told[:3], *(["…"] if told[3:] else [])]) or "with nothing"
