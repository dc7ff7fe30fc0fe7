"""Laying out a campus along the path."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import STOREY, draw_style, paint_street, paint_upper
from vpr_datasets.simulation.furniture import furnish
from vpr_datasets.simulation.lots import Greenery, fence_in, grow, plant_garden, plant_grove, put_building, set_plaza
from vpr_datasets.simulation.overhead import span
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.stage import Floor, Stage

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
