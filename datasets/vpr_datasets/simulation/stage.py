"""The pieces a scene is made of: upright walls, level slabs, lamps and what casts shadows."""

from collections.abc import Callable
from dataclasses import dataclass, field
from math import sqrt
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.path import Course, Point
from vpr_datasets.simulation.texture import Texture

Facing = Literal["front", "both", "viewer"]


@dataclass(frozen=True)
class Wall:
    """An upright rectangle between two points on the ground, ``low`` to ``high`` metres above it.

    Seen from its front, ``left`` is on the left. One that faces the ``viewer`` turns with the camera: its
    ``left`` is then its middle, and the x of ``right`` half its width (negative: mirrored).
    """

    left: Point
    right: Point
    low: float
    high: float
    texture: Texture
    facing: Facing = "front"


@dataclass(frozen=True)
class Slab:
    """A level rectangle: its first corner, the unit vector of its length, and its sizes in metres.

    Its width lies to the left of its length.
    """

    corner: Point
    along: Point
    length: float
    width: float
    level: float
    texture: Texture


@dataclass(frozen=True)
class Shade:
    """A convex outline on the ground that shades what is behind it, from ``low`` to ``high`` metres."""

    outline: tuple[Point, ...]
    low: float
    high: float
    roof: bool = False


@dataclass(frozen=True)
class Lamp:
    """A source of light after dark: its place, its height in metres, and its strength (1: a street lamp)."""

    place: Point
    height: float
    power: float


@dataclass(frozen=True)
class Band:
    """A strip of the ground along the path, from ``right`` to ``left`` metres to the left of its middle."""

    right: float
    left: float
    material: str


@dataclass(frozen=True)
class Floor:
    """What the ground is made of from ``start`` to ``stop`` metres along the path.

    ``half`` is half the width of the path in metres; materials are names known to the ground's painter. Bands lie
    on top of these, a later one on top of an earlier one.
    """

    start: float
    stop: float
    half: float
    middle: str
    left: str
    right: str
    bands: tuple[Band, ...] = ()


@dataclass(frozen=True)
class Mover:
    """Somebody on the way.

    ``meeting`` is the frame at which the camera comes by, ``pace`` the metres along the path per frame,
    ``lateral`` the metres to the left of its middle. Somebody is a cut-out; what is more solid is put up by ``put``,
    which is told where (s, t), and ``width`` is then its length.
    """

    meeting: float
    pace: float
    lateral: float
    width: float
    height: float
    texture: Texture
    put: "Callable[[Stage, float, float], None] | None" = None


@dataclass
class Stage:
    """A scene under construction; every place is given as metres along and to the left of the path.

    From where to where it is pitch dark is told by ``tunnels``, in metres along the path.
    """

    course: Course
    walls: list[Wall] = field(default_factory=list)
    slabs: list[Slab] = field(default_factory=list)
    shades: list[Shade] = field(default_factory=list)
    lamps: list[Lamp] = field(default_factory=list)
    floors: list[Floor] = field(default_factory=list)
    tunnels: list[tuple[float, float]] = field(default_factory=list)

    def wall(
        self,
        left: tuple[float, float],
        right: tuple[float, float],
        low: float,
        high: float,
        texture: Texture,
        facing: Facing = "front",
    ) -> None:
        """Put up a wall between two places (s, t)."""
        self.walls.append(Wall(self.course.point(*left), self.course.point(*right), low, high, texture, facing))

    def cutout(self, s: float, t: float, width: float, high: float, texture: Texture, *, low: float = 0.0) -> None:
        """Put up a cut-out that turns with the camera: a tree, a lamp, a person."""
        self.walls.append(Wall(self.course.point(s, t), (width / 2, 0.0), low, high, texture, "viewer"))

    def box(
        self,
        s: float,
        t: float,
        length: float,
        width: float,
        high: float,
        side: Texture,
        end: Texture,
        top: Texture | None,
        *,
        low: float = 0.0,
    ) -> None:
        """Put down a box: ``s`` and ``t`` are its middle, ``length`` goes along the path."""
        near, far = s - length / 2, s + length / 2
        inner, outer = t - width / 2, t + width / 2
        self.wall((near, inner), (far, inner), low, high, side)
        self.wall((far, outer), (near, outer), low, high, side)
        self.wall((near, outer), (near, inner), low, high, end)
        self.wall((far, inner), (far, outer), low, high, end)
        if top is not None:
            self.slab(near, inner, length, width, high, top)

    def slab(
        self, s: float, t: float, length: float, width: float, level: float, texture: Texture, *, roof: bool = False
    ) -> None:
        """Lay a slab whose first corner is (s, t); a roof also keeps the light out below it."""
        corner, end = self.course.point(s, t), self.course.point(s + length, t)
        along = end[0] - corner[0], end[1] - corner[1]
        size = sqrt(along[0] * along[0] + along[1] * along[1])
        unit = along[0] / size, along[1] / size
        self.slabs.append(Slab(corner, unit, size, width, level, texture))
        if roof:
            across = -unit[1] * width, unit[0] * width
            outline = (
                corner,
                end,
                (end[0] + across[0], end[1] + across[1]),
                (corner[0] + across[0], corner[1] + across[1]),
            )
            self.shades.append(Shade(outline, level, level + 0.5, roof=True))

    def shade(self, s: float, t: float, length: float, width: float, low: float, high: float) -> None:
        """Let a block around the middle (s, t) cast a shadow."""
        places = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        outline = tuple(self.course.point(s + a * length / 2, t + b * width / 2) for a, b in places)
        self.shades.append(Shade(outline, low, high))

    def half_width(self, s: float) -> float:
        """Return half the width of the path at ``s``; the first floor that covers it counts."""
        return next((floor.half for floor in self.floors if floor.start <= s < floor.stop), 2.2)

    def lamp(self, s: float, t: float, height: float, power: float) -> None:
        """Hang up a lamp."""
        self.lamps.append(Lamp(self.course.point(s, t), height, power))


@dataclass(frozen=True)
class Walls:
    """All walls as arrays, to find quickly which ones a camera sees; (N,) float64 but for the last two.

    Attributes
    ----------
    x0, y0, x1, y1
        World coordinates of both ends; for those that face the viewer (x1 is half the width) of the middle.
    low, high
        Metres above the ground.
    turns : (N,) bool
        Which ones face the viewer.
    one_sided : (N,) bool
        Which ones are seen from their front only.
    """

    x0: NDArray[np.float64]
    y0: NDArray[np.float64]
    x1: NDArray[np.float64]
    y1: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    turns: NDArray[np.bool_]
    one_sided: NDArray[np.bool_]
    textures: tuple[Texture, ...]

    @classmethod
    def of(cls, walls: list[Wall]) -> "Walls":
        """Collect walls."""
        numbers = np.array(
            [(*wall.left, *wall.right, wall.low, wall.high) for wall in walls], dtype=np.float64
        ).reshape(-1, 6)
        x0, y0, x1, y1, low, high = (np.ascontiguousarray(numbers[:, column]) for column in range(6))
        return cls(
            x0,
            y0,
            x1,
            y1,
            low,
            high,
            np.array([wall.facing == "viewer" for wall in walls], dtype=np.bool_),
            np.array([wall.facing == "front" for wall in walls], dtype=np.bool_),
            tuple(wall.texture for wall in walls),
        )
