"""Which references show the same place as a query: the thesis's conversion of many classes to two (4.4)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from vpr_bench.errors import UsageError


@dataclass(frozen=True, eq=False)
class GroundTruth:
    """For each query the sorted set of references within the radius, kept sparse (compressed rows).

    Attributes
    ----------
    offsets : (n_queries + 1,) int64
        The references of query ``i`` are ``references[offsets[i]:offsets[i + 1]]``.
    references : (n_pairs,) int64
        Reference indices, ascending and unique within each query, in ``[0, n_references)``.
    n_references : int
        How many references the map has.
    soft : GroundTruth, optional
        Pairs that are neither right nor wrong, such as places that are seen from too far away to be sure: an
        answer among them is passed over, as if it had not been given. They hold none of the pairs above.

    Examples
    --------
    >>> truth = GroundTruth.from_radius([0, 1, 9], [0, 1, 2, 3], radius=1)
    >>> [truth[query].tolist() for query in range(3)]
    [[0, 1], [0, 1, 2], []]
    """

    offsets: NDArray[np.int64]
    references: NDArray[np.int64]
    n_references: int
    soft: "GroundTruth | None" = None

    def __post_init__(self) -> None:
        """Check the structure, so that a ground truth that exists is a valid one."""
        self._check_structure()
        if self.soft is not None:
            soft = self.soft
            if (soft.n_queries, soft.n_references) != (self.n_queries, self.n_references):
                raise ValueError(
                    f"soft matches relate {soft.n_queries} queries to {soft.n_references} references, "
                    f"the others {self.n_queries} to {self.n_references}"
                )
            if self.contains(soft.query_of_pair, soft.references).any():
                raise ValueError("a pair cannot be right and soft at once")

    def _check_structure(self) -> None:
        offsets, references = self.offsets, self.references
        if offsets.ndim != 1 or len(offsets) == 0 or offsets[0] != 0 or offsets[-1] != len(references):
            raise ValueError(f"offsets must run from 0 to {len(references)}, the number of pairs")
        if np.any(np.diff(offsets) < 0):
            raise ValueError("offsets must not decrease")
        if len(references) and (references.min() < 0 or references.max() >= self.n_references):
            raise ValueError(
                f"reference indices must lie in [0, {self.n_references}); "
                f"found {references.min()} to {references.max()}"
            )
        ascending = np.diff(references) > 0
        inner = np.ones(len(references), dtype=bool)
        inner[offsets[:-1][offsets[:-1] < len(references)]] = False  # first of its query
        if not np.all(ascending[inner[1:]] if len(references) else True):
            raise ValueError("the references of one query must be ascending and unique")

    @classmethod
    def from_radius(cls, query_labels: ArrayLike, reference_labels: ArrayLike, radius: float) -> "GroundTruth":
        """Call a query and a reference the same place if their labels are at most ``radius`` apart.

        Parameters
        ----------
        query_labels, reference_labels : (n,) or (n, d)
            Place labels: frame numbers or pair ids as one column, positions in metres as ``d`` columns.
            The distance is Euclidean; pair ids are compared with radius 0.
        radius : float
            In the unit of the labels, finite and not negative; inclusive.

        Raises
        ------
        UsageError
            If the radius is negative or not finite.
        ValueError
            If the labels are not finite or of different dimension.
        """
        if not np.isfinite(radius) or radius < 0:
            raise UsageError(f"The radius must be a number of at least 0. Got {radius!r} instead.")
        queries, references = _as_columns(query_labels), _as_columns(reference_labels)
        if queries.shape[1] != references.shape[1]:
            raise ValueError(f"query labels have {queries.shape[1]} columns, reference labels {references.shape[1]}")
        if queries.shape[1] == 1:
            return cls._from_scalars(queries[:, 0], references[:, 0], radius)
        return cls._from_positions(queries, references, radius)

    @classmethod
    def _from_scalars(
        cls, queries: NDArray[np.float64], references: NDArray[np.float64], radius: float
    ) -> "GroundTruth":
        order = np.argsort(references, kind="stable")
        ordered = references[order]
        # Wider than asked by more than any rounding, then filtered by the definition itself: exact.
        reach = radius + 4 * np.finfo(np.float64).eps * (np.abs(queries) + radius)
        first = np.searchsorted(ordered, queries - reach, side="left")
        last = np.searchsorted(ordered, queries + reach, side="right")
        rows, columns = _expand(first, last)
        columns = order[columns]
        near = np.abs(queries[rows] - references[columns]) <= radius
        return cls.from_pairs(rows[near], columns[near], len(queries), len(references))

    @classmethod
    def _from_positions(
        cls, queries: NDArray[np.float64], references: NDArray[np.float64], radius: float
    ) -> "GroundTruth":
        from scipy.spatial import cKDTree

        found = cKDTree(references).query_ball_point(queries, radius * (1 + 1e-9) + 1e-12)
        rows = np.repeat(np.arange(len(queries)), [len(row) for row in found])
        columns = np.concatenate([np.asarray(row, dtype=np.int64) for row in found] or [np.empty(0, np.int64)])
        near = np.sqrt(((queries[rows] - references[columns]) ** 2).sum(axis=1)) <= radius
        return cls.from_pairs(rows[near], columns[near], len(queries), len(references))

    @classmethod
    def from_pairs(cls, queries: ArrayLike, references: ArrayLike, n_queries: int, n_references: int) -> "GroundTruth":
        """Build from (query, reference) index pairs in any order; repeated pairs count once."""
        rows = np.asarray(queries, dtype=np.int64)
        columns = np.asarray(references, dtype=np.int64)
        if rows.shape != columns.shape:
            raise ValueError(f"a pair needs a query and a reference. Got {rows.shape} and {columns.shape}.")
        if len(rows) and (rows.min() < 0 or rows.max() >= n_queries):
            raise ValueError(f"query indices must lie in [0, {n_queries}); found {rows.min()} to {rows.max()}")
        if len(columns) and (columns.min() < 0 or columns.max() >= n_references):
            raise ValueError(
                f"reference indices must lie in [0, {n_references}); found {columns.min()} to {columns.max()}"
            )
        keys = np.unique(rows * np.int64(max(n_references, 1)) + columns)
        rows, columns = np.divmod(keys, max(n_references, 1))
        offsets = np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=n_queries))]).astype(np.int64)
        return cls(offsets, columns, n_references)

    @classmethod
    def from_lists(
        cls,
        references_of_query: Sequence[Sequence[int]],
        n_references: int,
        queries_of_reference: Sequence[Sequence[int]] | None = None,
    ) -> "GroundTruth":
        """Build from explicit lists, one list of references per query.

        If the inverse lists are given too, they must say the same.

        Raises
        ------
        ValueError
            If an index is out of range or the two directions contradict each other.
        """
        rows = np.repeat(np.arange(len(references_of_query)), [len(row) for row in references_of_query])
        columns = [reference for row in references_of_query for reference in row]
        truth = cls.from_pairs(rows, columns, len(references_of_query), n_references)
        if queries_of_reference is not None:
            inverse = cls.from_lists(queries_of_reference, truth.n_queries).transpose()
            if inverse != truth:
                raise ValueError("the ground truth is not symmetric: the lists of the two directions differ")
        return truth

    def with_soft(self, soft: "GroundTruth") -> "GroundTruth":
        """Return the same ground truth with pairs that are neither right nor wrong; those that are right stay right."""
        rows, columns = soft.query_of_pair, soft.references
        open_ = ~self.contains(rows, columns)
        return replace(
            self, soft=GroundTruth.from_pairs(rows[open_], columns[open_], soft.n_queries, soft.n_references)
        )

    def take(self, queries: ArrayLike) -> "GroundTruth":
        """Return the ground truth of some of the queries, in that order."""
        chosen = np.asarray(queries, dtype=np.int64)
        rows, pairs = _expand(self.offsets[chosen], self.offsets[chosen + 1])
        taken = GroundTruth.from_pairs(rows, self.references[pairs], len(chosen), self.n_references)
        return taken if self.soft is None else taken.with_soft(self.soft.take(chosen))

    @property
    def n_queries(self) -> int:
        """How many queries there are."""
        return len(self.offsets) - 1

    @property
    def has_match(self) -> NDArray[np.bool_]:
        """(n_queries,) bool: whether the query has at least one true match."""
        return np.diff(self.offsets) > 0

    def __getitem__(self, query: int) -> NDArray[np.int64]:
        """Return the sorted references that show the same place as ``query``."""
        if not 0 <= query < self.n_queries:
            raise IndexError(f"queries are numbered 0 to {self.n_queries - 1}. Got {query} instead.")
        return self.references[self.offsets[query] : self.offsets[query + 1]]

    def __eq__(self, other: object) -> bool:
        """Compare by content."""
        if not isinstance(other, GroundTruth):
            return NotImplemented
        return (
            self.n_references == other.n_references
            and np.array_equal(self.offsets, other.offsets)
            and np.array_equal(self.references, other.references)
            and self.soft == other.soft
        )

    __hash__ = None  # type: ignore[assignment]

    def contains(self, queries: ArrayLike, references: ArrayLike) -> NDArray[np.bool_]:
        """Say for each (query, reference) pair whether both show the same place.

        Parameters
        ----------
        queries, references : int arrays that broadcast against each other
            Indices; a reference of -1 (nothing answered) is never right.

        Returns
        -------
        bool array of the broadcast shape
        """
        rows, columns = np.broadcast_arrays(np.asarray(queries), np.asarray(references))
        true_keys = self.query_of_pair * np.int64(max(self.n_references, 1)) + self.references
        keys = rows.astype(np.int64) * max(self.n_references, 1) + columns
        position = np.searchsorted(true_keys, keys)
        found = np.zeros(keys.shape, dtype=bool)
        inside = (position < len(true_keys)) & (columns >= 0) & (columns < self.n_references)
        found[inside] = true_keys[position[inside]] == keys[inside]
        return found

    @property
    def query_of_pair(self) -> NDArray[np.int64]:
        """(n_pairs,) int64: the query of each pair, beside ``references``."""
        return np.repeat(np.arange(self.n_queries, dtype=np.int64), np.diff(self.offsets))

    def transpose(self) -> "GroundTruth":
        """Swap the roles of queries and references."""
        swapped = GroundTruth.from_pairs(self.references, self.query_of_pair, self.n_references, self.n_queries)
        return swapped if self.soft is None else swapped.with_soft(self.soft.transpose())


def _as_columns(labels: ArrayLike) -> NDArray[np.float64]:
    columns = np.asarray(labels, dtype=np.float64)
    if columns.ndim == 1:
        columns = columns[:, None]
    if columns.ndim != 2:
        raise ValueError(f"labels must have shape (n,) or (n, d). Got {columns.shape} instead.")
    if not np.isfinite(columns).all():
        raise ValueError("labels must be finite; use an explicit ground truth for queries without a place")
    return columns


def _expand(first: NDArray[np.int64], last: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Turn ranges [first, last) into (row, column) pairs."""
    counts = last - first
    rows = np.repeat(np.arange(len(first)), counts)
    starts = np.repeat(first - np.concatenate([[0], np.cumsum(counts)[:-1]]), counts)
    return rows, starts + np.arange(len(rows))
