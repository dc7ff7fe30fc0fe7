"""The base of every method that describes images by one vector and compares vectors."""

from abc import abstractmethod
from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.indexes import ExactIndex, Index, IndexName, Metric, build_index, check_index, load_index
from vpr_bench.progress import track
from vpr_bench.timing import stage
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse

_SHORTEST = 1e-12  # the squares of smaller numbers vanish in float32, and lengths with them


@dataclass(kw_only=True)
class Retrieval:
    """Describe, index the references' descriptors, answer with the most similar ones.

    A method of this kind is a dataclass with a :meth:`describe`; what it compares by and how it searches are
    parameters that it inherits.

    Parameters
    ----------
    metric : {"cosine", "euclidean", "manhattan"}
        What the score is: the cosine similarity, in [-1, 1], or minus the distance.
    index : {"exact", "hnsw", "ivf"}
        ``exact`` compares with every reference. The others are approximate and fast on large maps, for cosine and
        Euclidean; they need FAISS.

    Examples
    --------
    >>> @dataclass
    ... class MeanColour(Retrieval):
    ...     def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
    ...         return image.mean(axis=(0, 1), dtype=np.float32)
    >>> red, green = (np.full((4, 6, 3), colour, np.uint8) for colour in ((9, 0, 0), (0, 9, 0)))
    >>> method = MeanColour(metric="manhattan")
    >>> method.fit(Traverse("map", [red, green]))
    >>> method.match(green, k=2)
    Match(indices=array([1, 0]), scores=array([  0., -18.], dtype=float32))
    """

    metric: Metric = "cosine"
    index: IndexName = "exact"

    def __post_init__(self) -> None:
        """Check that the index can be had.

        Raises
        ------
        ValueError
            If the index knows no such metric.
        UsageError
            If FAISS is needed and not installed.
        """
        check_index(self.index, self.metric)

    @abstractmethod
    def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into a (D,) float32 descriptor."""

    def fit(self, references: Traverse) -> None:
        """Describe every reference and index the descriptors."""
        for row, image in enumerate(track(references, "Describing references")):
            descriptor = self._described(image)
            if row == 0:  # filled row by row: a list and an array of a large map would be two large maps
                database = np.empty((len(references), len(descriptor)), dtype=np.float32)
            database[row] = descriptor
        self.index_: Index = build_index(self.index, self.metric, database)

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer with the ``k`` references of highest score."""
        with stage("encode"):
            descriptor = self._described(image)
        with stage("match"):
            return self.index_.search(descriptor, k)

    def scores(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return the (N,) float32 scores of all references.

        Raises
        ------
        ValueError
            If the index is approximate: it does not compare with all.
        """
        if not isinstance(self.index_, ExactIndex):
            raise ValueError(f"scores of all references need index='exact'. Got index={self.index!r} instead.")  # noqa: TRY004
        with stage("encode"):
            descriptor = self._described(image)
        with stage("match"):
            return self.index_.scores(descriptor)

    def save(self, folder: Path) -> None:
        """Write the index."""
        self.index_.save(folder)

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote."""
        self.index_ = load_index(self.index, self.metric, folder)
        return self

    def _described(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        descriptor = self.describe(image)
        return normalised(descriptor) if self.metric == "cosine" else descriptor


def normalised(vectors: NDArray[np.float32]) -> NDArray[np.float32]:
    """Scale (…, D) vectors to unit length along the last axis; those shorter than 1e-12 stay (almost) zero."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors / np.maximum(lengths, _SHORTEST), dtype=np.float32)
