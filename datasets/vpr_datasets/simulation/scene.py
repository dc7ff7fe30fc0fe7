"""A scene that is ready to be photographed, and what passes by on one traverse."""

from dataclasses import dataclass
from functools import lru_cache

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.ground import paint_ground
from vpr_datasets.simulation.lighting import Grid, light_grid
from vpr_datasets.simulation.path import Course, lay_course
from vpr_datasets.simulation.raster import Singles, jitter_pattern
from vpr_datasets.simulation.scenes import SCENES
from vpr_datasets.simulation.sky import paint_sky
from vpr_datasets.simulation.spec import Season, SimulationSpec
from vpr_datasets.simulation.stage import Mover, Slab, Stage, Walls
from vpr_datasets.simulation.texture import Texture

BEFORE, BEYOND = 30.0, 80.0
"""How far the path is laid before the first place and beyond the last, in metres."""


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
def _place(scene: str, seed: int, season: Season, length: float, curvature: float) -> tuple[Stage, Slab]:
    course = lay_course(seed, length, curvature, before=BEFORE, beyond=BEYOND)
    stage = SCENES[scene].lay_out(seed, season, course, length)
    return stage, paint_ground(seed, season, course, stage.floors[::-1])


@lru_cache(maxsize=8)
def build_scene(spec: SimulationSpec, name: str) -> Scene:
    """Build the scene of the traverse called ``name``; scenes of one place share their textures."""
    traverse = spec.traverse(name)
    length = spec.length
    stage, ground = _place(spec.scene, spec.seed, traverse.season, length, spec.curvature)
    dice = Dice(spec.seed, traverse.seed, traverse.name, "traffic")
    parked = Stage(stage.course)
    SCENES[spec.scene].park(parked, dice, traverse, length)
    return Scene(
        stage.course,
        Walls.of(stage.walls + parked.walls),
        stage.slabs + parked.slabs,
        ground,
        paint_sky(spec.seed, traverse.seed, traverse.light),
        light_grid(traverse.light, stage.course, stage.shades, stage.lamps),
        SCENES[spec.scene].send_out(dice, traverse, spec.frames_of(traverse)),
        jitter_pattern(spec.height, spec.width),
    )
