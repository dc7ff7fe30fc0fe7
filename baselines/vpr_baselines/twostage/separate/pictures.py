"""What a whole network is trained on: variants of references, made when they are asked for."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from vpr_baselines.photometry import resized
from vpr_baselines.twostage.augment import variant_of
from vpr_baselines.twostage.separate.body import Body
from vpr_bench.types.traverse import Traverse

_BATCH = 32  # thesis, ch. 3


@dataclass(frozen=True, eq=False)
class Pictures:
    """Variants of references, made when they are asked for, with their classes.

    Attributes
    ----------
    references : Traverse
    chosen : (n, 2) int64
        Reference and number of the variant.
    labels : (n,) int64
        Class of each.
    seed : int
        Of the augmentations.
    """

    references: Traverse
    chosen: NDArray[np.int64]
    labels: NDArray[np.int64]
    seed: int

    def __len__(self) -> int:
        """Return the number of pictures."""
        return len(self.labels)

    def batches(self, body: Body, order: NDArray[np.int64]) -> Iterator[tuple[Tensor, Tensor]]:
        """Yield (b, 3, height, width) inputs and their (b,) classes, 32 at a time."""
        for first in range(0, len(order), _BATCH):
            part = order[first : first + _BATCH]
            inputs = [
                body.trunk.input(self._picture(body, index, number)) for index, number in self.chosen[part].tolist()
            ]
            yield torch.cat(inputs), torch.from_numpy(self.labels[part])

    def _picture(self, body: Body, index: int, number: int) -> NDArray[np.uint8]:
        image = self.references[index]
        if number:  # augmented at the network's own size, as for the frozen trunk
            image = variant_of(resized(image, body.trunk.width, body.trunk.height), self.seed, index, number)
        return image
