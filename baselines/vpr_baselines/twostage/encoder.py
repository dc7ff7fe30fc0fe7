"""One pass through the trunk, and what is taken from it: a global descriptor and local cells."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.backbones.pooling import PARTS, POOLINGS, Pooling
from vpr_baselines.backbones.trunk import Trunk
from vpr_baselines.spatial.cells import CellEncoder, Cells
from vpr_baselines.twostage.reduction import Reduction
from vpr_bench.progress import track
from vpr_bench.types.traverse import Traverse

_SAMPLE = 512  # references from which the encoder learns; more hardly change means and principal directions


@dataclass(frozen=True)
class Look:
    """What the trunk sees in an image before anything is learnt on the references.

    Parameters
    ----------
    trunk : Trunk
        Whose layers are the middle and the last one.
    pooling : Pooling
        Of the last map.
    """

    trunk: Trunk
    pooling: Pooling

    def both(self, image: NDArray[np.uint8]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Return the (C, h, w) middle map and the (D,) pooled last map of one (H, W, 3) uint8 RGB image."""
        middle, last = self.trunk.respond(image)
        return middle[0], POOLINGS[self.pooling](last)[0]

    def pooled(self, images: Sequence[NDArray[np.uint8]]) -> NDArray[np.float32]:
        """Return the (B, D) pooled last maps of images."""
        last = replace(self.trunk, layers=self.trunk.layers[-1:])
        return POOLINGS[self.pooling](last.encode(images))


@dataclass(frozen=True)
class Encoder:
    """Turns an image into its global descriptor and its cells by one pass through the trunk.

    Parameters
    ----------
    look : Look
        The pass.
    reduction : Reduction
        From the pooled last map to the descriptor.
    cells : CellEncoder
        From the middle map to the cells.
    """

    look: Look
    reduction: Reduction
    cells: CellEncoder

    @classmethod
    def learn(
        cls, look: Look, references: Traverse, dimensions: int, cell_dimensions: int, keep: int, whitening: float
    ) -> Self:
        """Learn means and principal directions from up to 512 references, evenly spread.

        Parameters
        ----------
        look : Look
            The pass.
        references : Traverse
            At least one image.
        dimensions, cell_dimensions, keep, whitening
            Of :meth:`Reduction.learn` and :meth:`CellEncoder.learn`.
        """
        chosen = np.unique(np.linspace(0, len(references) - 1, _SAMPLE).round().astype(int))
        looks = [look.both(references[index]) for index in track(chosen.tolist(), "Learning from references")]
        middles, pooled = (np.stack(part) for part in zip(*looks, strict=True))
        return cls(
            look,
            Reduction.learn(pooled, PARTS[look.pooling], dimensions, whitening),
            CellEncoder.learn(middles, cell_dimensions, keep, whitening),
        )

    def encode(self, image: NDArray[np.uint8]) -> tuple[NDArray[np.float32], Cells]:
        """Describe one (H, W, 3) uint8 RGB image: its (D,) float32 descriptor of unit length, and its cells."""
        middle, pooled = self.look.both(image)
        return self.reduction.apply(pooled), self.cells.encode(middle)

    def describe(self, images: Sequence[NDArray[np.uint8]]) -> NDArray[np.float32]:
        """Describe images globally: (B, D) float32."""
        return self.reduction.apply(self.look.pooled(images))

    def describe_traverse(self, references: Traverse) -> NDArray[np.float32]:
        """Describe every image of a traverse globally: (n, D) float32."""
        return np.concatenate([self.describe([image]) for image in track(references, "Describing references")])

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return what was learnt as named arrays, for :meth:`from_arrays`."""
        parts = {"reduction": self.reduction.arrays(), "cells": self.cells.arrays()}
        return {f"{part}.{name}": array for part, arrays in parts.items() for name, array in arrays.items()}

    @classmethod
    def from_arrays(cls, look: Look, arrays: Mapping[str, NDArray[Any]]) -> Self:
        """Read what :meth:`arrays` returned."""

        def part(prefix: str) -> dict[str, NDArray[Any]]:
            return {name.removeprefix(prefix): array for name, array in arrays.items() if name.startswith(prefix)}

        return cls(look, Reduction.from_arrays(part("reduction.")), CellEncoder.from_arrays(part("cells.")))
