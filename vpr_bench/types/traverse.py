"""An ordered sequence of images of one drive or walk, decoded when they are asked for."""

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from vpr_bench.types.image import decode_image

ImageSource = Path | NDArray[np.uint8]


class Traverse(Sequence[NDArray[np.uint8]]):
    """A sequence of (H, W, 3) uint8 RGB images that is held as paths and decoded lazily.

    It carries no place labels: what a method is given cannot leak the ground truth.

    Parameters
    ----------
    name : str
        What the drive is called, for example ``day_left``.
    sources : sequence of Path or (H, W, 3) uint8
        Files, or images already in memory.
    convert : callable, optional
        Applied to each decoded image, for cameras whose files need it (Bayer patterns).

    Examples
    --------
    >>> walk = Traverse("walk", [np.zeros((4, 6, 3), np.uint8)] * 3)
    >>> len(walk), walk[1].shape, len(walk[1:])
    (3, (4, 6, 3), 2)
    """

    def __init__(
        self,
        name: str,
        sources: Sequence[ImageSource],
        convert: Callable[[NDArray[np.uint8]], NDArray[np.uint8]] | None = None,
    ) -> None:
        self.name = name
        self.sources = tuple(sources)
        self.convert = convert
        self._parts: tuple[tuple[str, int], ...] = ((name, len(self.sources)),)

    def __len__(self) -> int:
        """Return the number of images."""
        return len(self.sources)

    @overload
    def __getitem__(self, index: int) -> NDArray[np.uint8]: ...
    @overload
    def __getitem__(self, index: slice) -> "Traverse": ...
    def __getitem__(self, index: int | slice) -> "NDArray[np.uint8] | Traverse":
        """Decode one image, or take a part of the sequence without decoding it.

        Raises
        ------
        DataError
            If the file is missing or is not an image.
        """
        if isinstance(index, slice):
            return Traverse(self.name, self.sources[index], self.convert)
        source = self.sources[index]
        image = decode_image(source) if isinstance(source, Path) else _checked(source)
        return image if self.convert is None else self.convert(image)

    def __iter__(self) -> Iterator[NDArray[np.uint8]]:
        """Decode the images one after the other."""
        return (self[index] for index in range(len(self)))

    def subset(self, indices: ArrayLike) -> "Traverse":
        """Take the images at ``indices``, in that order, without decoding them."""
        return Traverse(self.name, [self.sources[index] for index in np.asarray(indices)], self.convert)

    @classmethod
    def join(cls, parts: Sequence["Traverse"]) -> "Traverse":
        """Put traverses one behind the other, as one map; :meth:`split` takes them apart again.

        Raises
        ------
        ValueError
            If there is none, or their images need different conversions.

        Examples
        --------
        >>> image = np.zeros((4, 6, 3), np.uint8)
        >>> joined = Traverse.join([Traverse("summer", [image] * 2), Traverse("winter", [image])])
        >>> joined, joined.split()
        (Traverse('summer+winter', 3 images), [Traverse('summer', 2 images), Traverse('winter', 1 images)])
        """
        pieces = [piece for part in parts for piece in part.split()]
        if not pieces or any(piece.convert != pieces[0].convert for piece in pieces):
            raise ValueError("traverses can be joined if there are some and all are converted alike")
        name = "+".join(piece.name for piece in pieces)
        joined = cls(name, [source for piece in pieces for source in piece.sources], pieces[0].convert)
        joined._parts = tuple((piece.name, len(piece)) for piece in pieces)
        return joined

    def split(self) -> "list[Traverse]":
        """Return the traverses that were joined; one that was not is returned alone."""
        starts = np.cumsum([0, *(length for _, length in self._parts)]).tolist()
        return [
            Traverse(name, self.sources[start : start + length], self.convert)
            for (name, length), start in zip(self._parts, starts, strict=False)
        ]

    def name_of(self, index: int) -> str:
        """Return what to call image ``index`` in messages: its file name, else the traverse and number."""
        source = self.sources[index]
        return f"{self.name}/{source.name}" if isinstance(source, Path) else f"{self.name}[{index}]"

    def __repr__(self) -> str:
        """Name the traverse and its length."""
        return f"Traverse({self.name!r}, {len(self)} images)"


def _checked(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] != 3:
        raise ValueError(f"an image must be (H, W, 3) uint8. Got {image.shape} {image.dtype} instead.")
    return image.copy()
