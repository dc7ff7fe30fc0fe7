"""What a contact sheet shows: some queries, and a few references under each."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.load import Case

Kind = Literal["match", "soft", "miss", "none"]

_GOLDEN = (5**0.5 - 1) / 2

MATCHES, SOFT = 3, 1
"""How many true and how many soft matches stand under a query at most."""


@dataclass(frozen=True)
class Shown:
    """One picture under a query.

    Attributes
    ----------
    kind : {"match", "soft", "miss", "none"}
        A true match, a soft one, the nearest reference to a query that has no match, or nothing at all.
    reference : int
        Its index; -1 for nothing.
    distance : float, optional
        Between the place labels; None where there are none.
    """

    kind: Kind
    reference: int = -1
    distance: float | None = None


@dataclass(frozen=True)
class Column:
    """A query and what stands under it, with how many matches there are beyond those."""

    query: int
    shown: tuple[Shown, ...]
    more: int = 0
    more_soft: int = 0


def choose_columns(case: Case, count: int = 8, seed: int = 0) -> list[Column]:
    """Choose what a sheet shows.

    Parameters
    ----------
    case : Case
        With at least one query.
    count : int
        How many queries at most.
    seed : int
        Another one moves the choice along the queries.
    """
    return [_column(case, query) for query in choose_queries(case.ground_truth.has_match, count, seed).tolist()]


def choose_queries(has_match: NDArray[np.bool_], count: int, seed: int = 0) -> NDArray[np.int64]:
    """Choose evenly spaced queries, those with and those without a match in proportion, and some of both.

    Examples
    --------
    >>> choose_queries(np.arange(100) != 70, count=4).tolist()
    [16, 49, 70, 83]
    """
    count = min(count, len(has_match))
    matched, unmatched = np.flatnonzero(has_match), np.flatnonzero(~has_match)
    without = round(count * len(unmatched) / len(has_match))
    if count > 1:  # one of a rare kind is worth more than one more of the other
        without = min(max(without, min(len(unmatched), 1)), count - min(len(matched), 1))
    offset = (0.5 + seed * _GOLDEN) % 1  # the middle of each stretch, then far from all that was shown before
    chosen = [_spaced(matched, count - without, offset), _spaced(unmatched, without, offset)]
    return np.sort(np.concatenate(chosen))


def _spaced(among: NDArray[np.int64], count: int, offset: float) -> NDArray[np.int64]:
    places = (np.arange(count) + offset) * len(among) / max(count, 1)
    return among[places.astype(np.int64)]


def _column(case: Case, query: int) -> Column:
    truth = case.ground_truth
    matches = truth[query]
    soft = matches[:0] if truth.soft is None else truth.soft[query]
    shown = _pick(case, query, "match", matches, MATCHES) or _miss(case, query, with_picture=len(soft) == 0)
    shown += _pick(case, query, "soft", soft, SOFT)
    return Column(query, tuple(shown), max(len(matches) - MATCHES, 0), max(len(soft) - SOFT, 0))


def _pick(case: Case, query: int, kind: Kind, references: NDArray[np.int64], count: int) -> list[Shown]:
    """Take the nearest reference, the farthest, and what lies evenly between: whether all are right shows in these.

    Without places to measure, nearness is that to the middle one of them.
    """
    if not len(references):
        return []
    distance = _distances(case, query, references)
    order = np.lexsort((references, np.abs(references - np.median(references)) if distance is None else distance))
    taken = np.linspace(0, len(order) - 1, min(count, len(order))).round().astype(np.int64)
    return [
        Shown(kind, int(references[one]), None if distance is None else float(distance[one])) for one in order[taken]
    ]


def _miss(case: Case, query: int, with_picture: bool) -> list[Shown]:
    distance = _distances(case, query, np.arange(case.ground_truth.n_references))
    if distance is None or not len(distance) or not with_picture:
        return [Shown("none")]
    nearest = int(np.argmin(distance))
    return [Shown("miss", nearest, float(distance[nearest]))]


def _distances(case: Case, query: int, references: NDArray[np.int64]) -> NDArray[np.float64] | None:
    """Return how far some references are from a query; None where labels are missing, or are ids."""
    places = case.places
    if places.queries is None or places.references is None or case.protocol.unit == "pair":
        return None
    apart = places.references[references] - places.queries[query]
    squares: NDArray[np.float64] = apart**2 if apart.ndim == 1 else (apart**2).sum(axis=1)
    return np.sqrt(squares)
