"""A scene that is ready to be photographed, and what passes by on one traverse."""

from dataclasses import dataclass
from functools import lru_cache

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.ground import paint_grounds
from vpr_datasets.simulation.lighting import SUN, Grid, light_grid
from vpr_datasets.simulation.path import Course, lay_course
from vpr_datasets.simulation.raster import Singles, jitter_pattern
from vpr_datasets.simulation.scenes import SCENES, landscape
from vpr_datasets.simulation.sky import paint_sky
from vpr_datasets.simulation.spec import Epoch, Season, SimulationSpec
from vpr_datasets.simulation.stage import Floor, Mover, Slab, Stage, Walls
from vpr_datasets.simulation.texture import Texture

BEFORE = 30.0
"""How far the path is laid before the first place, in metres."""


@dataclass(frozen=True)
class Scene:
    """Everything that one traverse sees."""

    course: Course
    walls: Walls
    slabs: list[Slab]
    grounds: list[Slab]
    tunnels: list[tuple[float, float]]
    sky: Texture
    grid: Grid
    movers: list[Mover]
    jitter: Singles


def course_of(spec: SimulationSpec) -> Course:
    """Return the course of the path that the traverses of ``spec`` follow."""
    return _course(spec.scene, spec.seed, spec.length, spec.curvature)


@lru_cache(maxsize=4)
def _course(scene: str, seed: int, length: float, curvature: float) -> Course:
    setting = SCENES[scene].SETTING
    return lay_course(seed, length, curvature, before=BEFORE, beyond=setting.beyond, spacing=setting.knot)


@lru_cache(maxsize=4)
def _place(
    scene: str, epoch: Epoch, seed: int, season: Season, length: float, curvature: float
) -> tuple[Stage, list[Slab]]:
    course = _course(scene, seed, length, curvature)
    stage = landscape(scene, epoch).lay_out(seed, season, course, length)
    return stage, _grounds(scene, seed, season, length, curvature, tuple(stage.floors[::-1]))


@lru_cache(maxsize=4)
def _grounds(
    scene: str, seed: int, season: Season, length: float, curvature: float, floors: tuple[Floor, ...]
) -> list[Slab]:
    # Epochs of a scene may stand on the same ground, which takes long to paint.
    course = _course(scene, seed, length, curvature)
    return paint_grounds(seed, season, course, list(floors), SCENES[scene].SETTING)


@lru_cache(maxsize=8)
def build_scene(spec: SimulationSpec, name: str) -> Scene:
    """Build the scene of the traverse called ``name``; scenes of one place share their textures."""
    traverse = spec.traverse(name)
    length = spec.length
    setting = SCENES[spec.scene].SETTING
    stage, grounds = _place(spec.scene, traverse.epoch, spec.seed, traverse.season, length, spec.curvature)
    dice = Dice(spec.seed, traverse.seed, traverse.name, "traffic")
    parked = Stage(stage.course)
    land = landscape(spec.scene, traverse.epoch)
    land.park(parked, dice, traverse, length)
    return Scene(
        stage.course,
        Walls.of(stage.walls + parked.walls),
        stage.slabs + parked.slabs,
        grounds,
        stage.tunnels,
        paint_sky(spec.seed, traverse.seed, traverse.light, setting, traverse.season),
        light_grid(traverse.light, stage.course, stage.shades, stage.lamps, traverse.sun or SUN),
        land.send_out(dice, traverse, spec.frames_of(traverse)),
        jitter_pattern(*spec.size_of(traverse)[::-1]),
    )
