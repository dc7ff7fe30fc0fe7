"""Pictures and words at an exact size: what a sheet of pictures is put together from."""

from collections.abc import Sequence
from functools import cache
from math import ceil
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageFont

from vpr_bench.report.foreign import shortened

# Told apart by the colour-blind too (Okabe and Ito).
INK, GREY, PALE, PAPER = "#1b1f24", "#6b7280", "#f3f4f6", "#ffffff"
BLUE, GREEN, AMBER, RED = "#0072b2", "#009e73", "#e69f00", "#d55e00"


@cache
def font(size: int, bold: bool = False) -> ImageFont.FreeTypeFont:
    """Return the font that matplotlib brings, so that pictures look alike on every machine."""
    from matplotlib import get_data_path

    file = Path(get_data_path()) / "fonts" / "ttf" / f"DejaVuSans{'-Bold' if bold else ''}.ttf"
    # The basic engine: another one, where it is installed, would space letters differently.
    return ImageFont.truetype(file, size, layout_engine=ImageFont.Layout.BASIC)


def cut(text: str, width: float, face: ImageFont.FreeTypeFont) -> str:
    """Shorten foreign text in the middle until it is at most ``width`` pixels wide.

    Examples
    --------
    >>> cut("a_very_long_name_indeed_00001.jpg", 120, font(12))
    'a_very_l…0001.jpg'
    """
    # One mark is at least a pixel wide, or is a mark that is set on top of another one.
    text = shortened(text, 4096)
    if face.getlength(text) <= width:
        return text
    low, high = 0, len(text)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if face.getlength(shortened(text, middle + 1)) <= width else (low, middle)
    return shortened(text, low + 1)


def fitted_size(width: int, height: int, box: tuple[int, int]) -> tuple[int, int]:
    """Return the size at which a picture just fits into a box, its shape kept.

    Examples
    --------
    >>> fitted_size(1920, 1080, (200, 200)), fitted_size(64, 32, (200, 200)), fitted_size(100, 400, (200, 200))
    ((200, 112), (200, 100), (50, 200))
    """
    scale = min(box[0] / width, box[1] / height)
    return max(1, round(width * scale)), max(1, round(height * scale))


def fitted(pixels: NDArray[np.uint8], box: tuple[int, int]) -> Image.Image:
    """Make a picture fit into a box; what is enlarged shows its pixels as sharp squares."""
    picture = Image.fromarray(pixels)
    size = fitted_size(*picture.size, box)
    if size[0] <= picture.width:
        return picture.resize(size, Image.Resampling.LANCZOS, reducing_gap=3.0)
    times = ceil(size[0] / picture.width)
    whole = picture.resize((picture.width * times, picture.height * times), Image.Resampling.NEAREST)
    return whole.resize(size, Image.Resampling.BOX)


def stacked(parts: Sequence[Image.Image], width: int, margin: int, gap: int) -> Image.Image:
    """Put pictures below each other on a sheet of paper, ``gap`` pixels apart."""
    tops = [margin + sum(part.height + gap for part in parts[:number]) for number in range(len(parts) + 1)]
    sheet = Image.new("RGB", (width, tops[-1] - gap + margin), PAPER)
    for part, top in zip(parts, tops, strict=False):
        sheet.paste(part, (margin, top))
    return sheet
