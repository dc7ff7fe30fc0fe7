"""Describing all references: each original and its augmentations, once."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.matrices import product
from vpr_baselines.photometry import resized
from vpr_baselines.spatial.cells import Cells, to_bytes
from vpr_baselines.twostage.augment import augmented
from vpr_baselines.twostage.encoder import Encoder
from vpr_baselines.twostage.reranking import LocalMap
from vpr_bench.checkpoint import kept
from vpr_bench.progress import task
from vpr_bench.types.traverse import Traverse

_BLOCK = 128  # references that are kept together


@dataclass(frozen=True, eq=False)
class Description:
    """What is kept of the references' images.

    Attributes
    ----------
    descriptors : (n, V, D) float16
        Of every reference's V variants, the first of which is the original; of unit length. Memory-mapped when read
        from disk.
    local : LocalMap
        The cells of the originals.
    """

    descriptors: NDArray[np.float16]
    local: LocalMap

    def __len__(self) -> int:
        """Return the number of references."""
        return len(self.descriptors)

    @property
    def originals(self) -> NDArray[np.float32]:
        """(n, D) float32: the descriptors of the references themselves."""
        return self.descriptors[:, 0].astype(np.float32)

    def cosines(self, descriptor: NDArray[np.float32], candidates: NDArray[np.int64]) -> NDArray[np.float32]:
        """Compare a query's (D,) descriptor with those of (K,) candidates: (K,) float32."""
        return product(self.descriptors[candidates, 0].astype(np.float32), descriptor)

    def followed_by(self, others: "Description") -> "Description":
        """Return both, one behind the other."""
        return Description(
            np.concatenate([self.descriptors, others.descriptors]),
            LocalMap(
                np.concatenate([self.local.vectors, others.local.vectors]),
                np.concatenate([self.local.positions, others.local.positions]),
                self.local.shape,
            ),
        )

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return everything as named arrays, one entry per reference in each, for :meth:`from_arrays`."""
        return {"descriptors": self.descriptors, "cells": self.local.vectors, "positions": self.local.positions}

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]], shape: tuple[int, int]) -> Self:
        """Read what :meth:`arrays` returned; ``shape`` is that of the feature maps."""
        return cls(arrays["descriptors"], LocalMap(arrays["cells"], arrays["positions"], shape))


def describe_references(references: Traverse, encoder: Encoder, seed: int) -> Description:
    """Describe references and their augmentations; an interrupted fit goes on after the last 128.

    Raises
    ------
    DataError
        If an image cannot be decoded.
    """
    blocks = []
    with task("Describing references, augmented five-fold", len(references)) as advance:
        for first in range(0, len(references), _BLOCK):
            rows = range(first, min(first + _BLOCK, len(references)))

            def block(rows: range = rows) -> dict[str, NDArray[Any]]:
                described = []
                for row in rows:
                    described.append(_describe(references[row], encoder, seed, row))
                    advance(1)
                descriptors, cells = zip(*described, strict=True)
                return {
                    "descriptors": np.stack(descriptors),
                    "cells": np.stack([to_bytes(one.vectors) for one in cells]),
                    "positions": np.stack([one.positions for one in cells]).astype(np.uint16),
                }

            blocks.append(kept(f"references from {first}", block))
    joined = {name: np.concatenate([one[name] for one in blocks]) for name in blocks[0]}
    return Description.from_arrays(joined, encoder.cells.shape)


def _describe(image: NDArray[np.uint8], encoder: Encoder, seed: int, index: int) -> tuple[NDArray[np.float16], Cells]:
    """Return the (V, D) descriptors of one reference's variants, and the cells of the original."""
    descriptor, cells = encoder.encode(image)
    # Augmenting at the trunk's own size costs a fifth of it and shows the trunk the same.
    small = resized(image, encoder.look.trunk.width, encoder.look.trunk.height)
    others = encoder.describe(augmented(small, seed, index))
    return np.concatenate([descriptor[None], others]).astype(np.float16), cells
