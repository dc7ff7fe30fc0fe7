"""Decoding image files: whatever lies on disk becomes (H, W, 3) uint8 RGB, or a clear error.

Pillow rather than OpenCV reads the files: OpenCV returns a half-grey picture for a truncated JPEG without a
word, and has read the whole header's worth of memory before a size can be checked.
"""

import io
import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError

FORMATS = ("JPEG", "PNG", "WEBP", "TIFF", "BMP", "PPM")
"""Formats that are read. Others, SVG and GIF among them, are refused whatever the file is called."""

SUFFIXES = frozenset({".jpg", ".jpeg", ".png", ".webp", ".tif", ".tiff", ".bmp", ".ppm", ".pgm"})
"""File name endings by which a folder's images are told from its other files (lower case)."""

MAX_PIXELS = 120_000_000
"""Largest width × height that is decoded; a header that promises more is taken for an image bomb."""


def decode_image(source: Path | bytes, name: str | None = None) -> NDArray[np.uint8]:
    """Decode one image file.

    Grey, palette, transparent, CMYK and 16-bit files are converted to 8-bit RGB (16 bits by their high byte);
    an EXIF orientation is applied, so that the picture is upright.

    Parameters
    ----------
    source : Path or bytes
        The file, or its content.
    name : str, optional
        What to call it in errors; by default its path.

    Returns
    -------
    (H, W, 3) uint8
        RGB, contiguous, a new array each time.

    Raises
    ------
    DataError
        If the file is missing, empty, truncated, of no known format, or larger than ``MAX_PIXELS``.
    """
    from PIL import Image, ImageOps, UnidentifiedImageError

    called = name or (os.fspath(source) if isinstance(source, Path) else "image")
    content = source if isinstance(source, bytes) else _read(source)
    if not content:
        raise DataError(f"{called} is empty (0 bytes). Restore it, or fetch the dataset again.")
    try:
        with Image.open(io.BytesIO(content), formats=FORMATS) as image:
            _check_size(called, *image.size)
            return _to_rgb(ImageOps.exif_transpose(image))
    except UnidentifiedImageError:
        raise DataError(f"{called} is not an image (known formats: {', '.join(FORMATS)}).") from None
    except Image.DecompressionBombError as error:
        raise DataError(f"{called} is refused as an image bomb: {error}") from None
    except DataError:
        raise
    except Exception as error:  # whatever a damaged file makes one of Pillow's parsers raise
        raise DataError(f"{called} cannot be decoded: {error}. Restore it, or fetch the dataset again.") from None


def _read(path: Path) -> bytes:
    if path.exists() and not path.is_file():
        raise DataError(f"{path} is not a file.")
    try:
        return path.read_bytes()
    except OSError as error:
        raise DataError(f"{path} cannot be read: {error.strerror}.") from None


def _check_size(called: str, width: int, height: int) -> None:
    if width * height > MAX_PIXELS:
        raise DataError(
            f"{called} claims {width} × {height} pixels, more than the {MAX_PIXELS:,} that are decoded: "
            "refused as an image bomb."
        )


def _to_rgb(image: "Image.Image") -> NDArray[np.uint8]:  # type: ignore[name-defined] # noqa: F821
    if image.mode.startswith("I;16") or image.mode == "I":
        grey = np.clip(np.asarray(image).astype(np.int64) >> 8, 0, 255).astype(np.uint8)
        return np.ascontiguousarray(np.repeat(grey[:, :, None], 3, axis=2))
    if image.mode == "F":
        raise ValueError("floating-point pixels have no agreed range")
    return np.array(image.convert("RGB"), dtype=np.uint8)
