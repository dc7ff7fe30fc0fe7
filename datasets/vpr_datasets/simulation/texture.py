"""Textures: packed texels with smaller copies for the distance, and the canvas on which they are painted.

A texel is one uint32: red, green, blue, and an *ink* byte which is 0 where the texture is transparent,
1 where it is an ordinary surface, 2 to 254 where it glows by itself after dark, and 255 for the sky.
Colours are square roots of light: multiplying two of them is then multiplying the light they stand for.
"""

from dataclasses import dataclass
from math import floor

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.noise import value_noise

Pixels = NDArray[np.uint8]
Colour = tuple[int, int, int]

LEVELS = 7
"""Greatest number of copies of a texture, each half as large as the one before."""

SURFACE = 1
SKY = 255


@dataclass(frozen=True)
class Texture:
    """Texels of all levels in one array, row by row, the finest level first.

    Attributes
    ----------
    texels : (N,) uint32
    offsets, widths, heights : (LEVELS,) int64
        Where each level starts, and its size; the coarsest one is repeated.
    solid
        Whether no texel is transparent.
    """

    texels: NDArray[np.uint32]
    offsets: NDArray[np.int64]
    widths: NDArray[np.int64]
    heights: NDArray[np.int64]
    solid: bool


def bake(rgb: Pixels, ink: Pixels) -> Texture:
    """Pack (H, W, 3) uint8 colours and (H, W) uint8 ink into a texture with its smaller copies."""
    solid = bool(ink.all())
    levels: list[NDArray[np.uint32]] = []
    offsets, widths, heights = [], [], []
    start = 0
    for _ in range(LEVELS):
        height, width = ink.shape
        packed = np.empty((height, width, 4), dtype=np.uint8)
        packed[..., :3] = rgb
        packed[..., 3] = ink
        levels.append(packed.view("<u4").reshape(-1).astype(np.uint32, copy=False))
        offsets.append(start)
        widths.append(width)
        heights.append(height)
        start += height * width
        if min(height, width) >= 2:
            rgb, ink = _halve(rgb, ink, solid)
            continue
        missing = LEVELS - len(levels)
        offsets += offsets[-1:] * missing
        widths += widths[-1:] * missing
        heights += heights[-1:] * missing
        break
    return Texture(np.concatenate(levels), np.array(offsets), np.array(widths), np.array(heights), solid)


def _halve(rgb: Pixels, ink: Pixels, solid: bool) -> tuple[Pixels, Pixels]:
    """Average 2 x 2 texels; transparent ones do not bleed their colour into the others."""
    height, width = ink.shape[0] // 2 * 2, ink.shape[1] // 2 * 2
    corners = [(slice(row, height, 2), slice(column, width, 2)) for row in (0, 1) for column in (0, 1)]
    if solid:
        colours, inks = [rgb[corner] for corner in corners], [ink[corner] for corner in corners]
        return (_total(colours) + np.uint16(2) >> 2).astype(np.uint8), (_total(inks) >> 2).astype(np.uint8)
    opaque = [(ink[corner] > 0).astype(np.uint8) for corner in corners]
    count = _total(opaque)
    some = np.maximum(count, np.uint16(1))
    colours = [rgb[corner] * mask[..., None] for corner, mask in zip(corners, opaque, strict=True)]
    colour = _total(colours) // some[..., None]
    glow = _total([ink[corner] for corner in corners]) // some
    # Two covered texels of four cover the copy: twigs and railings keep their weight in the distance.
    return colour.astype(np.uint8), np.where(count >= 2, np.maximum(glow, 1), 0).astype(np.uint8)


def _total(parts: list[Pixels]) -> NDArray[np.uint16]:
    """Add up four arrays of uint8."""
    total = parts[0].astype(np.uint16)
    for part in parts[1:]:
        total += part
    return total


