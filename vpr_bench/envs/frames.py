"""Query images as observations of one shape.

Methods are shown images as they are, and so are agents: an image is never resized unless that is asked for. Where
a dataset mixes sizes, each image stands in the upper left corner of a frame that is large enough for all of them.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.envs.sizes import image_sizes
from vpr_bench.errors import DataError, UsageError
from vpr_bench.types.traverse import Traverse


class Frames:
    """The images of a traverse, each written into a frame of one shape.

    Parameters
    ----------
    traverse : Traverse
        The images.
    in_memory : bool
        Keep what has been decoded.

    Attributes
    ----------
    sizes : (n, 2) int64
        Height and width of each image.
    shape : (height, width, 3)
        Of the frames.

    Raises
    ------
    DataError
        If there are no images, or one cannot be read.

    Examples
    --------
    >>> tall, wide = np.ones((4, 2, 3), np.uint8), np.ones((3, 5, 3), np.uint8)
    >>> frames = Frames(Traverse("walk", [tall, wide]))
    >>> frames.shape, frames[0].sum(axis=2)[:, 1:3].tolist()
    ((4, 5, 3), [[3, 0], [3, 0], [3, 0], [3, 0]])
    """

    def __init__(self, traverse: Traverse, *, in_memory: bool = False) -> None:
        if not len(traverse):
            raise DataError(f"{traverse.name} has no images.")
        self._traverse = traverse
        self._kept: dict[int, NDArray[np.uint8]] | None = {} if in_memory else None
        self.sizes = image_sizes(traverse)
        height, width = self.sizes.max(axis=0).tolist()
        self.shape = (int(height), int(width), 3)
        self._alike = bool((self.sizes == self.sizes[0]).all())

    def __getitem__(self, index: int) -> NDArray[np.uint8]:
        """Return one frame, (height, width, 3) uint8; always a new array."""
        image = self._image(index)
        if self._alike:
            return image.copy() if self._kept is not None else image
        frame = np.zeros(self.shape, dtype=np.uint8)
        frame[: image.shape[0], : image.shape[1]] = image
        return frame

    def batch(self, indices: NDArray[np.int64], rows: int) -> NDArray[np.uint8]:
        """Return (rows, height, width, 3) uint8 frames: those of ``indices`` first, then black ones."""
        whole = self._alike and len(indices) == rows  # nothing to be blackened first, which takes as long as copying
        frames = np.empty((rows, *self.shape), np.uint8) if whole else np.zeros((rows, *self.shape), np.uint8)
        for row, index in enumerate(indices.tolist()):
            image = self._image(index)
            frames[row, : image.shape[0], : image.shape[1]] = image
        return frames

    def _image(self, index: int) -> NDArray[np.uint8]:
        """Decode an image, or take the one that is kept, which must not be changed."""
        if self._kept is not None and index in self._kept:
            return self._kept[index]
        image = self._traverse[index]
        if image.shape[:2] != tuple(self.sizes[index].tolist()):
            height, width = self.sizes[index].tolist()
            raise DataError(
                f"{self._traverse.name_of(index)} is {image.shape[1]} × {image.shape[0]} pixels, and not "
                f"{width} × {height} as its header says. Give the environment a size=(height, width)."
            )
        if self._kept is not None:
            self._kept[index] = image
        return image


def resized(traverse: Traverse, size: Sequence[int]) -> Traverse:
    """Return a traverse whose images are stretched to ``(height, width)`` when they are decoded.

    Raises
    ------
    UsageError
        If these are not two positive whole numbers.

    Examples
    --------
    >>> walk = Traverse("walk", [np.zeros((40, 60, 3), np.uint8)])
    >>> resized(walk, (20, 30))[0].shape
    (20, 30, 3)
    """
    try:
        height, width = (int(side) for side in size)
        whole = [height, width] == list(size) and min(height, width) >= 1
    except (TypeError, ValueError):
        whole = False
    if not whole:
        raise UsageError(f"size must be (height, width) in pixels. Got {size!r} instead.")
    convert = _Stretched(height, width, traverse.convert)
    return Traverse.join([Traverse(part.name, part.sources, convert) for part in traverse.split()])


class _Stretched:
    """Does what else is done to an image after decoding, and then changes its size."""

    def __init__(self, height: int, width: int, before: Any) -> None:
        self.size = (height, width)
        self._before = before

    def __call__(self, image: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Return (height, width, 3) uint8, averaged over the pixels that become one."""
        from PIL import Image

        image = image if self._before is None else self._before(image)
        if image.shape[:2] == self.size:
            return image
        return np.array(Image.fromarray(image).resize(self.size[::-1], Image.Resampling.BILINEAR))
