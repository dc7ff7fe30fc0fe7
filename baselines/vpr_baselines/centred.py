"""The base of descriptors from which what all references have in common may be taken away."""

from abc import abstractmethod
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.indexes import build_index
from vpr_baselines.retrieval import Retrieval, normalised
from vpr_bench.progress import track
from vpr_bench.types.traverse import Traverse


class Centred(Retrieval):
    """Subtract the mean of the references' descriptors from every descriptor, if ``centre`` is set.

    A subclass is a dataclass with :meth:`respond` and a field ``centre``. The mean is the map's own: a map of one
    reference is centred to nothing, and everything is equally like it.
    """

    centre: bool

    @abstractmethod
    def respond(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into a (D,) float32 descriptor, not centred."""

    def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Turn one (H, W, 3) uint8 RGB image into a (D,) float32 descriptor, as the references were."""
        return self.respond(image) - self.mean_

    def fit(self, references: Traverse) -> None:
        """Describe every reference.

        Raises
        ------
        DataError
            If an image cannot be decoded, or the weights are missing or damaged.
        """
        for row, image in enumerate(track(references, "Describing references")):
            response = self.respond(image)
            if row == 0:  # filled row by row, and changed in place: the map may be large
                database = np.empty((len(references), len(response)), dtype=np.float32)
            database[row] = response
        # In double precision the mean does not depend on the order of the references.
        mean = database.mean(axis=0, dtype=np.float64) if self.centre else np.zeros(database.shape[1])
        self.mean_: NDArray[np.float32] = mean.astype(np.float32)
        for one in database:
            one -= self.mean_
            if self.metric == "cosine":
                one[:] = normalised(one)
        self.index_ = build_index(self.index, self.metric, database)

    def save(self, folder: Path) -> None:
        """Write the index, and ``mean.npy``."""
        super().save(folder)
        np.save(folder / "mean.npy", self.mean_, allow_pickle=False)

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote."""
        super().load(folder)
        self.mean_ = np.load(folder / "mean.npy", allow_pickle=False)
        return self