class Canvas:
    """A surface to paint on, measured in metres from its lower left corner.

    Parameters
    ----------
    width, height
        Size in metres.
    density
        Texels per metre.
    colour
        What it is covered with; transparent when left out.
    """

    def __init__(self, width: float, height: float, density: float, colour: Colour | None = None) -> None:
        self.density = density
        self.width, self.height = width, height
        shape = max(floor(height * density + 0.5), 2), max(floor(width * density + 0.5), 2)
        self.rgb: Pixels = np.zeros((*shape, 3), dtype=np.uint8)
        self.ink: Pixels = np.zeros(shape, dtype=np.uint8)
        if colour is not None:
            self.rgb[:] = colour
            self.ink[:] = SURFACE

    def _column(self, x: float) -> int:
        return min(max(floor(x * self.density + 0.5), -9999), 9999)

    def _row(self, y: float) -> int:
        return int(self.ink.shape[0]) - min(max(floor(y * self.density + 0.5), -9999), 9999)

    def area(self, x: float, y: float, width: float, height: float) -> tuple[slice, slice]:
        """Return the rows and columns of a rectangle given by its lower left corner, cut to the canvas."""
        top, bottom = self._row(y + height), self._row(y)
        left, right = self._column(x), self._column(x + width)
        return slice(max(top, 0), max(bottom, 0)), slice(max(left, 0), max(right, 0))

    def rect(self, x: float, y: float, width: float, height: float, colour: Colour, ink: int = SURFACE) -> None:
        """Fill a rectangle given by its lower left corner."""
        area = self.area(x, y, width, height)
        self.rgb[area] = colour
        self.ink[area] = ink

    def frame(self, x: float, y: float, width: float, height: float, bar: float, colour: Colour) -> None:
        """Draw the four bars around a rectangle, inside it."""
        self.rect(x, y, width, bar, colour)
        self.rect(x, y + height - bar, width, bar, colour)
        self.rect(x, y, bar, height, colour)
        self.rect(x + width - bar, y, bar, height, colour)

    def clear(self, x: float, y: float, width: float, height: float) -> None:
        """Cut a rectangle out."""
        self.ink[self.area(x, y, width, height)] = 0

    def disc(self, x: float, y: float, radius: float, colour: Colour, ink: int = SURFACE) -> None:
        """Fill a circle."""
        centre, size = (self._column(x), self._row(y)), max(floor(radius * self.density + 0.5), 1)
        cv2.circle(self.rgb, centre, size, colour, -1)
        cv2.circle(self.ink, centre, size, [ink], -1)

    def ring(self, x: float, y: float, radius: float, thick: float, colour: Colour) -> None:
        """Draw a circle of a line ``thick`` metres wide."""
        centre, size = (self._column(x), self._row(y)), max(floor(radius * self.density + 0.5), 1)
        line = max(floor(thick * self.density + 0.5), 1)
        cv2.circle(self.rgb, centre, size, colour, line)
        cv2.circle(self.ink, centre, size, [SURFACE], line)

    def polygon(self, points: list[tuple[float, float]], colour: Colour) -> None:
        """Fill a polygon."""
        corners = np.array([(self._column(x), self._row(y)) for x, y in points], dtype=np.int32)
        cv2.fillPoly(self.rgb, [corners], colour)
        cv2.fillPoly(self.ink, [corners], [SURFACE])

    def line(self, x0: float, y0: float, x1: float, y1: float, thick: float, colour: Colour) -> None:
        """Draw a line ``thick`` metres wide."""
        ends = (self._column(x0), self._row(y0)), (self._column(x1), self._row(y1))
        line = max(floor(thick * self.density + 0.5), 1)
        cv2.line(self.rgb, *ends, colour, line)
        cv2.line(self.ink, *ends, [SURFACE], line)

    def text(self, x: float, y: float, height: float, words: str, colour: Colour) -> None:
        """Write capitals ``height`` metres tall, from the lower left corner of the first."""
        (length, _), _ = cv2.getTextSize(words, cv2.FONT_HERSHEY_SIMPLEX, 1.0, 3)
        plate = np.zeros((25, length + 4), dtype=np.uint8)
        cv2.putText(plate, words, (2, 23), cv2.FONT_HERSHEY_SIMPLEX, 1.0, [255], 3, cv2.LINE_8)
        rows = max(floor(height * self.density + 0.5), 3)
        columns = max(plate.shape[1] * rows // 25, 1)
        plate = np.asarray(cv2.resize(plate, (columns, rows), interpolation=cv2.INTER_NEAREST))
        top, left = max(self._row(y) - rows, 0), max(self._column(x), 0)
        window = self.rgb[top : top + rows, left : left + columns]
        window[plate[: window.shape[0], : window.shape[1]] > 0] = colour

    def speckle(self, dice: Dice, amount: int, cell: float = 0.0) -> None:
        """Make all colours lighter and darker by up to ``amount``, in blots of ``cell`` metres."""
        height, width = self.ink.shape
        size = max(floor(cell * self.density), 1)
        noise = value_noise(dice, height, width, size, 3) if size > 1 else dice.bytes(height, width)
        self.tint((noise.astype(np.int16) - 128) * np.int16(amount) >> 7)

    def tint(self, change: NDArray[np.int16]) -> None:
        """Add an (H, W) int16 change to all three channels."""
        self.rgb = np.clip(self.rgb.astype(np.int16) + change[..., None], 0, 255).astype(np.uint8)

    def bake(self, shade: int = 256) -> Texture:
        """Turn the painting into a texture, its colours multiplied by ``shade / 256``."""
        rgb = self.rgb.astype(np.uint32)
        # Paint in the open is never as pure as on the palette.
        grey = (rgb[..., 0] * 77 + rgb[..., 1] * 150 + rgb[..., 2] * 29) >> 8
        muted = (rgb * 11 + grey[..., None] * 5) * np.uint32(shade) >> 12
        return bake(np.minimum(muted, 255).astype(np.uint8), self.ink)
