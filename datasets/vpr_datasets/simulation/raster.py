"""Drawing walls, slabs and the sky into an image with a depth for every pixel.

A wall's depth is the same in all rows of a column, and so is the scale of its texture: all divisions
are done per column, and only a multiplication, a look-up and a comparison are left for each pixel.
"""

from dataclasses import dataclass
from math import ceil, floor

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.stage import Slab, Walls
from vpr_datasets.simulation.texture import LEVELS, Texture
from vpr_datasets.simulation.view import View

NEAR = 0.25
"""Nothing nearer to the camera than this is drawn, in metres."""

FAR = 1e4
"""Depth of the sky, in metres."""

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]


@dataclass(frozen=True)
class Buffers:
    """An image under construction.

    Attributes
    ----------
    colour : (H, W) uint32
        Texels, see :mod:`vpr_datasets.simulation.texture`.
    depth : (H, W) float32
        Metres along the direction of sight.
    jitter : (2, H, W) float32
        Offsets in [-0.5, 0.5) texels across and down. Where a texture is magnified they dissolve the edges
        of its texels, which the slight blur of the lens then turns into a smooth transition.
    """

    colour: NDArray[np.uint32]
    depth: Singles
    jitter: Singles

    @classmethod
    def empty(cls, jitter: Singles) -> "Buffers":
        """Return an image with nothing in it, of the size of ``jitter``."""
        shape = jitter.shape[1:]
        return cls(np.zeros(shape, dtype=np.uint32), np.full(shape, FAR, dtype=np.float32), jitter)


def jitter_pattern(height: int, width: int) -> Singles:
    """Return the offsets for :class:`Buffers`: neighbouring pixels get values that are far apart.

    Roberts' R2 sequence, laid out in the plane: any small window holds evenly spread values, so that a
    slight blur averages them out, which it would not do with random ones.
    """
    rows, columns = np.arange(height)[:, None] + 0.5, np.arange(width) + 0.5
    pattern = np.stack(
        [0.7548776662466927 * columns + 0.5698402909980532 * rows,
         0.5698402909980532 * columns - 0.7548776662466927 * rows]
    )  # fmt: skip
    return np.asarray(pattern - np.floor(pattern) - 0.5, dtype=np.float32)


_STEPS = np.array([1.4 * (1 << step) for step in range(LEVELS - 1)])


def _levels(density: Floats) -> NDArray[np.int64]:
    """Return which level of a texture to use where there are ``density`` texels of it to a pixel."""
    return np.asarray(_STEPS.searchsorted(density), dtype=np.int64)


def draw_walls(buffers: Buffers, view: View, walls: Walls, reach: float, least: float = 3.5) -> None:
    """Draw the walls within ``reach`` metres, but those that would be less than ``least`` pixels wide or tall."""
    ahead, side = view.forward
    x, y = walls.x0 - view.x, walls.y0 - view.y
    across0, deep0 = x * side - y * ahead, x * ahead + y * side
    x, y = walls.x1 - view.x, walls.y1 - view.y
    across1, deep1 = x * side - y * ahead, x * ahead + y * side
    across1 = np.where(walls.turns, across0 + walls.x1, across1)
    deep1 = np.where(walls.turns, deep0, deep1)
    across0 = np.where(walls.turns, across0 - walls.x1, across0)
    nearest, farthest = np.minimum(deep0, deep1), np.maximum(deep0, deep1)
    edge = view.width / 2 / view.focal
    seen = (farthest > NEAR) & (nearest < reach)
    seen &= ~((across0 > edge * deep0) & (across1 > edge * deep1))
    seen &= ~((across0 < -edge * deep0) & (across1 < -edge * deep1))
    # The front is seen where the camera lies on the right-hand side of the way from left to right.
    seen &= ~(walls.one_sided & (across0 * deep1 >= across1 * deep0))
    near = np.maximum(nearest, NEAR)
    seen &= (walls.high - walls.low) * view.focal > least * near
    seen &= (np.abs(across1 - across0) + np.abs(deep1 - deep0)) * view.focal > least * near
    visible = np.flatnonzero(seen)
    # From near to far: what is hidden is found out before any of its texels is looked up.
    for number in visible[np.argsort(nearest[visible], kind="stable")]:
        _draw_wall(
            buffers,
            view,
            walls.textures[number],
            (float(across0[number]), float(deep0[number])),
            (float(across1[number]), float(deep1[number])),
            float(walls.low[number]),
            float(walls.high[number]),
        )


