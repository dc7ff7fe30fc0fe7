"""The ground, painted from above."""

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.floors import MATERIALS, TILE, paint_tiles, snow_holds
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.path import GRID, Course
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.stage import Band, Floor, Slab
from vpr_datasets.simulation.texture import SURFACE, bake

LAND_DENSITY = 1.6
"""Texels per metre of the land beyond the ground."""


PIECE = 4096
"""How many columns of the ground are painted at a time."""

SPREAD, STRIP = 48.0, 0.05
"""How far bands may lie to either side of the path, and the width to which they are rounded, in metres."""


def paint_grounds(seed: int, season: Season, course: Course, floors: list[Floor], setting: Setting) -> list[Slab]:
    """Paint the ground along the whole course, and the land beyond it where the setting has any."""
    snow = setting.snow.get(season, 0.0)
    grounds = [_paint(seed, season, course, floors, setting.density, setting.margin, 0.0, setting, snow)]
    if setting.land:
        # A little lower, so that it is hidden wherever the ground is.
        grounds.append(_paint(seed, season, course, floors, LAND_DENSITY, setting.land, -0.05, setting, snow))
    return grounds


def _paint(
    seed: int,
    season: Season,
    course: Course,
    floors: list[Floor],
    density: float,
    margin: float,
    level: float,
    setting: Setting,
    snow: float,
) -> Slab:
    """Paint one level slab that reaches ``margin`` metres to either side."""
    names = list(MATERIALS)
    knots = len(course.y)
    middle, left, right = (np.zeros(knots, dtype=np.int64) for _ in range(3))
    half = np.full(knots, 2.0)
    for floor in floors:
        part = slice(*np.searchsorted(course.arc, (floor.start, floor.stop)).tolist())
        middle[part], left[part], right[part] = (names.index(name) for name in (floor.middle, floor.left, floor.right))
        half[part] = floor.half
    low, high = float(course.y.min()) - margin, float(course.y.max()) + margin
    length, width = (knots - 1) * GRID, high - low
    columns, rows = int(length * density), int(width * density)
    y = low + (np.arange(rows)[:, None] + 0.5) / density
    tiles = paint_tiles(seed, season, density)
    size = np.int64(tiles.shape[1])
    section, strips = _sections(course, floors)
    holds = snow_holds(density).reshape(-1) if snow else None
    rgb = np.empty((rows, columns, 3), dtype=np.uint8)
    ink = np.full((rows, columns), SURFACE, dtype=np.uint8)
    sheltered = np.empty((rows, columns), dtype=np.uint8)
    # Piece by piece: a long path would fill the memory with coordinates.
    for start in range(0, columns, PIECE):
        part = slice(start, min(start + PIECE, columns))
        x = (np.arange(part.start, part.stop) + 0.5) / density
        index = (x / GRID).astype(np.int64)
        slope = course.slope[index]
        norm = np.sqrt(1.0 + slope * slope)
        base = course.y[index] + slope * (x - (index + 0.5) * GRID)
        aside = (y - base) / norm
        # The foot of the perpendicular lies further along by the slope times the distance from the path.
        ahead = x + aside * slope / norm
        foot = np.minimum(np.maximum((ahead / GRID).astype(np.int64), 0), knots - 1)
        reach = half[foot]
        along = ((course.arc[foot] + (ahead - foot * GRID) * norm + 64.0) * density).astype(np.int64)
        kind = np.where(aside > 0, left[foot], right[foot])
        inside = np.abs(aside) < reach
        kind = np.where(inside, middle[foot], kind)
        if len(strips) > 1:
            strip = strips[section[foot], np.clip((aside + SPREAD) / STRIP, 0, strips.shape[1] - 1).astype(np.int64)]
            kind = np.where(strip >= 0, strip, kind)
            ink[:, part][kind == names.index("void")] = 0
        place = (kind * size + ((aside + 32 * TILE) * density).astype(np.int64) % size) * size + along % size
        rgb[:, part] = tiles.reshape(-1, 3)[place]
        if setting.kerb is not None:
            kerb = np.abs(np.abs(aside) - reach) < 0.1
            rgb[:, part][kerb] = setting.kerb
        if holds is not None:
            sheltered[:, part] = holds[place]
    blot = max(int(density * 16 / 3), 2)
    worn = value_noise(Dice(seed, "worn"), rows, columns, blot, 4)
    rgb -= (np.minimum(rgb, 60) * (worn[..., None] >> 4) >> 4).astype(np.uint8)
    if snow:
        _cover(rgb, worn, sheltered, snow)
    return Slab((course.start, low), (1.0, 0.0), columns / density, rows / density, level, bake(rgb, ink))


def _sections(course: Course, floors: list[Floor]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Tabulate the bands of the floors.

    Returns
    -------
    section : (knots,) int64
        Which cross-section the path has.
    strips : (sections, strips) int64
        The material of every strip of each, from right to left; -1 where it has no band. The first has none.
    """
    names = list(MATERIALS)
    section = np.zeros(len(course.y), dtype=np.int64)
    strips = [np.full(round(2 * SPREAD / STRIP), -1, dtype=np.int64)]
    known: dict[tuple[Band, ...], int] = {(): 0}
    for floor in floors:
        if floor.bands not in known:
            known[floor.bands] = len(strips)
            strips.append(strips[0].copy())
            for band in floor.bands:
                first, last = (round((edge + SPREAD) / STRIP) for edge in (band.right, band.left))
                strips[-1][max(first, 0) : max(last, 0)] = names.index(band.material)
        part = slice(*np.searchsorted(course.arc, (floor.start, floor.stop)).tolist())
        section[part] = known[floor.bands]
    return section, np.stack(strips)


def _cover(rgb: NDArray[np.uint8], noise: NDArray[np.uint8], holds: NDArray[np.uint8], snow: float) -> None:
    """Lay snow on what is painted: it stays longest where the noise is high, and where it is sheltered."""
    depth = (np.multiply(noise, holds, dtype=np.uint16) >> 8).astype(np.int16) - np.int16(182 - 140 * snow)
    share = (np.minimum(np.maximum(depth, 0), 19) * np.int16(12)).astype(np.uint16)
    rest = np.uint16(256) - share
    for channel, white in enumerate((218, 222, 228)):
        bright = share * (white + (noise >> 3)).astype(np.uint16)
        rgb[..., channel] = (rgb[..., channel] * rest + bright) >> 8
