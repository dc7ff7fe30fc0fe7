"""What the ground is made of: one square tile of each material, which repeats."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import blocks, toned
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.texture import Canvas, Colour

TILE = 16.0
"""Side of the square of material that is repeated, in metres.

A tile begins at the middle of the path: what is painted in its uppermost metres lies to the left of the middle,
and what is painted in its lowest metres to the right.
"""

GRASS: dict[Season, Colour] = {
    "spring": (118, 152, 74),
    "summer": (104, 130, 66),
    "autumn": (138, 130, 70),
    "winter": (150, 146, 116),
}
MEADOW: dict[Season, Colour] = {
    "spring": (150, 150, 96),
    "summer": (124, 148, 76),
    "autumn": (168, 150, 84),
    "winter": (164, 152, 120),
}
FIELD: dict[Season, Colour] = {
    "spring": (120, 98, 76),
    "summer": (150, 164, 70),
    "autumn": (200, 172, 96),
    "winter": (132, 112, 92),
}
WOODLAND: dict[Season, Colour] = {
    "spring": (110, 104, 68),
    "summer": (92, 110, 60),
    "autumn": (150, 116, 66),
    "winter": (104, 90, 70),
}
WATER: dict[Season, Colour] = {
    "spring": (104, 122, 134),
    "summer": (78, 116, 150),
    "autumn": (84, 100, 116),
    "winter": (186, 196, 204),
}
SEASONAL = {"grass": GRASS, "meadow": MEADOW, "field": FIELD, "woodland": WOODLAND, "water": WATER, "verge": GRASS}
"""Materials that take their colour from the season."""


def _stones(course: float, length: float, amount: int, joint: int) -> Callable[[Canvas, Dice], None]:
    def lay(canvas: Canvas, dice: Dice) -> None:
        canvas.speckle(dice, 22)
        canvas.speckle(dice, 14, 3.0)
        blocks(canvas, dice, course, length, amount, joint)

    return lay


def _loose(amount: int, cell: float) -> Callable[[Canvas, Dice], None]:
    def strew(canvas: Canvas, dice: Dice) -> None:
        canvas.speckle(dice, amount)
        canvas.speckle(dice, amount, cell)

    return strew


def _fine(canvas: Canvas, dice: Dice) -> None:
    """Set stones too small to be told apart."""
    canvas.speckle(dice, 26)
    canvas.speckle(dice, 8, 2.0)


def _shaded(canvas: Canvas, share: int) -> Colour:
    """Return ``share / 256`` of the colour in a corner of a canvas."""
    red, green, blue = (int(part) for part in canvas.rgb[0, 0])
    return toned((red, green, blue), share)


def _rows(canvas: Canvas, dice: Dice) -> None:
    """Plough or sow in rows along the path."""
    for number in range(16):
        canvas.rect(0, number, TILE, 0.5, _shaded(canvas, 222))
    canvas.speckle(dice, 30)
    canvas.speckle(dice, 24, 2.0)


def _ripples(canvas: Canvas, dice: Dice) -> None:
    canvas.speckle(dice, 16, 0.5)
    canvas.speckle(dice, 12, 4.0)


RAILS = (0.7, TILE - 0.79)
"""Where the heads of the two rails begin, 0.09 m wide, in metres up the tile."""


def _track(canvas: Canvas, dice: Dice) -> None:
    """Lay sleepers and two rails on ballast."""
    canvas.speckle(dice, 30)
    canvas.speckle(dice, 20, 0.5)
    for number in range(26):
        tone = 170 + dice.below(110)
        for low in (0.0, TILE - 1.3):
            canvas.rect(number * TILE / 26, low, 0.27, 1.3, toned((84, 70, 60), tone))
    for rail in RAILS:
        canvas.rect(0, rail - 0.06, TILE, 0.05, (84, 62, 50))
        canvas.rect(0, rail, TILE, 0.09, (176, 178, 184))


def _lanes(canvas: Canvas, dice: Dice) -> None:
    """Paint a dashed line in the middle of a road, and worn tracks of wheels."""
    canvas.speckle(dice, 24, 2.0)
    for wheel in (1.1, 2.6, TILE - 1.5, TILE - 3.0):
        canvas.rect(0, wheel, TILE, 0.4, _shaded(canvas, 236))
    canvas.speckle(dice, 18)
    for start in (0.0, 8.0):
        for low in (0.0, TILE - 0.07):
            canvas.rect(start, low, 3.0, 0.07, (226, 224, 214))


def _footpath(canvas: Canvas, dice: Dice) -> None:
    """Run a concrete footpath through the grass beside a road."""
    canvas.speckle(dice, 46)
    canvas.speckle(dice, 46, 1.2)
    for low in (6.0, TILE - 7.3):
        canvas.rect(0, low, TILE, 1.3, (182, 178, 168))
        for number in range(8):
            canvas.rect(number * 2.0, low, 0.08, 1.3, (140, 136, 128))
    canvas.speckle(dice, 12)


def _nothing(canvas: Canvas, dice: Dice) -> None:
    """Leave a hole: what is below shows."""


def _patched(canvas: Canvas, dice: Dice) -> None:
    """Mend asphalt with darker patches, and let it crack."""
    canvas.speckle(dice, 16, 2.0)
    for _ in range(7):
        share = 200 + dice.below(36)
        area = canvas.area(dice.between(0, 13), dice.between(0, 14), dice.between(0.8, 4.0), dice.between(0.5, 1.6))
        canvas.rgb[area] = (canvas.rgb[area].astype(np.uint16) * np.uint16(share) >> 8).astype(np.uint8)
    for _ in range(9):
        x, y = dice.between(0, TILE), dice.between(0, TILE)
        for _ in range(5):
            left, low = x + dice.between(-0.5, 1.2), y + dice.between(-0.5, 0.5)
            canvas.line(x, y, left, low, 0.05, _shaded(canvas, 190))
            x, y = left, low
    canvas.speckle(dice, 18)


def _dashes(long: float, period: float) -> Callable[[Canvas, Dice], None]:
    def paint(canvas: Canvas, dice: Dice) -> None:
        for number in range(int(TILE / period)):
            canvas.rect(number * period, 0, long, TILE, (226, 226, 220))
        canvas.speckle(dice, 20)

    return paint


MATERIALS: dict[str, tuple[Colour, Callable[[Canvas, Dice], None]]] = {
    "asphalt": ((98, 98, 100), _loose(22, 2.0)),
    "concrete": ((176, 172, 162), _stones(2.0, 2.0, 10, 40)),
    "slabs": ((186, 178, 162), _stones(0.8, 0.8, 26, 44)),
    "large slabs": ((160, 164, 164), _stones(1.2, 2.4, 24, 48)),
    "brick": ((152, 112, 94), _stones(0.25, 0.5, 36, 30)),
    "boards": ((140, 108, 78), _stones(0.25, 20.0, 30, 60)),
    "cobbles": ((128, 124, 118), _stones(0.34, 0.34, 44, 44)),
    "tiles": ((206, 200, 188), _stones(0.6, 0.6, 22, 30)),
    "gravel": ((182, 168, 142), _loose(40, 0.8)),
    "grass": (GRASS["summer"], _loose(46, 1.2)),
    "mulch": ((112, 84, 62), _loose(48, 0.6)),
    "track": ((146, 140, 134), _track),
    "meadow": (MEADOW["summer"], _loose(26, 1.6)),
    "field": (FIELD["summer"], _rows),
    "woodland": (WOODLAND["summer"], _loose(34, 0.9)),
    "water": (WATER["summer"], _ripples),
    "rubble": ((126, 120, 112), _loose(40, 0.7)),
    "road": ((138, 137, 136), _lanes),
    "verge": (GRASS["summer"], _footpath),
    "void": ((0, 0, 0), _nothing),
    "tarmac": ((116, 116, 118), _patched),
    "line": ((226, 226, 220), _loose(20, 0.3)),
    "dash": ((116, 116, 118), _dashes(3.2, 8.0)),
    "short dash": ((116, 116, 118), _dashes(0.5, 1.0)),
    "kerbstone": ((168, 164, 158), _stones(4.0, 1.0, 20, 60)),
    "gutter": ((108, 106, 104), _stones(0.25, 0.25, 22, 26)),
    "mosaic": ((146, 144, 140), _fine),
    "plates": ((174, 170, 163), _stones(1.0, 0.8, 20, 36)),
    "cycle lane": ((142, 92, 84), _loose(18, 1.0)),
    "cycle path": ((152, 116, 106), _fine),
    "soil": ((120, 104, 84), _loose(40, 0.4)),
    "clinker": ((130, 106, 96), _stones(0.17, 0.34, 26, 28)),
    "setts": ((122, 118, 114), _stones(0.25, 0.34, 32, 32)),
    "quay": ((166, 160, 150), _stones(4.0, 1.4, 22, 60)),
}
"""Colour and pattern of every material."""

SHELTER = {"track": 150, "water": 200, "road": 90}
"""How well snow stays, of 255 where it stays best."""


def paint_tiles(seed: int, season: Season, density: float) -> NDArray[np.uint8]:
    """Paint one (T, T, 3) tile of each material; together (M, T, T, 3) uint8."""
    tiles = []
    for name, (colour, pattern) in MATERIALS.items():
        canvas = Canvas(TILE, TILE, density, SEASONAL[name][season] if name in SEASONAL else colour)
        pattern(canvas, Dice(seed, "floor", name))
        tiles.append(canvas.rgb)
    return np.stack(tiles)


def snow_holds(density: float) -> NDArray[np.uint8]:
    """Return how well snow stays on every texel of the tiles; (M, T, T) uint8."""
    size = int(TILE * density)
    holds = np.empty((len(MATERIALS), size, size), dtype=np.uint8)
    for number, name in enumerate(MATERIALS):
        holds[number] = SHELTER.get(name, 255)
    rails = holds[list(MATERIALS).index("track")]
    for rail in RAILS:
        rails[int(rail * density) : int((rail + 0.09) * density) + 1] = 0
    return holds
