"""Where descriptors are kept and searched: all of them exactly, or approximately by FAISS."""

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import UsageError
from vpr_bench.types.match import Match

if TYPE_CHECKING:
    from vpr_baselines.faiss_index import FaissIndex

Metric = Literal["cosine", "euclidean", "manhattan"]
IndexName = Literal["exact", "hnsw", "ivf"]

_FILE = "database.npy"
_BLOCK = 1 << 16  # numbers whose differences are held at once: 256 KiB, which stays in a core's cache


class Index(Protocol):
    """Descriptors that can be searched."""

    def search(self, descriptor: NDArray[np.float32], k: int) -> Match:
        """Return the ``k`` nearest to a (D,) float32 descriptor with their scores, higher is better."""
        ...

    def save(self, folder: Path) -> None:
        """Write everything into an existing folder."""
        ...


class ExactIndex:
    """Compares with every reference.

    Parameters
    ----------
    database : (N, D) float32
        One descriptor per reference; of unit length for cosine.
    metric : {"cosine", "euclidean", "manhattan"}
        What the scores are.
    """

    def __init__(self, database: NDArray[np.float32], metric: Metric) -> None:
        self.database = database
        self.metric = metric

    def search(self, descriptor: NDArray[np.float32], k: int) -> Match:
        """Return the ``k`` nearest; equally near ones in the order of the references."""
        return Match.from_scores(self.scores(descriptor), k)

    def scores(self, descriptor: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return the score of every reference: (N,) float32.

        Distances are sums over differences, in blocks of rows. The product that is faster for Euclidean,
        |a|² + |b|² - 2ab, loses the small distances, which are the ones that count.
        """
        if self.metric == "cosine":
            return np.asarray(self.database @ descriptor, dtype=np.float32)
        count, length = self.database.shape
        rows = max(_BLOCK // max(length, 1), 1)
        room = np.empty((rows, length), dtype=np.float32)
        distances = np.empty(count, dtype=np.float32)
        for start in range(0, count, rows):
            block = self.database[start : start + rows]
            differences, target = room[: len(block)], distances[start : start + rows]
            np.subtract(block, descriptor, out=differences)
            if self.metric == "manhattan":
                np.abs(differences, out=differences).sum(axis=1, out=target)
            else:
                np.sqrt(np.einsum("nd,nd->n", differences, differences), out=target)
        return 0 - distances  # and not -0.0, which reads like a mistake

    def save(self, folder: Path) -> None:
        """Write the descriptors as ``database.npy``."""
        np.save(folder / _FILE, self.database, allow_pickle=False)

    @classmethod
    def load(cls, folder: Path, metric: Metric) -> "ExactIndex":
        """Read what :meth:`save` wrote."""
        return cls(np.load(folder / _FILE, allow_pickle=False), metric)


def check_index(index: IndexName, metric: Metric) -> None:
    """Check that there is such an index, before anything is described for it.

    Raises
    ------
    ValueError
        If the index knows no such metric.
    UsageError
        If FAISS is needed and not installed.
    """
    if index == "exact":
        return
    if metric == "manhattan":
        raise ValueError(f"the index {index!r} knows cosine and euclidean; manhattan needs index='exact'")
    if find_spec("faiss") is None:
        raise UsageError(f"index={index} needs FAISS: pip install 'vpr-bench[faiss]'.")


def build_index(index: IndexName, metric: Metric, database: NDArray[np.float32]) -> Index:
    """Index an (N, D) float32 database, which the index may keep."""
    check_index(index, metric)
    return ExactIndex(database, metric) if index == "exact" else _faiss_index().build(index, metric, database)


def load_index(index: IndexName, metric: Metric, folder: Path) -> Index:
    """Read what :meth:`Index.save` wrote."""
    return ExactIndex.load(folder, metric) if index == "exact" else _faiss_index().load(folder, metric)


def _faiss_index() -> "type[FaissIndex]":
    from vpr_baselines.faiss_index import FaissIndex

    return FaissIndex
