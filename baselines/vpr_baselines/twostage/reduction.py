"""From a pooled map to a short descriptor: centred, and projected onto what tells the references apart."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.matrices import product
from vpr_baselines.retrieval import normalised

_FLATTEST = 1e-4  # of the largest variance; below it a direction is noise


@dataclass(frozen=True, eq=False)
class Reduction:
    """Takes away what all references have in common, and keeps of every part of the map the same principal directions.

    Attributes
    ----------
    mean : (P · C,) float32
        Of the references' pooled maps; P parts of C channels.
    projection : (C, d) float32
        From the channels of one part to its share of the descriptor.
    """

    mean: NDArray[np.float32]
    projection: NDArray[np.float32]

    @classmethod
    def learn(cls, pooled: NDArray[np.float32], parts: int, dimensions: int, whitening: float) -> Self:
        """Learn from pooled maps of references.

        Parameters
        ----------
        pooled : (n, P · C) float32
            Part by part.
        parts : int
            P.
        dimensions : int
            d, at most C.
        whitening : float
            Directions are divided by their deviation to this power: 0 leaves them, 1 makes all of them equally long.
        """
        mean = pooled.mean(axis=0, dtype=np.float64).astype(np.float32)
        channels = pooled.shape[1] // parts
        rows = (pooled - mean).reshape(-1, channels).astype(np.float64)
        variances, axes = np.linalg.eigh(rows.T @ rows / len(rows))
        strongest = slice(None, -min(dimensions, channels) - 1, -1)
        largest = variances[-1] if variances[-1] > 0 else 1.0  # identical images have none
        lengths = np.maximum(variances[strongest] / largest, _FLATTEST) ** (whitening / 2)
        return cls(mean, np.ascontiguousarray(axes[:, strongest] / lengths, dtype=np.float32))

    def apply(self, pooled: NDArray[np.float32]) -> NDArray[np.float32]:
        """Turn (…, P · C) float32 pooled maps into (…, P · d) float32 descriptors of unit length."""
        parts = (pooled - self.mean).reshape(*pooled.shape[:-1], -1, len(self.projection))
        return normalised(product(parts, self.projection).reshape(*pooled.shape[:-1], -1))

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return everything as named arrays, for :meth:`from_arrays`."""
        return {"mean": self.mean, "projection": self.projection}

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> Self:
        """Read what :meth:`arrays` returned."""
        return cls(arrays["mean"], arrays["projection"])
