"""Lowe's ratio test of a query against every image of a map."""

import heapq
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray

from vpr_baselines.sift.keypoints import KeyPoints, root_sift
from vpr_baselines.sift.products import RoughProducts, one_thread

_FILE = "keypoints.npz"


@dataclass(frozen=True)
class Pairs:
    """Key points of a query and of one reference that match.

    Attributes
    ----------
    query, reference : (n,) int64
        Which key points.
    similarities : (n,) float64
        Products of their descriptors, in [0, 1].
    """

    query: NDArray[np.int64]
    reference: NDArray[np.int64]
    similarities: NDArray[np.float64]

    @property
    def score(self) -> float:
        """The number of pairs; the mean of their similarities, less than one more pair, decides between equals."""
        return len(self.query) + float(self.similarities.mean()) if len(self.query) else 0.0


class KeyPointMap:
    """The key points of every reference.

    Parameters
    ----------
    n_images, n_features : int
        Reference images, and at most so many key points in each.
    """

    def __init__(self, n_images: int, n_features: int) -> None:
        self._positions = np.zeros((n_images, n_features, 2), dtype=np.float32)
        self._counts = np.zeros(n_images, dtype=np.int64)
        self._products = RoughProducts(n_images, n_features)

    def __len__(self) -> int:
        """Return the number of reference images."""
        return len(self._counts)

    def put(self, image: int, points: KeyPoints) -> None:
        """Set the key points of one reference."""
        count = len(points.positions)
        self._positions[image, :count], self._counts[image] = points.positions, count
        self._products.put(image, root_sift(points.descriptors))

    def positions(self, image: int) -> NDArray[np.float32]:
        """Return the (n, 2) float32 positions of one reference's key points."""
        return self._positions[image, : self._counts[image]]

    def best(self, query: KeyPoints, ratio: float, k: int) -> dict[int, Pairs]:
        """Find the pairs in the ``k`` references that have the highest scores, of those that have any.

        References are looked at in the order of how many pairs they have at most, by the rough products, until
        those that are left cannot be among the best. The answer is that of looking at all.

        Returns
        -------
        dict of int to Pairs
            By reference; possibly more than ``k`` of them.
        """
        with one_thread():
            return self._best(root_sift(query.descriptors), ratio, k)

    def _best(self, descriptors: NDArray[np.float32], ratio: float, k: int) -> dict[int, Pairs]:
        candidates = self._products.may_pass(descriptors, ratio)
        candidates[self._counts < 2] = False  # nothing is nearest where there is no second nearest
        at_most = np.count_nonzero(candidates, axis=1)
        found: dict[int, Pairs] = {}
        highest: list[float] = []  # the k highest scores so far, a heap
        for image in np.argsort(-at_most, kind="stable").tolist():
            if at_most[image] == 0 or (len(highest) == k and highest[0] > at_most[image] + 1):
                break
            pairs = self._pairs(image, descriptors, np.flatnonzero(candidates[image]), ratio)
            if pairs.score > 0:
                found[image] = pairs
                (heapq.heappush if len(highest) < k else heapq.heappushpop)(highest, pairs.score)
        return found

    def _pairs(self, image: int, query: NDArray[np.float32], rows: NDArray[np.int64], ratio: float) -> Pairs:
        """Do the ratio test on some descriptors of a query and all of one reference."""
        reference = self._products.get(image, self._counts[image])
        products = np.minimum(torch.mm(torch.from_numpy(query[rows]), torch.from_numpy(reference).T).numpy(), 1)
        every, nearest = np.arange(len(rows)), products.argmax(axis=1)
        first = products[every, nearest]
        products[every, nearest] = -1
        # Distances of unit vectors are √(2 - 2s).
        passes = 1 - first < ratio**2 * (1 - products.max(axis=1))
        rows, nearest = rows[passes], nearest[passes]
        # Once more in double precision: how float32 is rounded depends on how many rows are multiplied at once.
        similarities = np.einsum("nd,nd->n", query[rows], reference[nearest], dtype=np.float64)
        return Pairs(rows, nearest, np.minimum(similarities, 1))

    def save(self, folder: Path) -> None:
        """Write all key points as ``keypoints.npz``."""
        np.savez(folder / _FILE, products=self._products.packed(), positions=self._positions, counts=self._counts)

    @classmethod
    def load(cls, folder: Path) -> "KeyPointMap":
        """Read what :meth:`save` wrote."""
        with np.load(folder / _FILE, allow_pickle=False) as stored:
            made = cls(*stored["positions"].shape[:2])
            made._positions, made._counts = stored["positions"], stored["counts"]
            made._products.unpack(stored["products"])
        return made
