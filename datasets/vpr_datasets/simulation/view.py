"""Where the camera is and where it looks: the poses of a walk."""

from dataclasses import dataclass
from functools import cached_property
from math import floor, sqrt

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.spec import SimulationSpec, TraverseSpec


@dataclass(frozen=True)
class View:
    """A pinhole camera above a level ground, all lengths in metres.

    Attributes
    ----------
    x, y, eye
        Its place in the world and its height.
    forward
        Unit vector in which it looks; its right is ``(forward[1], -forward[0])``.
    focal
        Focal length in pixels.
    width, height
        Size of the image in pixels.
    slope : (width,) float64
        Tangent of each column's direction against the direction of sight, to the right.
    horizon : (width,) float64
        Row of the horizon in each column; pitch shifts it and roll tilts it.
    """

    x: float
    y: float
    eye: float
    forward: tuple[float, float]
    focal: float
    width: int
    height: int
    slope: NDArray[np.float64]
    horizon: NDArray[np.float64]

    @cached_property
    def rays(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """World direction (x, y) of each column, one metre deep; two (width,) float64."""
        ahead, side = self.forward
        return ahead + self.slope * side, side - self.slope * ahead


def wander(key: tuple[int | str, ...], index: int, period: int) -> float:
    """Return a value in [-1, 1) that changes smoothly with ``index``."""
    knot = floor(index / period)
    part = index / period - knot
    low, high = (Dice(*key, knot + shift + 1).between(-1, 1) for shift in (0, 1))
    return low + (high - low) * part


def place_at(spec: SimulationSpec, traverse: TraverseSpec, index: int) -> float:
    """Return how far along the path, in metres, frame ``index`` of a traverse was taken."""
    key = (spec.seed, traverse.seed, traverse.name, "pace")
    return traverse.start + index * spec.step_of(traverse) + traverse.pace_variation * wander(key, index, 9)


def view_at(spec: SimulationSpec, traverse: TraverseSpec, course: Course, index: int) -> View:
    """Return the camera of one frame."""
    key = (spec.seed, traverse.seed, traverse.name)
    shake = traverse.shake
    jitter = Dice(*key, "jitter", index)
    s = place_at(spec, traverse, index)
    t = traverse.lateral + 0.3 * shake * wander((*key, "sway"), index, 7)
    aim = 0.0
    if spec.gaze:
        aim += spec.gaze * Dice(spec.seed, "gaze", index).between(-1, 1)
    if traverse.stray or traverse.turn:
        free = Dice(*key, "stray", index)
        s, t = s + traverse.stray * free.between(-1, 1), t + traverse.stray * free.between(-1, 1)
        aim += traverse.turn * free.between(-1, 1)
    x, y = course.point(s, t)
    ahead, side = course.tangent(s + 2.5)
    yaw = aim + shake * (0.07 * wander((*key, "yaw"), index, 6) + jitter.between(-0.012, 0.012))
    ahead, side = ahead - yaw * side, side + yaw * ahead
    norm = sqrt(ahead * ahead + side * side)
    pitch = traverse.tilt + shake * (0.045 * wander((*key, "pitch"), index, 8) + jitter.between(-0.01, 0.01))
    roll = shake * (0.012 * wander((*key, "roll"), index, 5) + jitter.between(-0.006, 0.006))
    (width, height), focal = spec.size_of(traverse), spec.focal_of(traverse)
    slope: NDArray[np.float64] = (np.arange(width, dtype=np.float64) + 0.5 - width / 2) / focal
    horizon: NDArray[np.float64] = (0.52 * height + pitch * focal) + slope * (roll * focal)
    eye = traverse.eye_height + 0.03 * shake * jitter.between(-1, 1)
    return View(x, y, eye, (ahead / norm, side / norm), focal, width, height, slope, horizon)
