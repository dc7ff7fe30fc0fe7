"""The floor: answers that have nothing to do with what is seen."""

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, ClassVar, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_bench.progress import track
from vpr_bench.timing import stage
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse

_FILE = "marks.npy"


@dataclass
class Random:
    """Seeded random scores: what any method must beat.

    The score of a query and a reference is drawn from the pixels of both and the seed, uniformly from [0, 1): it
    depends neither on the order of the queries nor on that of the references.

    Parameters
    ----------
    seed : int
        Another seed, other answers.
    """

    version: ClassVar[str] = "1"
    expected_failures: ClassVar[dict[str, str]] = {
        "finds-the-same-image": "answers have nothing to do with what is seen",
    }

    seed: Annotated[int, Field(ge=0)] = 0

    def fit(self, references: Traverse) -> None:
        """Mark every reference by its pixels."""
        marks = [self._mark(image) for image in track(references, "Marking references")]
        self.marks_ = np.array(marks, dtype=np.uint64)

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer with ``k`` references drawn at random."""
        with stage("match"):
            return Match.from_scores(self.scores(image), k)

    def scores(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return the (N,) float32 scores of all references, in [0, 1)."""
        mixed = _mixed(self.marks_ ^ np.uint64(self._mark(image)))
        return np.asarray((mixed >> np.uint64(40)).astype(np.float32) / np.float32(2**24), dtype=np.float32)

    def save(self, folder: Path) -> None:
        """Write the marks as ``marks.npy``."""
        np.save(folder / _FILE, self.marks_, allow_pickle=False)

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote."""
        self.marks_ = np.load(folder / _FILE, allow_pickle=False)
        return self

    def _mark(self, image: NDArray[np.uint8]) -> int:
        content = hashlib.blake2b(f"{self.seed} {image.shape} ".encode(), digest_size=8)
        content.update(np.ascontiguousarray(image).data)
        return int.from_bytes(content.digest(), "little")


def _mixed(values: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """Scatter (n,) uint64 so that every bit depends on all of them (SplitMix64: Steele et al., OOPSLA 2014)."""
    values = (values ^ (values >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    values = (values ^ (values >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return values ^ (values >> np.uint64(31))
