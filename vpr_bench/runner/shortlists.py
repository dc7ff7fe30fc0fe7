"""What a method noted as its shortlists, once it has been seen to be true."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.types.match import Match
from vpr_bench.types.survivors import Shortlist, check_step_name


def checked(noted: Mapping[str, NDArray[Any] | None], match: Match, n_references: int) -> dict[str, Shortlist]:
    """Check the shortlists of one query, and sort each.

    Parameters
    ----------
    noted : dict
        As collected by :func:`vpr_bench.shortlist.collect_shortlists`.
    match : Match
        What was answered in the end.
    n_references : int
        Size of the map.

    Returns
    -------
    dict
        By step (m,) int32 ascending, or None.

    Raises
    ------
    ValueError
        If a shortlist is not made of different references, or names one that a step before had ruled out, or if the
        best answer had been.
    """
    shortlists: dict[str, Shortlist] = {}
    before, before_name = None, ""
    for step, indices in noted.items():
        check_step_name(step)
        shortlists[step] = None if indices is None else _sorted(step, indices, n_references)
        now = shortlists[step]
        if now is None:
            continue
        if before is not None and (revived := _outside(now, before)).size:
            raise ValueError(
                f"the shortlist {step!r} names reference {revived[0]}, which {before_name!r} had ruled out"
            )
        before, before_name = now, step
    if before is not None and (revived := _outside(match.indices[:1], before)).size:
        raise ValueError(f"the best answer is reference {revived[0]}, which {before_name!r} had ruled out")
    return shortlists


def _sorted(step: str, indices: NDArray[Any], n_references: int) -> NDArray[np.int32]:
    if indices.ndim != 1:
        raise ValueError(f"the shortlist {step!r} must have shape (m,). Got {indices.shape} instead.")
    if indices.size and not np.issubdtype(indices.dtype, np.integer):
        raise ValueError(f"the shortlist {step!r} must be made of integers. Got dtype {indices.dtype} instead.")
    ascending = np.sort(indices)
    if indices.size and not 0 <= ascending[0] <= ascending[-1] < n_references:
        wrong = ascending[0] if ascending[0] < 0 else ascending[-1]
        raise ValueError(f"the shortlist {step!r} names reference {wrong} of a map of {n_references}")
    twice = ascending[1:][ascending[1:] == ascending[:-1]]
    if twice.size:
        raise ValueError(f"the shortlist {step!r} names reference {twice[0]} twice")
    return ascending.astype(np.int32)


def _outside(some: NDArray[np.integer], ascending: NDArray[np.int32]) -> NDArray[np.integer]:
    """Return those that are not among the ascending ones."""
    place = np.searchsorted(ascending, some)
    there = np.zeros(len(some), dtype=bool)
    inside = place < len(ascending)
    there[inside] = ascending[place[inside]] == some[inside]
    return some[~there]
