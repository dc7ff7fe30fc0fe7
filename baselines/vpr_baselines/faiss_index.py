"""Approximate search by FAISS (Douze et al., arXiv:2401.08281); imported only when it is asked for."""

from pathlib import Path
from typing import Any, Literal

import faiss
import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from vpr_bench.types.match import Match

_FILE = "database.faiss"
_LINKS, _BUILD_BREADTH, _BREADTH = 32, 200, 128  # of HNSW's graph; recall@1 against exact search is about .99
_PROBED = 0.1  # share of IVF's cells that a query looks into, at least _FEWEST_PROBED
_FEWEST_PROBED = 8


class FaissIndex:
    """A FAISS index of descriptors.

    Parameters
    ----------
    index : faiss.Index
        Filled.
    metric : {"cosine", "euclidean"}
        What the scores are.
    """

    def __init__(self, index: Any, metric: str) -> None:
        self._index = index
        self._metric = metric

    @classmethod
    def build(cls, name: Literal["hnsw", "ivf"], metric: str, database: NDArray[np.float32]) -> "FaissIndex":
        """Index an (N, D) float32 database.

        ``hnsw`` is a navigable graph (Malkov and Yashunin, PAMI 2020); ``ivf`` sorts the descriptors into √N cells
        around k-means centres and searches the nearest ones (Sivic and Zisserman, ICCV 2003).
        """
        count, length = database.shape
        distance = faiss.METRIC_INNER_PRODUCT if metric == "cosine" else faiss.METRIC_L2
        if name == "hnsw":
            index = faiss.IndexHNSWFlat(length, _LINKS, distance)
            index.hnsw.efConstruction = _BUILD_BREADTH
        else:
            cells = max(round(count**0.5), 1)
            index = faiss.index_factory(length, f"IVF{cells},Flat", distance)
            index.cp.min_points_per_centroid = 1  # small maps are no reason for a warning
            index.nprobe = max(_FEWEST_PROBED, round(_PROBED * cells))
        with threadpool_limits(1):  # threads add to the graph in the order they come: another map every time
            index.train(database)
            index.add(database)
        return cls(index, metric)

    def search(self, descriptor: NDArray[np.float32], k: int) -> Match:
        """Return about the ``k`` nearest; all references if there are no more."""
        k = min(k, self._index.ntotal)
        graph = hasattr(self._index, "hnsw")
        options = {"params": faiss.SearchParametersHNSW(efSearch=max(_BREADTH, 2 * k))} if graph else {}
        found, indices = self._index.search(descriptor[np.newaxis], k, **options)
        if indices[0, -1] < 0:  # where it looked there are fewer: it looks everywhere
            if graph:
                found, indices = faiss.downcast_index(self._index.storage).search(descriptor[np.newaxis], k)
            else:
                everywhere = faiss.SearchParametersIVF(nprobe=self._index.nlist)
                found, indices = self._index.search(descriptor[np.newaxis], k, params=everywhere)
        return Match(indices[0], found[0] if self._metric == "cosine" else 0 - np.sqrt(np.maximum(found[0], 0)))

    def save(self, folder: Path) -> None:
        """Write the index as ``database.faiss``."""
        faiss.write_index(self._index, str(folder / _FILE))

    @classmethod
    def load(cls, folder: Path, metric: str) -> "FaissIndex":
        """Read what :meth:`save` wrote."""
        return cls(faiss.read_index(str(folder / _FILE)), metric)
