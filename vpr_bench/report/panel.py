"""A framed picture with a title above it and two lines below."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from vpr_bench.report.ink import GREY, INK, PALE, cut, fitted, font

FRAME = 4
"""Pixels around the picture."""

_TITLE, _LINE = 24, 19


@dataclass(frozen=True)
class Panel:
    """A picture, or a space for one.

    Attributes
    ----------
    title : str
        Above it.
    colour : str
        Of the title and the frame.
    pixels : (H, W, 3) uint8, optional
        RGB; None for an empty space.
    empty : str
        What stands in an empty space.
    lines : (str, str)
        Below it; they are cut to its width.
    """

    title: str
    colour: str
    pixels: NDArray[np.uint8] | None
    empty: str = ""
    lines: tuple[str, str] = ("", "")


def panel_size(box: tuple[int, int]) -> tuple[int, int]:
    """Return the width and height of a panel whose picture has the room ``box``, in pixels."""
    return box[0] + 2 * FRAME, _TITLE + box[1] + 2 * FRAME + 2 * _LINE


def draw_panel(canvas: Image.Image, panel: Panel, corner: tuple[int, int], box: tuple[int, int]) -> None:
    """Draw a panel.

    Parameters
    ----------
    canvas : Image
        To draw on.
    panel : Panel
        What to draw.
    corner : (left, top)
        Of the panel, in pixels.
    box : (width, height)
        Room for the picture itself.
    """
    pen, (left, top), (width, height) = ImageDraw.Draw(canvas), corner, box
    middle = left + FRAME + width // 2
    face = font(15, bold=True)
    pen.text((left, top), cut(panel.title, width, face), panel.colour, face)
    top += _TITLE
    bottom = top + height + 2 * FRAME
    pen.rectangle((left, top, left + width + 2 * FRAME - 1, bottom - 1), panel.colour)
    pen.rectangle((left + FRAME, top + FRAME, left + FRAME + width - 1, bottom - FRAME - 1), PALE)
    if panel.pixels is None:
        pen.text((middle, (top + bottom) // 2), panel.empty, GREY, font(15), "mm")
    else:
        picture = fitted(panel.pixels, box)
        canvas.paste(picture, (middle - picture.width // 2, (top + bottom - picture.height) // 2))
    for number, (line, colour) in enumerate(zip(panel.lines, (INK, GREY), strict=True)):
        if line:
            pen.text((middle, bottom + 4 + number * _LINE), cut(line, width, font(13)), colour, font(13), "ma")
