"""Which references were still in the running after a step of answering, for every query of a run."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

Shortlist = NDArray[np.int32] | None
"""Ascending references; None where a step ruled nothing out, or was not taken."""

_STEPS, _PREFIX = "steps", "step"
_LONGEST_NAME = 40


@dataclass(frozen=True, eq=False)
class Survivors:
    """What one step left of the map, query by query, kept sparse (compressed rows).

    Attributes
    ----------
    step : str
        What the method calls the step.
    narrowed : (n_queries,) bool
        Whether the step ruled anything out. Where it did not, what was in the running before it still is.
    offsets : (n_queries + 1,) int64
        The references left for query ``i`` are ``references[offsets[i]:offsets[i + 1]]``.
    references : (m,) int32
        Reference indices, ascending and unique within each query; none where the step did not narrow.

    Examples
    --------
    >>> [step] = gathered([{"clusters": np.array([4, 5], dtype=np.int32)}, {"clusters": None}])
    >>> step.step, step[0].tolist(), step[1]
    ('clusters', [4, 5], None)
    """

    step: str
    narrowed: NDArray[np.bool_]
    offsets: NDArray[np.int64]
    references: NDArray[np.int32]

    def __post_init__(self) -> None:
        """Check the structure, for it may come from a file."""
        check_step_name(self.step)
        if self.offsets.ndim != 1 or self.narrowed.shape != (len(self.offsets) - 1,):
            raise ValueError("there must be one offset more than queries")
        sizes = np.diff(self.offsets)
        if self.offsets[0] != 0 or self.offsets[-1] != len(self.references) or (sizes < 0).any():
            raise ValueError(f"offsets must ascend from 0 to {len(self.references)}")
        if sizes[~self.narrowed].any():
            raise ValueError("where a step ruled nothing out it lists nothing")

    def __len__(self) -> int:
        """Return the number of queries."""
        return len(self.narrowed)

    def __getitem__(self, query: int) -> Shortlist:
        """Return the references left for one query, None where the step ruled nothing out."""
        return self.references[self.offsets[query] : self.offsets[query + 1]] if self.narrowed[query] else None

    @property
    def sizes(self) -> NDArray[np.int64]:
        """(n_queries,) int64: how many references are listed."""
        return np.diff(self.offsets)

    @property
    def query_of_entry(self) -> NDArray[np.int64]:
        """(m,) int64: the query of each listed reference, beside ``references``."""
        return np.repeat(np.arange(len(self), dtype=np.int64), self.sizes)


def check_step_name(step: object) -> None:
    """Refuse what cannot stand in a table's head.

    Raises
    ------
    ValueError
        If it is no text, or an empty, long or unprintable one.
    """
    if not isinstance(step, str) or not 0 < len(step) <= _LONGEST_NAME or not step.isprintable():
        raise ValueError(f"a shortlist's name must be printable text of 1 to {_LONGEST_NAME} marks. Got {step!r}.")


def gathered(shortlists: Sequence[Mapping[str, Shortlist]]) -> list[Survivors]:
    """Turn one mapping from step to shortlist per query into one :class:`Survivors` per step, in the steps' order.

    Steps that only some queries took are put behind what preceded them there.
    """
    return [_gathered(step, [of_query.get(step) for of_query in shortlists]) for step in _order(shortlists)]


def _order(shortlists: Sequence[Mapping[str, Shortlist]]) -> list[str]:
    order: list[str] = []
    for steps in {tuple(of_query): None for of_query in shortlists}:
        place = 0
        for step in steps:
            if step not in order:
                order.insert(place, step)
            place = order.index(step) + 1
    return order


def _gathered(step: str, rows: Sequence[Shortlist]) -> Survivors:
    offsets = np.zeros(len(rows) + 1, dtype=np.int64)
    np.cumsum([0 if row is None else len(row) for row in rows], out=offsets[1:])
    listed = [row for row in rows if row is not None]
    references = np.concatenate([np.empty(0, np.int32), *listed]).astype(np.int32, copy=False)
    return Survivors(step, np.array([row is not None for row in rows], dtype=bool), offsets, references)


def to_arrays(survivors: Sequence[Survivors]) -> dict[str, NDArray[np.generic]]:
    """Name everything for an ``.npz``; nothing at all without steps. :func:`from_arrays` reads it."""
    if not survivors:
        return {}
    arrays: dict[str, NDArray[np.generic]] = {_STEPS: np.array([one.step for one in survivors])}
    for number, one in enumerate(survivors):
        for name in ("narrowed", "offsets", "references"):
            arrays[f"{_PREFIX}{number}.{name}"] = getattr(one, name)
    return arrays


def from_arrays(
    arrays: Mapping[str, NDArray[Any]], n_queries: int, n_references: int = np.iinfo(np.int32).max
) -> list[Survivors]:
    """Read what :func:`to_arrays` made, and check it: it may come from elsewhere.

    Raises
    ------
    ValueError, KeyError
        If it is something else, or not about so many queries and references.
    """
    steps = arrays[_STEPS].tolist() if _STEPS in arrays else []
    survivors = []
    for number, step in enumerate(steps):
        narrowed, offsets, references = (
            arrays[f"{_PREFIX}{number}.{name}"] for name in ("narrowed", "offsets", "references")
        )
        if narrowed.dtype != bool or not {offsets.dtype.kind, references.dtype.kind} <= {"i"} or references.ndim != 1:
            raise ValueError("a shortlist must be made of integers")
        if narrowed.shape != (n_queries,):
            raise ValueError(f"shortlists must be there for {n_queries} queries. Got {narrowed.shape} instead.")
        if len(references) and not 0 <= references.min() <= references.max() < n_references:
            raise ValueError(f"shortlisted references must lie in [0, {n_references})")
        survivors.append(Survivors(step, narrowed, offsets.astype(np.int64), references.astype(np.int32)))
    if any(first.step == second.step for first, second in pairwise(sorted(survivors, key=lambda one: one.step))):
        raise ValueError("two steps have the same name")
    return survivors
