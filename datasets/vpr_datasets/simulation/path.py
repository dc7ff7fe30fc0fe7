"""The course of the path, and the frame of reference in which everything is placed along it.

The path is a graph ``y = p(x)`` over its overall direction, made of parabolas that join smoothly.
A position is given as ``(s, t)``: metres along the path, and metres to its left.
"""

from dataclasses import dataclass
from math import floor, sqrt
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice

Point = tuple[float, float]

GRID = 0.25
"""Spacing of the table of the path's course along x, in metres."""

KNOT = 17.0
"""Usual distance between the points at which the slope of the path is drawn, in metres."""


@dataclass(frozen=True)
class Course:
    """Tables of the path over x = start, start + GRID, …; all (N,) float64, metres."""

    start: float
    y: NDArray[np.float64]
    slope: NDArray[np.float64]
    arc: NDArray[np.float64]

    @property
    def key(self) -> int:
        """A number for what belongs to this course: the same for all traverses of a place."""
        return crc32(self.y.tobytes())

    @property
    def stop(self) -> float:
        """Length along the path at which the tables end."""
        return float(self.arc[-1])

    def at(self, s: float) -> tuple[float, float, float]:
        """Return x, y and the slope of the path at ``s`` metres along it (beyond its ends: the ends)."""
        index = int(np.searchsorted(self.arc, s, side="right")) - 1
        index = min(max(index, 0), len(self.arc) - 2)
        low, high = float(self.arc[index]), float(self.arc[index + 1])
        part = min(max((s - low) / (high - low), 0.0), 1.0)
        y0, y1 = float(self.y[index]), float(self.y[index + 1])
        g0, g1 = float(self.slope[index]), float(self.slope[index + 1])
        return self.start + GRID * (index + part), y0 + (y1 - y0) * part, g0 + (g1 - g0) * part

    def point(self, s: float, t: float) -> Point:
        """Return the world coordinates (x, y) of the place ``t`` metres to the left of the path at ``s``."""
        x, y, slope = self.at(s)
        norm = sqrt(1.0 + slope * slope)
        return x - t * slope / norm, y + t / norm

    def tangent(self, s: float) -> Point:
        """Return the unit vector (x, y) along the path at ``s``."""
        slope = self.at(s)[2]
        norm = sqrt(1.0 + slope * slope)
        return 1.0 / norm, slope / norm


def lay_course(
    seed: int, length: float, curvature: float, *, before: float, beyond: float, spacing: float = KNOT
) -> Course:
    """Draw a path of ``length`` metres with slopes up to ``curvature``, continued at both ends.

    Its slope is drawn every ``spacing`` metres.
    """
    dice = Dice(seed, "course")
    count = floor((length + before + beyond) / spacing) + 3
    knots: list[float] = []
    height = 0.0
    for number in range(count):
        # Leaning back towards the middle keeps the ground that must be painted small.
        pull = -height * 0.02
        sign = 1.0 if number % 2 else -1.0
        slope = curvature * (sign * dice.between(0.1, 1.2) + dice.between(-0.4, 0.4)) + pull
        slope = min(max(slope, -curvature), curvature)
        knots.append(slope)
        height += slope * spacing
    xs, ys, slopes, arcs = 0, [0.0], [knots[0]], [-before]
    while arcs[-1] < length + beyond:
        xs += 1
        place = xs * GRID / spacing
        knot = floor(place)
        if knot + 1 >= count:
            break
        slope = knots[knot] + (knots[knot + 1] - knots[knot]) * (place - knot)
        mean = (slope + slopes[-1]) / 2.0
        ys.append(ys[-1] + mean * GRID)
        arcs.append(arcs[-1] + GRID * sqrt(1.0 + mean * mean))
        slopes.append(slope)
    return Course(-before, np.array(ys), np.array(slopes), np.array(arcs))
