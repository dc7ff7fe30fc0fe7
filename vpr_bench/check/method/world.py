"""A small made-up world: textures that tell their places, in memory."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from vpr_bench.types.traverse import Traverse

Image = NDArray[np.uint8]

WIDTH, HEIGHT = 128, 96
PLACES = 6
"""Size of the usual map; networks take their time."""

ANSWERS = 4
"""How many references are usually asked for."""

_BLOCK, _SHIFT, _NOISE = 16, 3, 4.0


def picture(place: int, *, again: bool = False, width: int = WIDTH, height: int = HEIGHT) -> Image:
    """Return a picture of a place: (height, width, 3) uint8, the same each time.

    Parameters
    ----------
    place : int
        Other places look entirely different.
    again : bool
        As it is seen on another day: from a little further to the right, darker, and with noise.
    width, height : int
        In pixels.
    """
    from PIL import Image as Pillow

    rows, columns = height // _BLOCK + 2, width // _BLOCK + 2
    blocks = np.random.default_rng(place).integers(0, 256, (rows, columns, 3), dtype=np.uint8)
    large = Pillow.fromarray(blocks).resize((width + _SHIFT, height), Pillow.Resampling.BICUBIC)
    texture = np.asarray(large)[:, _SHIFT if again else 0 :][:, :width].astype(np.float64)
    if again:
        texture = 0.85 * texture + np.random.default_rng([place, 1]).normal(0, _NOISE, texture.shape)
    return texture.clip(0, 255).astype(np.uint8)


def as_map(images: Iterable[Image]) -> Traverse:
    """Return images as references."""
    return Traverse("made-up map", list(images))


def usual_map() -> Traverse:
    """Return a map of the places from 0."""
    return as_map(picture(place) for place in range(PLACES))


def usual_queries() -> list[Image]:
    """Return every place of the usual map as it is seen again, in the order of the map."""
    return revisited(range(PLACES))


def revisited(places: Sequence[int]) -> list[Image]:
    """Return places as they are seen again."""
    return [picture(place, again=True) for place in places]
