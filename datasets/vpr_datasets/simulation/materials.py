"""What walls and floors are made of: patterns that fill a canvas."""

from collections.abc import Callable

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.texture import Canvas, Colour

BRICK: tuple[Colour, ...] = ((158, 92, 70), (142, 82, 66), (176, 128, 96), (122, 84, 74), (190, 156, 128))
PLASTER: tuple[Colour, ...] = (
    (214, 206, 188), (226, 214, 176), (188, 196, 200), (206, 176, 150), (160, 180, 172), (222, 222, 216),
)  # fmt: skip
CONCRETE: tuple[Colour, ...] = ((158, 156, 150), (178, 174, 164), (136, 138, 140), (192, 186, 172))
WOOD: tuple[Colour, ...] = ((150, 102, 66), (128, 88, 62), (172, 128, 84), (112, 84, 66))
METAL: tuple[Colour, ...] = ((120, 134, 144), (92, 100, 108), (158, 164, 168), (84, 108, 122))
TILE: tuple[Colour, ...] = ((196, 198, 196), (150, 168, 172), (180, 160, 136), (124, 128, 132))


def blocks(canvas: Canvas, dice: Dice, course: float, length: float, amount: int, joint: int) -> None:
    """Lay staggered blocks (metres): each a little lighter or darker, with joints ``joint`` darker."""
    height, width = canvas.ink.shape
    tall = max(int(course * canvas.density), 2)
    long = max(int(length * canvas.density), 3)
    row = np.arange(height) // tall
    column = np.arange(width)[None] + (row % 2 * (long // 2))[:, None]
    tone = dice.bytes(height // tall + 1, width // long + 2).astype(np.int16) - 128
    change = tone[row[:, None], column // long] * np.int16(amount) >> 7
    if joint:
        edge = (np.arange(height) % tall == 0)[:, None] | (column % long == 0)
        change = change - edge.astype(np.int16) * np.int16(joint)
    canvas.tint(change.astype(np.int16))


def brick(canvas: Canvas, dice: Dice) -> None:
    """Lay bricks, about three courses to the foot-high block when seen from afar."""
    blocks(canvas, dice, 0.12, 0.36, 15, -12)
    canvas.speckle(dice, 14, 1.5)


def concrete(canvas: Canvas, dice: Dice) -> None:
    """Cast panels with joints, stains and the holes of the formwork."""
    canvas.speckle(dice, 26, dice.between(0.8, 2.5))
    panel = dice.between(1.2, 3.0)
    blocks(canvas, dice, dice.pick((1.2, 1.8, 3.4)), panel, 10, 30)


def plaster(canvas: Canvas, dice: Dice) -> None:
    """Paint smoothly, with weather marks that run down from the top."""
    canvas.speckle(dice, 12, 2.0)
    height, width = canvas.ink.shape
    streaks = dice.bytes(width).astype(np.int16) >> 4
    fade = (np.arange(height, 0, -1) * 256 // height).astype(np.int16)
    canvas.tint(-(streaks[None] * fade[:, None] >> 8).astype(np.int16))


def wood(canvas: Canvas, dice: Dice) -> None:
    """Clad with upright boards."""
    blocks(canvas, dice, canvas.height + 1.0, dice.pick((0.14, 0.2, 0.3)), 34, 36)
    canvas.speckle(dice, 12)


def metal(canvas: Canvas, dice: Dice) -> None:
    """Clad with corrugated sheets, upright or lying."""
    height, width = canvas.ink.shape
    period = max(int(dice.pick((0.2, 0.35, 0.5)) * canvas.density), 3)
    length = width if dice.chance(0.5) else height
    wave = np.abs((np.arange(length) % period) * 2 - period).astype(np.int16) * np.int16(48) // period - 24
    canvas.tint(np.broadcast_to(wave if length == width else wave[:height, None], (height, width)).copy())
    canvas.speckle(dice, 10, 2.0)


def tile(canvas: Canvas, dice: Dice) -> None:
    """Cover with square slabs."""
    size = dice.pick((0.5, 0.8, 1.1))
    blocks(canvas, dice, size, size * dice.pick((1.0, 2.0)), 18, 34)


WALLS: tuple[tuple[Callable[[Canvas, Dice], None], tuple[Colour, ...]], ...] = (
    (brick, BRICK),
    (concrete, CONCRETE),
    (plaster, PLASTER),
    (wood, WOOD),
    (metal, METAL),
    (tile, TILE),
    (brick, BRICK),
    (plaster, PLASTER),
)
"""Materials of walls with the colours in which they come; what is listed twice is twice as common."""


def tinted(dice: Dice, colour: Colour, amount: int) -> Colour:
    """Return a colour near ``colour``."""
    red, green, blue = (min(max(part + dice.below(2 * amount + 1) - amount, 0), 255) for part in colour)
    return red, green, blue


def toned(colour: Colour, share: int) -> Colour:
    """Return ``share / 256`` of a colour; more than 256 makes it lighter."""
    red, green, blue = (min(part * share >> 8, 255) for part in colour)
    return red, green, blue
