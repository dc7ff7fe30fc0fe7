"""A campus: a winding path between buildings and gardens, with people on foot and on bicycles."""

from vpr_datasets.simulation import props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import ACCENTS, STOREY, draw_style, paint_street, paint_upper
from vpr_datasets.simulation.furniture import furnish
from vpr_datasets.simulation.lots import (
    Greenery,
    fence_in,
    grow,
    plain,
    plant_garden,
    plant_grove,
    put_building,
    set_plaza,
)
from vpr_datasets.simulation.overhead import span
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Season, TraverseSpec
from vpr_datasets.simulation.stage import Floor, Mover, Stage

SETTING = Setting()

PAVINGS = ("asphalt", "concrete", "slabs", "large slabs", "brick", "boards", "cobbles", "tiles")
BORDERS = ("grass", "mulch", "gravel", "slabs", "concrete", "brick", "grass")
"""What the path and the ground beside it are made of; what is listed twice is twice as common."""

DECK = ("building", "building", "building", "building", "garden", "plaza", "fence", "grove", "fence")
"""Lots as they are dealt, shuffled, along each side of the path."""

EXTENTS = {
    "building": (6.0, 15.0),
    "garden": (7.0, 13.0),
    "grove": (9.0, 15.0),
    "plaza": (10.0, 15.0),
    "fence": (7.0, 12.0),
}
"""Shortest and longest of each kind of lot, in metres along the path."""


def lay_out(seed: int, season: Season, course: Course, length: float) -> Stage:
    """Build the scene from ``-20`` to ``length`` metres along the path."""
    stage = Stage(course)
    green = grow(seed, season)
    dice = Dice(seed, "layout")
    _lay_floors(stage, dice, length)
    tunnels = span(stage, Dice(seed, "overhead"), length)
    for side in (1, -1):
        _line_side(stage, Dice(seed, "side", side + 1), green, side, length, tunnels)
    furnish(stage, Dice(seed, "furniture"), green, length)
    _close(stage, Dice(seed, "end"), length)
    return stage


def _lay_floors(stage: Stage, dice: Dice, length: float) -> None:
    s, last = -24.0, ""
    while s < length + 60:
        extent = dice.between(7, 19)
        middle = dice.pick([name for name in PAVINGS if name != last])
        left, right = (dice.pick(BORDERS) for _ in "lr")
        stage.floors.append(Floor(s, s + extent, dice.between(1.9, 3.0), middle, left, right))
        s, last = s + extent, middle


def _line_side(
    stage: Stage, dice: Dice, green: Greenery, side: int, length: float, tunnels: list[tuple[float, float]]
) -> None:
    """Fill one side of the path with lots, leaving out where it leads through a building."""
    s = -20.0 + dice.between(0, 6)
    deck: list[str] = []
    while s < length + 50:
        if not deck:
            deck = dice.shuffled(DECK)
        kind = deck.pop()
        extent = dice.between(*EXTENTS[kind])
        start, stop = next((tunnel for tunnel in tunnels if tunnel[1] > s), (length + 99, length + 99))
        if s + 4 > start:
            s = stop + 0.3
            continue
        extent = min(extent, start - s - 0.3)
        if kind == "building":
            put_building(stage, dice, side, s, extent)
        elif kind == "garden":
            plant_garden(stage, dice, green, side, s, extent)
        elif kind == "grove":
            plant_grove(stage, dice, green, side, s, extent)
        elif kind == "plaza":
            set_plaza(stage, dice, green, side, s, extent)
        else:
            fence_in(stage, dice, green, side, s, extent)
        s += extent + (dice.between(0.2, 3.0) if dice.chance(0.6) else 0.0)


def _close(stage: Stage, dice: Dice, length: float) -> None:
    """End the view with a building across the path."""
    style, wide, s = draw_style(dice), 26.0, length + 55
    stage.wall((s, wide), (s, -wide), 0, STOREY, paint_street(dice, style, 2 * wide).bake(210))
    upper = paint_upper(dice, style, 2 * wide)
    stage.wall((s, wide), (s, -wide), STOREY, STOREY + upper.height, upper.bake(210))


def park(stage: Stage, dice: Dice, traverse: TraverseSpec, length: float) -> None:
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


def send_out(dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
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
