"""The ground: what it is made of, painted from above."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import blocks
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.path import GRID, Course
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.stage import Floor, Slab
from vpr_datasets.simulation.texture import SURFACE, Canvas, Colour, bake

DENSITY = 12.0
"""Texels per metre."""

TILE = 16.0
"""Side of the square of material that is repeated, in metres."""

MARGIN = 30.0
"""How far the painted ground reaches to either side of the path, in metres."""

GRASS: dict[Season, Colour] = {
    "spring": (118, 152, 74),
    "summer": (104, 130, 66),
    "autumn": (138, 130, 70),
    "winter": (150, 146, 116),
}


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
    "grass": ((104, 130, 66), _loose(46, 1.2)),
    "mulch": ((112, 84, 62), _loose(48, 0.6)),
}
"""Colour and pattern of every material; grass takes its colour from the season."""


def _tiles(seed: int, season: Season) -> NDArray[np.uint8]:
    """Paint one (T, T, 3) tile of each material; together (M, T, T, 3) uint8."""
    tiles = []
    for name, (colour, pattern) in MATERIALS.items():
        canvas = Canvas(TILE, TILE, DENSITY, GRASS[season] if name == "grass" else colour)
        pattern(canvas, Dice(seed, "floor", name))
        tiles.append(canvas.rgb)
    return np.stack(tiles)


def paint_ground(seed: int, season: Season, course: Course, floors: list[Floor]) -> Slab:
    """Paint the ground along the whole course as one slab at level 0."""
    names = list(MATERIALS)
    knots = len(course.y)
    middle, left, right = (np.zeros(knots, dtype=np.int64) for _ in range(3))
    half = np.full(knots, 2.0)
    for floor in floors:
        part = slice(*np.searchsorted(course.arc, (floor.start, floor.stop)).tolist())
        middle[part], left[part], right[part] = (names.index(name) for name in (floor.middle, floor.left, floor.right))
        half[part] = floor.half
    low, high = float(course.y.min()) - MARGIN, float(course.y.max()) + MARGIN
    length, width = (knots - 1) * GRID, high - low
    columns, rows = int(length * DENSITY), int(width * DENSITY)
    x = (np.arange(columns) + 0.5) / DENSITY
    y = low + (np.arange(rows)[:, None] + 0.5) / DENSITY
    index = (x / GRID).astype(np.int64)
    slope = course.slope[index]
    norm = np.sqrt(1.0 + slope * slope)
    base = course.y[index] + slope * (x - (index + 0.5) * GRID)
    aside = (y - base) / norm
    # The foot of the perpendicular lies further along by the slope times the distance from the path.
    ahead = x + aside * slope / norm
    foot = np.minimum(np.maximum((ahead / GRID).astype(np.int64), 0), knots - 1)
    reach = half[foot]
    size = np.int64(TILE * DENSITY)
    along = ((course.arc[foot] + (ahead - foot * GRID) * norm + 64.0) * DENSITY).astype(np.int64)
    kind = np.where(aside > 0, left[foot], right[foot])
    inside = np.abs(aside) < reach
    kind = np.where(inside, middle[foot], kind)
    place = (kind * size + ((aside + 512.0) * DENSITY).astype(np.int64) % size) * size + along % size
    rgb = _tiles(seed, season).reshape(-1, 3)[place.reshape(-1)].reshape(rows, columns, 3)
    kerb = np.abs(np.abs(aside) - reach) < 0.1
    rgb[kerb] = (172, 168, 160)
    worn = value_noise(Dice(seed, "worn"), rows, columns, 64, 4)
    rgb -= (np.minimum(rgb, 60) * (worn[..., None] >> 4) >> 4).astype(np.uint8)
    ink = np.full((rows, columns), SURFACE, dtype=np.uint8)
    return Slab((course.start, low), (1.0, 0.0), columns / DENSITY, rows / DENSITY, 0.0, bake(rgb, ink))
