"""The cells of a feature map as local descriptors: standardised, projected, and the distinctive ones kept."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.matrices import product
from vpr_baselines.retrieval import normalised

_SMALLEST = 1e-6  # a deviation or variance below it is none
_STEPS = 127  # of a signed byte, either way


@dataclass(frozen=True, eq=False)
class Cells:
    """Local descriptors of one image.

    Attributes
    ----------
    vectors : (m, d) float32
        Unit length.
    positions : (m,) int64
        Cell ``row · columns + column`` of each in the feature map, ascending.
    """

    vectors: NDArray[np.float32]
    positions: NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class CellEncoder:
    """Turns feature maps into cells, in a way learnt on the references.

    Every channel is standardised by its mean and deviation over the references: what all places have in common, and
    the channels that always shout, do not count. Of an image only the cells farthest from that mean are kept, which
    leaves out sky, road and walls; they are projected onto the references' principal directions.

    Attributes
    ----------
    mean, deviation : (C,) float32
        Of each channel.
    projection : (C, d) float32
        From standardised channels to descriptors.
    keep : int
        Cells kept per image; all if it has fewer.
    shape : (int, int)
        Rows and columns of the feature maps.
    """

    mean: NDArray[np.float32]
    deviation: NDArray[np.float32]
    projection: NDArray[np.float32]
    keep: int
    shape: tuple[int, int]

    @classmethod
    def learn(cls, maps: NDArray[np.float32], dimensions: int, keep: int, whitening: float) -> Self:
        """Learn from feature maps of references.

        Parameters
        ----------
        maps : (n, C, h, w) float32
            Of some references.
        dimensions : int
            Of the descriptors, at most C.
        keep : int
            Cells kept per image.
        whitening : float
            Principal directions are divided by their deviation to this power: 0 leaves them, 1 makes all of them
            equally long.
        """
        channels = maps.shape[1]
        cells = np.moveaxis(maps, 1, -1).reshape(-1, channels)
        mean, deviation = cells.mean(axis=0), np.maximum(cells.std(axis=0), _SMALLEST)
        directions = normalised((cells - mean) / deviation).astype(np.float64)
        variances, axes = np.linalg.eigh(directions.T @ directions / len(directions))
        strongest = slice(None, -min(dimensions, channels) - 1, -1)
        lengths = np.maximum(variances[strongest], _SMALLEST) ** (whitening / 2)
        projection = np.ascontiguousarray(axes[:, strongest] / lengths, dtype=np.float32)
        height, width = maps.shape[2:]
        return cls(mean.astype(np.float32), deviation.astype(np.float32), projection, keep, (height, width))

    def encode(self, map_: NDArray[np.float32]) -> Cells:
        """Turn one (C, h, w) float32 feature map into its cells."""
        cells = (map_.reshape(len(map_), -1).T - self.mean) / self.deviation
        positions = np.arange(len(cells))
        if len(cells) > self.keep:
            distances = np.einsum("md,md->m", cells, cells)
            positions = np.sort(np.argpartition(-distances, self.keep - 1)[: self.keep])
        return Cells(normalised(product(normalised(cells[positions]), self.projection)), positions)

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return everything as named arrays, for :meth:`from_arrays`."""
        return {
            "mean": self.mean,
            "deviation": self.deviation,
            "projection": self.projection,
            "keep": np.array([self.keep]),
            "shape": np.array(self.shape),
        }

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> Self:
        """Read what :meth:`arrays` returned."""
        (keep,), (height, width) = arrays["keep"].tolist(), arrays["shape"].tolist()
        return cls(arrays["mean"], arrays["deviation"], arrays["projection"], keep, (height, width))


def to_bytes(vectors: NDArray[np.float32]) -> NDArray[np.int8]:
    """Round components in [-1, 1] to 1/127, a quarter of the memory; :func:`from_bytes` is the way back."""
    return np.rint(vectors * _STEPS).astype(np.int8)


def from_bytes(vectors: NDArray[np.int8]) -> NDArray[np.float32]:
    """Return what :func:`to_bytes` rounded."""
    return vectors * np.float32(1 / _STEPS)
