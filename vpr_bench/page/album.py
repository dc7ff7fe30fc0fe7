"""The pictures of a page: each once, and all together no larger than there is room for."""

from base64 import b64encode
from collections.abc import Callable, Hashable
from io import BytesIO
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from vpr_bench.progress import track
from vpr_bench.report.ink import fitted_size

Decode = Callable[[], NDArray[np.uint8] | None]
"""Returns a picture, (H, W, 3) uint8 RGB; None if it is not here."""

# Longest side in pixels, and WebP quality; the last is taken where nothing else fits.
_SIZES = (
    *((480, 74), (448, 72), (416, 70), (384, 69), (352, 68), (320, 67), (288, 65), (256, 63), (224, 61), (192, 59)),
    *((160, 56), (128, 52), (96, 46), (64, 40)),
)
_SAMPLE = 24  # pictures that a size is judged by
_CAUTION = 0.95  # how much of the room the sample may promise to take


class Embedded(NamedTuple):
    """A picture as the page holds it: its size in pixels, and WebP in base64."""

    width: int
    height: int
    content: str


class Album:
    """Pictures that are decoded only when they are put on the page, as large as lets all of them fit."""

    def __init__(self) -> None:
        self._numbers: dict[Hashable, int] = {}
        self._decodes: list[Decode] = []

    def __len__(self) -> int:
        """Return how many different pictures were asked for."""
        return len(self._decodes)

    def add(self, picture: Hashable, decode: Decode) -> int:
        """Ask for a picture; return its number, the same for the same picture."""
        number = self._numbers.setdefault(picture, len(self._decodes))
        if number == len(self._decodes):
            self._decodes.append(decode)
        return number

    def embedded(self, room: int) -> dict[int, Embedded]:
        """Return every picture by its number; those that are not here are left out.

        Parameters
        ----------
        room : int
            Characters that all of them may take. Where not even the smallest size fits, the last ones are left out.
        """
        step = max(1, len(self) // _SAMPLE)
        sample = [pixels for decode in self._decodes[::step] if (pixels := decode()) is not None]
        for size in _SIZES[:-1]:
            expected = len(self) * np.mean([len(_embedded(pixels, *size).content) for pixels in sample] or [0])
            if expected <= _CAUTION * room:
                pictures = self._all(size)
                if sum(len(picture.content) for picture in pictures.values()) <= room:
                    return pictures
        return _fitting(self._all(_SIZES[-1]), room)

    def _all(self, size: tuple[int, int]) -> dict[int, Embedded]:
        decodes = track(self._decodes, "Embedding pictures")
        found = ((number, decode()) for number, decode in enumerate(decodes))
        return {number: _embedded(pixels, *size) for number, pixels in found if pixels is not None}


def _embedded(pixels: NDArray[np.uint8], side: int, quality: int) -> Embedded:
    """Make a picture as small as asked, never larger than it is."""
    picture = Image.fromarray(pixels)
    if max(picture.size) > side:
        picture = picture.resize(fitted_size(*picture.size, (side, side)), Image.Resampling.LANCZOS, reducing_gap=3.0)
    file = BytesIO()
    picture.save(file, format="WEBP", quality=quality, method=4)
    return Embedded(*picture.size, b64encode(file.getvalue()).decode())


def _fitting(pictures: dict[int, Embedded], room: int) -> dict[int, Embedded]:
    """Return the first pictures that fit together."""
    sizes = np.cumsum([len(picture.content) for picture in pictures.values()])
    return dict(list(pictures.items())[: int(np.searchsorted(sizes, room, side="right"))])
