"""One picture, from the place on the path to the pixels."""

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.air import snowfall, veil
from vpr_datasets.simulation.archive import aged
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.raster import Buffers, draw_sky, draw_slab, draw_walls
from vpr_datasets.simulation.scene import Scene, build_scene
from vpr_datasets.simulation.scenes import SCENES
from vpr_datasets.simulation.sensor import develop, illuminate
from vpr_datasets.simulation.sky import RISE
from vpr_datasets.simulation.spec import SimulationSpec
from vpr_datasets.simulation.stage import Slab, Stage, Walls
from vpr_datasets.simulation.view import View, place_at, view_at


def render_frame(spec: SimulationSpec, name: str, index: int) -> NDArray[np.uint8]:
    """Render image ``index`` of the traverse called ``name``.

    Returns
    -------
    image : (H, W, 3) uint8
        RGB.

    Examples
    --------
    >>> spec = SimulationSpec.model_validate(
    ...     {"seed": 1, "frames": 2, "width": 64, "height": 36, "traverses": [{"name": "day"}]}
    ... )
    >>> render_frame(spec, "day", 0).shape
    (36, 64, 3)
    """
    traverse = spec.traverse(name)
    frames = spec.frames_of(traverse)
    if not 0 <= index < frames:
        raise ValueError(f"frame index must be in [0, {frames}), got {index}")
    scene = build_scene(spec, name)
    dice = Dice(spec.seed, traverse.seed, traverse.name, "sensor", index)
    place = place_at(spec, traverse, index)
    if any(start <= place < stop for start, stop in scene.tunnels):
        return develop(np.zeros((*scene.jitter.shape[1:], 3), dtype=np.uint16), traverse, dice)
    setting = SCENES[spec.scene].SETTING
    view = view_at(spec, traverse, scene.course, index)
    buffers = Buffers.empty(scene.jitter)
    passers = _passers(scene, traverse.start, spec.step_of(traverse), index)
    draw_walls(buffers, view, Walls.of(passers.walls), setting.reach, setting.least)
    draw_walls(buffers, view, scene.walls, setting.reach, setting.least)
    for ground in scene.grounds:
        draw_slab(buffers, view, ground, setting.reach)
    for slab in _slabs_near(scene.slabs + passers.slabs, view, setting.slab_reach):
        draw_slab(buffers, view, slab, setting.slab_reach)
    draw_sky(buffers, view, scene.sky, RISE)
    light = illuminate(buffers, view, scene.grid, traverse.light)
    if traverse.haze is not None:
        light = veil(light, buffers, traverse.haze)
    if traverse.snowfall:
        light = snowfall(light, Dice(spec.seed, traverse.seed, traverse.name, "snowfall", index), traverse.snowfall)
    image = develop(light, traverse, dice)
    if traverse.epoch == "archive":
        return aged(image, Dice(spec.seed, traverse.seed, traverse.name, "print", index))
    return image


def _slabs_near(slabs: list[Slab], view: View, reach: float) -> list[Slab]:
    """Return the level pieces ahead that are large enough to be seen."""
    near = []
    for slab in slabs:
        x, y = slab.corner[0] - view.x, slab.corner[1] - view.y
        deep = x * view.forward[0] + y * view.forward[1]
        size = slab.length + slab.width
        if -size < deep < min(reach, 14.0 * size):
            near.append(slab)
    return near


def _passers(scene: Scene, start: float, step: float, index: int) -> Stage:
    """Put up who is on the way, as they stand in one frame."""
    stage = Stage(scene.course)
    for mover in scene.movers:
        s = start + mover.meeting * step + (index - mover.meeting) * mover.pace
        ahead = s - start - index * step
        if mover.put is not None:
            if -mover.width < ahead < 150.0:
                mover.put(stage, s, mover.lateral)
        elif -2.0 < ahead < 60.0:
            stage.cutout(s, mover.lateral, mover.width, mover.height, mover.texture)
    return stage
