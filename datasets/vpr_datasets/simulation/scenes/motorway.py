"""A motorway through a city: three lanes each way, barriers and greenery, gantries, and bridges that cross above."""

from vpr_datasets.simulation import plants, props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city import kit
from vpr_datasets.simulation.city.autobahn import along, barrier, guide, put_block, put_bridge, put_gantry
from vpr_datasets.simulation.city.roads import Lane, Profile
from vpr_datasets.simulation.city.traffic import set_out
from vpr_datasets.simulation.city.trees import TALL, WIDE, street_tree
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Season, TraverseSpec
from vpr_datasets.simulation.stage import Band, Floor, Mover, Stage
from vpr_datasets.simulation.texture import Canvas

SETTING = Setting(
    knot=110.0, beyond=260.0, density=8.0, margin=40.0, reach=270.0, slab_reach=70.0, least=6.0, kerb=None
)

RIGHT, LEFT = 12.5, 24.0
"""Where the barriers stand, in metres to the right and to the left of the middle of the right carriageway."""

ROAD = Profile(
    kerbs=(-8.2, 18.8),
    islands=((5.6, 8.2),),
    lines=((1.8, 0.15, "dash"), (-1.8, 0.15, "dash"), (-5.4, 0.25, "line"), (5.2, 0.2, "line"), (12.0, 0.15, "dash"),
           (15.6, 0.15, "dash"), (8.6, 0.2, "line"), (18.5, 0.25, "line")),
    lanes=(Lane(3.6, True), Lane(0.0, True), Lane(-3.6, True), Lane(10.2, False), Lane(13.8, False), Lane(17.2, False)),
    parked=(),
    cycles=(),
    trees=(),
    walks=(),
    fronts=(RIGHT, LEFT),
)  # fmt: skip


def lay_out(seed: int, season: Season, course: Course, length: float) -> Stage:
    """Build the scene."""
    stage = Stage(course)
    stop = course.stop
    stage.floors.append(Floor(-60, stop, 2.0, "tarmac", "grass", "grass", _bands()))
    crossings = _cross_over(stage, Dice(seed, "bridges"), length + 200)
    for side in (1, -1):
        _line_side(stage, Dice(seed, "side", side + 1), season, side, stop, crossings)
    _rail(stage, Dice(seed, "rails"), stop)
    _sign(stage, Dice(seed, "signs"), length + 200, crossings)
    return stage


def _bands() -> tuple[Band, ...]:
    right, left = ROAD.kerbs
    bands = [Band(right - 0.8, left + 0.8, "gravel"), Band(right, left, "tarmac"), Band(5.6, 8.2, "gravel"),
             Band(6.2, 7.6, "grass")]  # fmt: skip
    return (*bands, *(Band(t - width / 2, t + width / 2, material) for t, width, material in ROAD.lines))


def _cross_over(stage: Stage, dice: Dice, stop: float) -> list[tuple[float, float]]:
    """Lead bridges across; returns from where to where."""
    crossings = []
    s = dice.between(50, 90)
    while s < stop:
        wide = put_bridge(stage, dice, s, -RIGHT - 3.0, LEFT + 3.0)
        crossings.append((s, s + wide))
        s += wide + dice.between(80, 170)
    return crossings


def _line_side(
    stage: Stage, dice: Dice, season: Season, side: int, stop: float, crossings: list[tuple[float, float]]
) -> None:
    """Line one side with barriers, walls and greenery, houses behind."""
    edge = LEFT if side > 0 else RIGHT
    trees = [street_tree(dice.branch(), season).bake() for _ in range(6)]
    shrubs = [plants.shrub(dice.branch(), season).bake() for _ in range(6)]
    s, kind, high = -34.0, "concrete", 3.5
    while s < stop - 12:
        if dice.chance(0.3):
            kind = dice.pick(("concrete", "panels", "wood", "glass", "brick", "hedge", "green", "panels"))
            high = dice.between(2.6, 5.2)
        # Short stretches follow the bend.
        extent = 12.0
        if kind != "green":
            along(stage, side, s, s + extent, edge, 0, high, barrier(dice, kind, extent, high, season))
        for _ in range(7 if kind == "green" else 2):
            if not any(first - 2 < s < last + 2 for first, last in crossings):
                size = dice.between(0.8, 1.4)
                stage.cutout(s + dice.between(0, extent), side * (edge + dice.between(1.5, 8.0)), WIDE * size,
                             TALL * size, dice.pick(trees))  # fmt: skip
        for _ in range(9 if kind == "green" else 3):
            size = dice.between(0.7, 1.6)
            stage.cutout(s + dice.between(0, extent), side * (edge - dice.between(0.4, 2.6)), 2.4 * size, 1.6 * size,
                         dice.pick(shrubs))  # fmt: skip
        s += extent
    s = -30.0
    while s < stop:
        if dice.chance(0.6):
            s += put_block(stage, dice, side, s, edge + dice.between(10, 26)) + dice.between(2, 24)
        else:
            s += dice.between(12, 50)


