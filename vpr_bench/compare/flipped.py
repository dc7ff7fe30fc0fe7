"""The queries that only one of two runs answers right, with what each answered."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.compare.pair import RunPair
from vpr_bench.metrics.answers import without_soft
from vpr_bench.metrics.flips import flips


@dataclass(frozen=True)
class Best:
    """The best match that a run has for a query; soft matches, neither right nor wrong, are passed over.

    Attributes
    ----------
    reference : int or None
        None where it answered nothing.
    score : float or None
        Higher is better; scores of two methods are not to be compared.
    """

    reference: int | None
    score: float | None


@dataclass(frozen=True)
class FlippedQuery:
    """A query that one run answers right and the other does not.

    Attributes
    ----------
    query : int
        In the numbering of the query traverse.
    gained : bool
        The second run is right; else the first.
    first, second : Best
        What they answered.
    truth : int
        The true match nearest to the query's place; the first one where places have no labels.
    """

    query: int
    gained: bool
    first: Best
    second: Best
    truth: int


def flipped_queries(pair: RunPair) -> tuple[list[FlippedQuery], list[FlippedQuery]]:
    """Find the queries on which two runs disagree.

    Returns
    -------
    lost, gained : list of FlippedQuery
        Only the first run is right, and only the second; by ascending number.
    """
    found = flips(*pair.answers)
    ranked = [without_soft(run.indices, run.scores, pair.truth) for run in (pair.first, pair.second)]

    def describe(query: int, *, gained: bool) -> FlippedQuery:
        row = int(np.searchsorted(pair.first.queries, query))
        first, second = (_best(*answers, row) for answers in ranked)
        truth = pair.first.places.nearest_of(row, pair.truth[row])
        return FlippedQuery(query, gained, first, second, truth)

    lost = [describe(query, gained=False) for query in found.lost.tolist()]
    return lost, [describe(query, gained=True) for query in found.gained.tolist()]


def _best(indices: NDArray[np.int64], scores: NDArray[np.floating], row: int) -> Best:
    reference = int(indices[row, 0])
    return Best(None, None) if reference < 0 else Best(reference, float(scores[row, 0]))