def _screen(view: View, left: tuple[float, float], right: tuple[float, float]) -> tuple[int, int]:
    """Return the first and last column of a wall, cut at the near plane."""
    columns = []
    for (across, deep), (other, behind) in ((left, right), (right, left)):
        if deep < NEAR:
            share = (NEAR - deep) / (behind - deep)
            across, deep = across + (other - across) * share, NEAR
        place = min(max(view.width / 2 + view.focal * across / deep, -1.0), view.width + 1.0)
        columns.append(place)
    return max(ceil(min(columns) - 0.5), 0), min(ceil(max(columns) - 0.5), view.width)


def _draw_wall(
    buffers: Buffers,
    view: View,
    texture: Texture,
    left: tuple[float, float],
    right: tuple[float, float],
    low: float,
    high: float,
) -> None:
    first, last = _screen(view, left, right)
    if last <= first:
        return
    columns = slice(first, last)
    slope, horizon = view.slope[columns], view.horizon[columns]
    across, deep = right[0] - left[0], right[1] - left[1]
    span = across - slope * deep
    span[span == 0] = 1e-12
    share = (slope * left[1] - left[0]) / span
    share = np.minimum(np.maximum(share, 0.0), 1.0 - 1e-9)
    depth = np.maximum(left[1] + share * deep, NEAR)
    scale = view.focal / depth
    top, bottom = horizon - (high - view.eye) * scale, horizon + (view.eye - low) * scale
    start = max(ceil(float(top.min()) - 0.5), 0)
    stop = min(ceil(float(bottom.max()) - 0.5), view.height)
    if stop <= start:
        return
    distance = depth.astype(np.float32)
    free = np.asarray(distance < buffers.depth[start:stop, columns], dtype=np.bool_)
    open_columns = np.asarray(free.any(axis=0), dtype=np.bool_)
    if not open_columns.any():
        return
    skip, keep = int(open_columns.argmax()), len(share) - int(open_columns[::-1].argmax())
    if skip or keep < len(share):
        share, top, bottom = (values[skip:keep] for values in (share, top, bottom))
        distance = distance[skip:keep]
        free, columns = free[:, skip:keep], slice(first + skip, first + keep)
    down = texture.heights[0] / np.maximum(bottom - top, 1e-6)
    step = np.empty_like(share)
    step[1:] = np.abs(share[1:] - share[:-1])
    step[0] = step[1] if len(step) > 1 else 0.0
    level = _levels(np.maximum(down, step * float(texture.widths[0]) * 0.7))
    widths, heights = texture.widths[level], texture.heights[level]
    window = slice(start, stop), columns
    scale = (heights / np.maximum(bottom - top, 1e-6)).astype(np.float32)
    # Counting rows from the middle of the image keeps the precision of single floats where it matters.
    rows = (np.arange(start, stop) + (0.5 - view.height / 2)).astype(np.float32)[:, None]
    v = rows - (top - view.height / 2).astype(np.float32)
    v *= scale
    limits = heights.astype(np.float32)
    mask = (v >= 0) & (v < limits) & free
    across_texels = share * widths
    if float(down.min()) < 0.7:
        v += buffers.jitter[1][window]
        np.maximum(v, np.float32(0), out=v)
        np.minimum(v, limits - np.float32(0.5), out=v)
        u = across_texels.astype(np.float32) + buffers.jitter[0][window]
        np.maximum(u, np.float32(0), out=u)
        np.minimum(u, widths.astype(np.float32) - np.float32(0.5), out=u)
        place = v.astype(np.int64)
        place *= widths
        place += u.astype(np.int64)
        place += texture.offsets[level]
    else:
        place = v.astype(np.int64)
        place *= widths
        place += across_texels.astype(np.int64) + texture.offsets[level]
    texels = texture.texels.take(place, mode="clip")
    if not texture.solid:
        mask &= texels >= 1 << 24
    np.copyto(buffers.colour[window], texels, where=mask)
    np.copyto(buffers.depth[window], np.broadcast_to(distance, mask.shape), where=mask)


