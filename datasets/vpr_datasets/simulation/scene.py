"""A scene that is ready to be photographed, and what passes by on one traverse."""

from dataclasses import dataclass
from functools import lru_cache

from vpr_datasets.simulation import props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import ACCENTS
from vpr_datasets.simulation.ground import paint_ground
from vpr_datasets.simulation.layout import lay_out
from vpr_datasets.simulation.lighting import Grid, light_grid
from vpr_datasets.simulation.lots import plain
from vpr_datasets.simulation.path import Course, lay_course
from vpr_datasets.simulation.raster import Singles, jitter_pattern
from vpr_datasets.simulation.sky import paint_sky
from vpr_datasets.simulation.spec import Season, SimulationSpec, TraverseSpec
from vpr_datasets.simulation.stage import Slab, Stage, Walls
from vpr_datasets.simulation.texture import Texture

BEFORE, BEYOND = 30.0, 80.0
"""How far the path is laid before the first place and beyond the last, in metres."""


@dataclass(frozen=True)
class Mover:
    """Somebody on the way.

    ``meeting`` is the frame at which the camera comes by, ``pace`` the metres along the path per frame,
    ``lateral`` the metres to the left of its middle.
    """

    meeting: float
    pace: float
    lateral: float
    width: float
    height: float
    texture: Texture


@dataclass(frozen=True)
class Scene:
    """Everything that one traverse sees."""

    course: Course
    walls: Walls
    slabs: list[Slab]
    ground: Slab
    sky: Texture
    grid: Grid
    movers: list[Mover]
    jitter: Singles


@lru_cache(maxsize=4)
def _place(seed: int, season: Season, length: float, curvature: float) -> tuple[Stage, Slab]:
    course = lay_course(seed, length, curvature, before=BEFORE, beyond=BEYOND)
    stage = lay_out(seed, season, course, length)
    return stage, paint_ground(seed, season, course, stage.floors[::-1])


@lru_cache(maxsize=8)
def build_scene(spec: SimulationSpec, name: str) -> Scene:
    """Build the scene of the traverse called ``name``; scenes of one place share their textures."""
    traverse = spec.traverse(name)
    length = spec.frames * spec.step
    stage, ground = _place(spec.seed, traverse.season, length, spec.curvature)
    dice = Dice(spec.seed, traverse.seed, traverse.name, "traffic")
    parked = Stage(stage.course)
    _park(parked, dice, traverse, length)
    return Scene(
        stage.course,
        Walls.of(stage.walls + parked.walls),
        stage.slabs + parked.slabs,
        ground,
        paint_sky(spec.seed, traverse.seed, traverse.light),
        light_grid(traverse.light, stage.course, stage.shades, stage.lamps),
        _movers(dice, traverse, spec.frames),
        jitter_pattern(spec.height, spec.width),
    )


def _park(stage: Stage, dice: Dice, traverse: TraverseSpec, length: float) -> None:
    """Leave bicycles, cars and people who stand about beside the path."""
    bicycles = [props.bicycle(dice).bake() for _ in range(4)]
    people = [props.person(dice).bake() for _ in range(6)]
    s = 0.0
    while s < length + 20:
        s += dice.between(3, 9)
        if not dice.chance(traverse.traffic):
            continue
        side = dice.pick((1, -1))
        t = side * dice.between(2.6, 3.6)
        if dice.chance(0.5):
            for number in range(1 + dice.below(3)):
                ends = ((s + number * 0.5, t + side * 1.4), (s + number * 0.5 + 0.6, t))
                stage.wall(*ends, 0, 1.1, dice.pick(bicycles), "both")
        elif dice.chance(0.7):
            stage.cutout(s, t, 0.9 * dice.pick((1, -1)), dice.between(1.6, 1.9), dice.pick(people))
        else:
            colour = dice.pick((*ACCENTS, (200, 202, 204), (60, 62, 66)))
            flank, end = props.car_side(dice, colour).bake(), props.car_end(dice, colour).bake()
            stage.box(s, side * 4.6, 4.2, 1.75, 1.5, flank, end, None)
            stage.slab(s - 1.1, side * 4.6 - 0.6, 1.7, 1.2, 1.47, plain(colour, dice))


def _movers(dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
    """Send people and cyclists along the path, towards the camera or ahead of it."""
    people = [props.person(dice).bake() for _ in range(8)]
    movers = []
    for start in range(0, frames + 30, 6):
        if dice.chance(traverse.traffic):
            pace = dice.between(-1.3, -0.8) if dice.chance(0.6) else dice.between(0.5, 0.85)
            # Nobody walks into the camera.
            aside = dice.pick((1, -1)) * dice.between(1.0, 2.0)
            lateral = min(max(traverse.lateral + aside, -3.0), 3.0)
            height = dice.between(1.55, 1.9)
            movers.append(Mover(start + dice.between(0, 5), pace, lateral, 0.9, height, dice.pick(people)))
    return movers
