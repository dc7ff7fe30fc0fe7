"""Where light falls: a coarse grid over the scene in several layers of height.

By day the sun casts shadows; after dark lamps light pools around them. A value is the square root of the
light, 255 being full sun by day and the foot of a lamp by night.
"""

from dataclasses import dataclass
from math import floor

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.noise import box_sum
from vpr_datasets.simulation.path import GRID, Course, Point
from vpr_datasets.simulation.spec import Light
from vpr_datasets.simulation.stage import Lamp, Shade

CELL = 0.5
"""Side of a cell in metres."""

LAYERS = 8
LAYER = 1.5
"""Number and height in metres of the layers; the uppermost one reaches to the sky."""

MARGIN = 36.0
"""How far the grid reaches to either side of the path, in metres."""

SUN: Point = (0.55, -0.75)
"""Metres by which a shadow shifts for every metre of height, unless a traverse says otherwise."""

AMBIENT = {"day": 126, "overcast": 206, "dusk": 112, "night": 13}
COVERED = {"day": 84, "overcast": 128, "dusk": 70, "night": 8}
"""Light where no sun and no lamp reaches: in the open, and below a roof."""

SUNLIT = 228

DIM = 172
"""Light under a grey sky at the foot of what keeps half of the sky away."""


@dataclass(frozen=True)
class Grid:
    """Light in every cell; ``cells`` is (LAYERS, rows, columns) uint8, its corner at (x, y)."""

    x: float
    y: float
    cells: NDArray[np.uint8]


def light_grid(light: Light, course: Course, shades: list[Shade], lamps: list[Lamp], sun: Point = SUN) -> Grid:
    """Work out the light in a scene; ``sun`` says how far shadows shift for every metre of height."""
    x, y = course.start, float(course.y.min()) - MARGIN
    columns = floor(len(course.y) * GRID / CELL) + 1
    rows = floor((float(course.y.max()) + MARGIN - y) / CELL) + 1
    base = SUNLIT if light == "day" else AMBIENT[light]
    cells = np.full((LAYERS, rows, columns), base, dtype=np.uint8)
    if light == "day":
        _cast_shadows(cells, (x, y), [shade for shade in shades if not shade.roof], sun, AMBIENT["day"])
    if light == "overcast":
        _cast_shadows(cells, (x, y), [shade for shade in shades if not shade.roof], (0.0, 0.0), DIM)
    _cover(cells, (x, y), [shade for shade in shades if shade.roof], light)
    for layer in range(LAYERS):
        # The sun is not a point, nor are lamps: shadows have soft edges.
        cells[layer] = box_sum(cells[layer], 1) // 9
    if light in ("dusk", "night"):
        np.maximum(cells, _pools(cells.shape, (x, y), lamps), out=cells)
    return Grid(x, y, cells)


def _outline(points: list[Point], origin: Point) -> NDArray[np.int32]:
    """Return the convex hull of points in cells."""
    cells = [(floor((x - origin[0]) / CELL), floor((y - origin[1]) / CELL)) for x, y in points]
    return np.asarray(cv2.convexHull(np.array(cells, dtype=np.int32)))


def _cast_shadows(cells: NDArray[np.uint8], origin: Point, shades: list[Shade], sun: Point, value: int) -> None:
    for layer in range(LAYERS):
        level = (layer + 0.5) * LAYER
        for shade in shades:
            if shade.high > level:
                lifts = max(shade.low - level, 0.0), shade.high - level
                points = [(x + sun[0] * lift, y + sun[1] * lift) for lift in lifts for x, y in shade.outline]
                cv2.fillConvexPoly(cells[layer], _outline(points, origin), [value])


def _cover(cells: NDArray[np.uint8], origin: Point, shades: list[Shade], light: Light) -> None:
    for layer in range(LAYERS):
        for shade in shades:
            if shade.low > layer * LAYER:
                cv2.fillConvexPoly(cells[layer], _outline(list(shade.outline), origin), [COVERED[light]])


def _pools(shape: tuple[int, ...], origin: Point, lamps: list[Lamp]) -> NDArray[np.uint8]:
    """Add up the light of all lamps, which falls off with the square of the distance."""
    total = np.zeros(shape)
    reach = 40
    levels = (np.arange(LAYERS)[:, None, None] + 0.5) * LAYER
    for lamp in lamps:
        column = floor((lamp.place[0] - origin[0]) / CELL)
        row = floor((lamp.place[1] - origin[1]) / CELL)
        rows = np.arange(max(row - reach, 0), min(row + reach, shape[1]))
        columns = np.arange(max(column - reach, 0), min(column + reach, shape[2]))
        if not len(rows) or not len(columns):
            continue
        x = (columns[None, None, :] + 0.5) * CELL + origin[0] - lamp.place[0]
        y = (rows[None, :, None] + 0.5) * CELL + origin[1] - lamp.place[1]
        z = levels - lamp.height
        light = lamp.power / (1.0 + (x * x + y * y + z * z) / 7.0)
        total[:, rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1] += light
    return np.minimum(np.sqrt(total) * 255.0, 255.0).astype(np.uint8)