def draw_slab(buffers: Buffers, view: View, slab: Slab, reach: float) -> None:
    """Draw one level rectangle within ``reach`` metres, from above or from below."""
    window = _slab_window(view, slab, reach)
    if window is None:
        return
    rows, columns = window
    rise = view.eye - slab.level
    below = (np.arange(rows.start, rows.stop)[:, None] + 0.5) - view.horizon[columns]
    below = np.maximum(below, 0.3) if rise > 0 else np.minimum(below, -0.3)
    depth = np.divide(view.focal * rise, below, out=below).astype(np.float32)
    ray_x, ray_y = (ray[columns] for ray in view.rays)
    (ux, uy), x, y = slab.along, view.x - slab.corner[0], view.y - slab.corner[1]
    along = depth * ((ray_x * ux + ray_y * uy) / slab.length).astype(np.float32)
    along += (x * ux + y * uy) / slab.length
    over = depth * ((ray_y * ux - ray_x * uy) / slab.width).astype(np.float32)
    over += (y * ux - x * uy) / slab.width
    mask = (along >= 0) & (along < 1) & (over >= 0) & (over < 1)
    mask &= depth < buffers.depth[window]
    texture = slab.texture
    middle = depth[:, depth.shape[1] // 2].astype(np.float64)
    # A row of pixels covers depth² / (focal · rise) metres of the ground: far ones need a coarse level.
    cover = np.minimum(middle, middle * middle / (abs(rise) * 4.0) + middle * 0.5) / view.focal
    level = _levels(cover * (float(texture.widths[0]) / slab.length))
    widths, heights = texture.widths[level][:, None], texture.heights[level][:, None]
    for values, sizes, jitter in ((along, widths, buffers.jitter[0]), (over, heights, buffers.jitter[1])):
        limits = sizes.astype(np.float32)
        values *= limits
        values += jitter[window]
        np.maximum(values, np.float32(0), out=values)
        np.minimum(values, limits - np.float32(0.5), out=values)
    place = over.astype(np.int64)
    place *= widths
    place += along.astype(np.int64)
    place += texture.offsets[level][:, None]
    texels = texture.texels.take(place, mode="clip")
    if not texture.solid:
        mask &= texels >= 1 << 24
    np.copyto(buffers.colour[window], texels, where=mask)
    np.copyto(buffers.depth[window], depth, where=mask)


def _slab_window(view: View, slab: Slab, reach: float) -> tuple[slice, slice] | None:
    """Return the rows and columns in which a slab may be seen, None where it is not."""
    ahead, side = view.forward
    (ux, uy), rise = slab.along, view.eye - slab.level
    if -0.02 < rise < 0.02:
        return None
    corners = []
    for along, over in ((0.0, 0.0), (slab.length, 0.0), (slab.length, slab.width), (0.0, slab.width)):
        x = slab.corner[0] + along * ux - over * uy - view.x
        y = slab.corner[1] + along * uy + over * ux - view.y
        corners.append((x * side - y * ahead, x * ahead + y * side))
    nearest = min(deep for _, deep in corners)
    edge = view.width / 2 / view.focal
    if max(deep for _, deep in corners) < NEAR or nearest > reach:
        return None
    if all(across > edge * deep for across, deep in corners) or all(across < -edge * deep for across, deep in corners):
        return None
    middle_low, middle_high = float(view.horizon.min()), float(view.horizon.max())
    first, last = 0, view.width
    top, bottom = (middle_low, float(view.height)) if rise > 0 else (0.0, middle_high)
    if nearest > NEAR:
        places = [view.width / 2 + view.focal * across / deep for across, deep in corners]
        first, last = max(floor(min(places)), 0), min(ceil(max(places)) + 1, view.width)
        drops = [view.focal * rise / deep for _, deep in corners]
        top, bottom = max(middle_low + min(drops), 0.0), min(middle_high + max(drops), float(view.height))
    start, stop = max(floor(top), 0), min(ceil(bottom) + 1, view.height)
    if stop <= start or last <= first:
        return None
    return slice(start, stop), slice(first, last)


def draw_sky(buffers: Buffers, view: View, sky: Texture, rise: float) -> None:
    """Fill what is still empty with a panorama that reaches from the horizon to the slope ``rise``.

    Directions are measured by ``y / (|x| + |y|)``, which grows around the circle as the angle does.
    """
    empty = buffers.depth >= FAR
    filled = np.flatnonzero(empty.any(axis=1))
    if not len(filled):
        return
    window = slice(int(filled[0]), int(filled[-1]) + 1)
    ray_x, ray_y = view.rays
    turn = ray_y / (np.abs(ray_x) + np.abs(ray_y))
    turn = np.where(ray_x >= 0, turn + 1.0, 3.0 - turn)
    column = np.minimum((turn * (float(sky.widths[0]) / 4)).astype(np.int64), sky.widths[0] - 1)
    height = int(sky.heights[0])
    rows = np.arange(window.start, window.stop)[:, None] + 0.5
    place = (height - 1) - (view.horizon - rows) * (height / (rise * view.focal))
    place += buffers.jitter[1][window]
    row = np.minimum(np.maximum(place, 0.0), height - 0.5).astype(np.int64)
    row *= sky.widths[0]
    row += column
    np.copyto(buffers.colour[window], sky.texels.take(row, mode="clip"), where=empty[window])
