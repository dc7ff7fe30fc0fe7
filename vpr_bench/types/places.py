"""What decides which references show the same place as a query, at any radius."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from vpr_bench.errors import UsageError
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import UNMEASURED, Protocol


@dataclass(frozen=True, eq=False)
class Places:
    """The place labels of queries and references, and the pairs that the dataset itself lists, as far as there are any.

    Attributes
    ----------
    queries, references : (n,) or (n, d) float64, optional
        Place labels: frame numbers or pair ids, or positions in metres.
    given : GroundTruth, optional
        What a file of the dataset lists, soft matches included.
    """

    queries: NDArray[np.float64] | None = None
    references: NDArray[np.float64] | None = None
    given: GroundTruth | None = None

    def ground_truth(self, protocol: Protocol) -> GroundTruth:
        """Return which references are right for each query, at the protocol's radius.

        Raises
        ------
        UsageError
            If there is nothing to say so in this unit, or every answer would be right.
        """
        self.check(protocol)
        if protocol.unit == "given":
            return self._listed(protocol)
        queries, references = self._labels(protocol)
        if protocol.unit == "nearest":
            return nearest(queries, references, int(protocol.radius))
        return GroundTruth.from_radius(queries, references, protocol.radius)

    def check(self, protocol: Protocol) -> None:
        """Refuse a protocol in which nothing says what is right, or every answer would be.

        Raises
        ------
        UsageError
            If what its unit needs is not there, or its radius reaches from one end of the map to the other.
        """
        if protocol.unit == "given":
            self._listed(protocol)
            return
        _, references = self._labels(protocol)
        if protocol.unit in UNMEASURED:
            return
        size = len(references)
        if protocol.unit == "nearest":
            extent = float(size)
        else:
            extent = float(np.ptp(references, axis=0).max()) if size > 1 else float("inf")
        if protocol.radius >= extent:
            unit = "" if protocol.unit == "nearest" else protocol.unit
            raise UsageError(
                f"The radius {protocol.reach} reaches over the whole map ({extent:g}{unit} from end to end): "
                "every answer would be right. Give a smaller one."
            )

    def distances(self, query: int, references: NDArray[np.int64]) -> NDArray[np.float64]:
        """(n,) float64: how far these references lie from a query, by their labels.

        Raises
        ------
        UsageError
            If there are no labels.
        """
        if self.queries is None or self.references is None:
            raise UsageError("Without place labels there is no distance.")
        away = (self.references[references] - self.queries[query]).reshape(len(references), -1)
        return np.asarray(np.linalg.norm(away, axis=1))

    def nearest_of(self, query: int, references: NDArray[np.int64]) -> int:
        """Return which of at least one reference lies nearest to a query; the first one where there are no labels.

        Examples
        --------
        >>> places = Places(queries=np.array([4.0]), references=np.array([0.0, 3.0, 9.0]))
        >>> places.nearest_of(0, np.array([0, 1, 2])), Places().nearest_of(0, np.array([2, 1]))
        (1, 2)
        """
        if self.queries is None or self.references is None:
            return int(references[0])
        return int(references[self.distances(query, references).argmin()])

    def take(self, queries: ArrayLike) -> "Places":
        """Return what is known about some of the queries, in that order."""
        chosen = np.asarray(queries, dtype=np.int64)
        return replace(
            self,
            queries=None if self.queries is None else self.queries[chosen],
            given=None if self.given is None else self.given.take(chosen),
        )

    def arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return everything as named arrays, to be stored: :meth:`from_arrays` reads them."""
        arrays: dict[str, NDArray[np.generic]] = {}
        if self.queries is not None and self.references is not None:
            arrays |= {"queries": self.queries, "references": self.references}
        if self.given is not None:
            arrays["size"] = np.array([self.given.n_queries, self.given.n_references], dtype=np.int64)
            arrays["given"] = _pairs(self.given)
            if self.given.soft is not None:
                arrays["soft"] = _pairs(self.given.soft)
        return arrays

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> "Places":
        """Read what :meth:`arrays` returned.

        Raises
        ------
        ValueError, KeyError
            If they are something else.
        """
        given = None
        if "given" in arrays:
            given = _truth(arrays["given"], arrays["size"])
            if "soft" in arrays:
                given = given.with_soft(_truth(arrays["soft"], arrays["size"]))
        return cls(arrays.get("queries"), arrays.get("references"), given)

    def _listed(self, protocol: Protocol) -> GroundTruth:
        if self.given is None:
            raise UsageError(f"{protocol.source} lists no ground truth for {protocol.pairing}.")
        return self.given

    def _labels(self, protocol: Protocol) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        if self.queries is None or self.references is None:
            raise UsageError(f"{protocol.source} has no place labels: only @given says what is right.")
        return self.queries, self.references


def nearest(query_labels: ArrayLike, reference_labels: ArrayLike, count: int) -> GroundTruth:
    """Call the ``count`` references nearest to a query its place, and those exactly as far as the last of them.

    Parameters
    ----------
    query_labels, reference_labels : (n,) or (n, d) floats
        Place labels; the distance is Euclidean.
    count : int
        At least 1 and at most the number of references.

    Examples
    --------
    >>> nearest([0.0, 4.0], [0.0, 1.0, 2.0, 9.0], count=2)[1].tolist()
    [1, 2]
    """
    from scipy.spatial import cKDTree

    queries, references = (np.asarray(labels, dtype=np.float64) for labels in (query_labels, reference_labels))
    queries, references = queries.reshape(len(queries), -1), references.reshape(len(references), -1)
    if not 1 <= count <= len(references):
        raise UsageError(f"There are {len(references)} references. Got {count} nearest of them instead.")
    tree = cKDTree(references)
    reach = np.asarray(tree.query(queries, k=[count])[0])[:, 0]
    # Wider than asked by more than any rounding, then filtered by one and the same formula: ties are exact.
    found = tree.query_ball_point(queries, reach * (1 + 1e-9) + 1e-12)
    lengths = np.array([len(row) for row in found], dtype=np.int64)
    rows = np.repeat(np.arange(len(queries)), lengths)
    columns = np.concatenate([np.asarray(row, dtype=np.int64) for row in found] or [np.empty(0, np.int64)])
    distance = ((queries[rows] - references[columns]) ** 2).sum(axis=1)
    by_distance = np.lexsort((distance, rows))
    last = distance[by_distance][np.cumsum(lengths) - lengths + count - 1]
    near = distance <= last[rows]
    return GroundTruth.from_pairs(rows[near], columns[near], len(queries), len(references))


def _pairs(truth: GroundTruth) -> NDArray[np.int64]:
    return np.stack([truth.query_of_pair, truth.references], axis=1)


def _truth(pairs: NDArray[np.int64], size: NDArray[np.int64]) -> GroundTruth:
    return GroundTruth.from_pairs(pairs[:, 0], pairs[:, 1], int(size[0]), int(size[1]))