def _rail(stage: Stage, dice: Dice, stop: float) -> None:
    """Run crash barriers beside the lanes, and stand lamps in the middle."""
    canvas = Canvas(12.0, 0.8, 24.0)
    for number in range(6):
        canvas.rect(number * 2.0, 0, 0.12, 0.75, (110, 112, 112))
    canvas.rect(0, 0.45, 12.0, 0.32, (172, 176, 176))
    canvas.rect(0, 0.58, 12.0, 0.06, (120, 124, 124))
    rail, post = canvas.bake(), kit.lamp(dice, 11.0, twin=True).bake()
    s = -36.0
    while s < stop - 14:
        for t in (-9.0, 6.0, 7.8, 19.6):
            stage.wall((s, t), (s + 12.0, t), 0, 0.8, rail, "both")
        if s % 36 == 0:
            stage.cutout(s + 3, 6.9, 4.4, 11.0, post)
            stage.lamp(s + 3, 5.0, 10.6, 2.5)
        s += 12.0


def _sign(stage: Stage, dice: Dice, stop: float, crossings: list[tuple[float, float]]) -> None:
    """Put up gantries, signs, emergency telephones and kilometre posts."""
    s = dice.between(15, 35)
    while s < stop:
        if not any(first - 14 < s < last + 14 for first, last in crossings):
            put_gantry(stage, dice, s, -9.6, 6.9) if dice.chance(0.6) else _guide_beside(stage, dice, s)
        s += dice.between(55, 100)
    s = 0.0
    while s < stop:
        s += dice.between(12, 40)
        kind = dice.below(4)
        if kind == 0:
            stage.cutout(s, -9.8, 1.4, 3.0, kit.sign(dice).bake())
        elif kind == 1:
            box = props.bin_side(dice, (236, 130, 40)).bake()
            stage.cutout(s, -9.7, 0.6, 1.7, box)
        elif kind == 2:
            post = Canvas(0.5, 1.0, 50.0)
            post.rect(0.15, 0, 0.2, 1.0, (236, 236, 232))
            post.rect(0.15, 0.6, 0.2, 0.2, (30, 30, 32))
            stage.cutout(s, -8.6, 0.5, 1.0, post.bake())
        else:
            plate = Canvas(1.2, 1.9, 40.0)
            plate.rect(0.55, 0, 0.1, 1.2, kit.STEEL)
            plate.rect(0.05, 1.1, 1.1, 0.7, (30, 100, 60) if dice.chance(0.3) else (24, 72, 150))
            plate.text(0.14, 1.28, 0.32, str(dice.between(8, 22))[:4], (240, 240, 236))
            stage.cutout(s, 6.9 if dice.chance(0.5) else -9.9, 1.2, 1.9, plate.bake())


def _guide_beside(stage: Stage, dice: Dice, s: float) -> None:
    """Stand a large sign on the verge."""
    width, high = 3.4, dice.pick((2.2, 3.0))
    stage.wall((s, -9.4), (s, -9.4 - width), 1.4, 1.4 + high, guide(dice, width, high).bake())
    post = Canvas(width, 1.4, 20.0)
    for x in (0.4, width - 0.55):
        post.rect(x, 0, 0.15, 1.4, kit.STEEL)
    stage.wall((s, -9.4), (s, -9.4 - width), 0, 1.4, post.bake())


def park(stage: Stage, dice: Dice, traverse: TraverseSpec, length: float) -> None:
    """Leave nothing about: one must not stop here."""


def send_out(dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
    """Let cars and lorries drive on all lanes."""
    return set_out(dice, traverse, ROAD, frames, heavy=True)
