"""What references can be clustered by."""

from collections.abc import Callable
from functools import cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.hog import Hog
from vpr_bench.progress import track
from vpr_bench.types.traverse import Traverse

ClusterBy = Literal["hog", "hog:thesis", "sift", "alexnet"]
"""HOG of 224 × 224 pixels in cells of 8, and the descriptors of the thesis's chapter 2: HOG of 64 × 128 pixels, SIFT
of 128 key points, the response of AlexNet's conv3."""

Describer = Callable[[NDArray[np.uint8]], NDArray[np.float32]]
"""Turns one (H, W, 3) uint8 RGB image into a (D,) float32 descriptor."""


@cache
def describer(name: ClusterBy) -> Describer:
    """Return what describes one image; AlexNet's weights are looked for when the first image is."""
    if name == "hog":
        return Hog(width=224, height=224, cell=8).describe
    if name == "hog:thesis":
        return Hog(**Hog.presets["thesis"]).describe
    if name == "sift":
        from vpr_baselines.sift.descriptor import StackedSift

        return StackedSift(size=480, n_features=128).describe
    from vpr_baselines.alexnet import AlexNet

    return AlexNet().respond


def describe_references(name: ClusterBy, references: Traverse) -> NDArray[np.float32]:
    """Describe every reference: (n, D) float32.

    Raises
    ------
    DataError
        If an image cannot be decoded, or weights are missing or damaged; says how to get them.
    """
    describe = describer(name)
    for row, image in enumerate(track(references, f"Describing references by {name}")):
        descriptor = describe(image)
        if row == 0:  # filled row by row: a list and an array of a large map would be two large maps
            descriptors = np.empty((len(references), len(descriptor)), dtype=np.float32)
        descriptors[row] = descriptor
    return descriptors if len(references) else np.empty((0, 0), dtype=np.float32)
