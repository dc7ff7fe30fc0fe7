"""How large images are, without decoding them."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError, one_line
from vpr_bench.types.image import FORMATS
from vpr_bench.types.traverse import Traverse

_ORIENTATION = 0x0112
_SIDEWAYS = range(5, 9)
"""Values of the EXIF orientation that turn a picture on its side."""


def image_sizes(traverse: Traverse) -> NDArray[np.int64]:
    """Return height and width of each image as it is decoded, (n, 2) int64.

    What is done to images after decoding may change their size; it is tried on one image of each size.

    Raises
    ------
    DataError
        If a file is missing or is not an image.

    Examples
    --------
    >>> image_sizes(Traverse("walk", [np.zeros((4, 6, 3), np.uint8)])).tolist()
    [[4, 6]]
    """
    size = getattr(traverse.convert, "size", None)
    if size is not None:
        return np.tile(np.array(size, dtype=np.int64), (len(traverse), 1))
    stored = [source.shape[:2] if isinstance(source, np.ndarray) else _header(source) for source in traverse.sources]
    if traverse.convert is None:
        return np.array(stored, dtype=np.int64).reshape(-1, 2)
    first = {size: index for index, size in reversed(list(enumerate(stored)))}
    after = {size: traverse[index].shape[:2] for size, index in first.items()}
    return np.array([after[size] for size in stored], dtype=np.int64).reshape(-1, 2)


def _header(file: Path) -> tuple[int, int]:
    """Read height and width of an image file."""
    from PIL import Image, ImageOps

    try:
        with Image.open(file, formats=FORMATS) as image:
            width, height = image.size
            # A PNG may have its EXIF behind its pixels: looking there would mean to decode them.
            known = image.format != "PNG" or "exif" in image.info
            sideways = known and image.getexif().get(_ORIENTATION) in _SIDEWAYS
            if sideways and image.format == "TIFF":  # of which some versions of Pillow have turned the size already
                (width, height), sideways = ImageOps.exif_transpose(image).size, False
    except Exception as error:  # whatever a damaged file makes one of Pillow's parsers raise
        raise DataError(f"{file} cannot be read as an image: {one_line(error)}.") from None
    return (width, height) if sideways else (height, width)
