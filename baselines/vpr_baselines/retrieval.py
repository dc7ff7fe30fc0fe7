"""The base of every method that describes images by one vector and compares vectors."""

from abc import abstractmethod
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from vpr_bench.progress import track
from vpr_bench.timing import stage
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse

_SHORTEST = 1e-12  # the squares of smaller numbers vanish in float32, and lengths with them


class Retrieval:
    """Describe, keep the references' descriptors, answer with the most similar ones by cosine.

    A subclass is a dataclass with a :meth:`describe`.
    """

    database_: NDArray[np.float32]
    """(N, D) float32, unit length: one descriptor per reference."""

    @abstractmethod
    def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into a (D,) float32 descriptor."""

    def fit(self, references: Traverse) -> None:
        """Describe every reference."""
        for index, image in enumerate(track(references, "Describing references")):
            descriptor = normalised(self.describe(image))
            if index == 0:  # filled row by row: a list and an array of a large map would be two large maps
                self.database_ = np.empty((len(references), len(descriptor)), dtype=np.float32)
            self.database_[index] = descriptor

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer with the ``k`` references of highest cosine similarity; it is the score, in [-1, 1]."""
        with stage("encode"):
            descriptor = normalised(self.describe(image))
        with stage("match"):
            return Match.from_scores(self.database_ @ descriptor, k)

    def save(self, folder: Path) -> None:
        """Write the descriptors as ``database.npy``."""
        np.save(folder / "database.npy", self.database_, allow_pickle=False)

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote."""
        self.database_ = np.load(folder / "database.npy", allow_pickle=False)
        return self


def normalised(vectors: NDArray[np.float32]) -> NDArray[np.float32]:
    """Scale (…, D) vectors to unit length along the last axis; those shorter than 1e-12 stay (almost) zero."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors / np.maximum(lengths, _SHORTEST), dtype=np.float32)
