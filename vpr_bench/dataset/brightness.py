"""How bright the images of a traverse are, to find tunnels and covered lenses."""

import hashlib

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.content import traverse_digest
from vpr_bench.dataset.folders import cache_root
from vpr_bench.errors import DataError
from vpr_bench.files.atomic import read_arrays, write_arrays
from vpr_bench.progress import track
from vpr_bench.types.traverse import Traverse


def brightness(traverse: Traverse) -> NDArray[np.float32]:
    """Return the mean of each image's pixels, (n,) float32 in [0, 255]; decoded once and remembered by content.

    Raises
    ------
    DataError
        If an image cannot be decoded.
    """
    names = " ".join(traverse.name_of(index) for index in range(len(traverse)))
    key = hashlib.sha256(f"{traverse_digest(traverse)} {names}".encode()).hexdigest()[:24]
    file = cache_root() / "brightness" / f"{key}.npz"
    if file.exists():
        try:
            return read_arrays(file, "means")["means"].astype(np.float32)
        except DataError:
            file.unlink(missing_ok=True)  # a cache may be deleted at any time, and so may a damaged one
    means = [image.mean(dtype=np.float64) for image in track(traverse, f"Looking for dark frames in {traverse.name}")]
    column = np.array(means, dtype=np.float32)
    file.parent.mkdir(parents=True, exist_ok=True)
    write_arrays(file, {"means": column})
    return column
