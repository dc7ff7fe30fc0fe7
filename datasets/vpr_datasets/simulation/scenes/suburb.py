"""A suburb seen from a car: a road between verges, gardens and detached houses, with side streets and a park."""

from dataclasses import replace

from vpr_datasets.simulation import props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import ACCENTS, STOREY, draw_style, paint_street, paint_upper
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import toned
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Season, TraverseSpec
from vpr_datasets.simulation.stage import Floor, Mover, Stage
from vpr_datasets.simulation.texture import Canvas, Colour
from vpr_datasets.simulation.yards import FRONT, Flora, grow, put_lot, string_poles

SETTING = Setting(
    knot=60.0, beyond=190.0, density=10.0, margin=18.0, land=80.0, reach=150.0, slab_reach=80.0, skyline="trees"
)

DECK = ("lot", "lot", "lot", "lot", "lot", "lot", "lot", "corner", "lot", "lot", "park", "lot", "shops", "lot")
"""What lies along each side of the road, as it is dealt; lots are the rule."""

EXTENTS = {"lot": (14.0, 19.0), "corner": (10.0, 12.0), "park": (26.0, 44.0), "shops": (16.0, 24.0)}
"""Shortest and longest of each kind, in metres along the road."""

HALF = 4.7
"""Half the width of the road in metres."""

PAINTS: tuple[Colour, ...] = (*ACCENTS, (226, 226, 224), (200, 202, 204), (150, 152, 156), (60, 62, 66), (120, 24, 30))


def lay_out(seed: int, season: Season, course: Course, length: float) -> Stage:
    """Build the scene."""
    stage = Stage(course)
    flora = grow(seed)
    stage.floors.append(Floor(-60, length + SETTING.beyond, HALF, "road", "verge", "verge"))
    for side in (1, -1):
        _line_side(stage, Dice(seed, "side", side + 1), flora, side, length)
    string_poles(stage, Dice(seed, "poles"), length, SETTING.beyond)
    _set_signs(stage, Dice(seed, "signs"), flora, length)
    return stage


def _line_side(stage: Stage, dice: Dice, flora: Flora, side: int, length: float) -> None:
    s = -28.0 + dice.between(0, 6)
    deck: list[str] = []
    while s < length + SETTING.beyond - 40:
        deck = deck or dice.shuffled(DECK)
        kind = deck.pop()
        extent = dice.between(*EXTENTS[kind])
        if kind == "lot":
            put_lot(stage, dice, flora, side, s, extent)
        elif kind == "corner":
            _open_street(stage, dice, flora, side, s, extent)
        elif kind == "park":
            _plant_park(stage, dice, flora, side, s, extent)
        else:
            _put_shops(stage, dice, side, s + 1, extent - 2)
        if kind != "corner":
            back = 34.0 + dice.between(-2, 2)
            wall_along(stage, side, s - 1, s + extent + 1, back, 0, dice.between(7, 12), dice.pick(flora.canopies))
        s += extent


def _open_street(stage: Stage, dice: Dice, flora: Flora, side: int, s: float, extent: float) -> None:
    """Let a side street join, with trees at its far end."""
    paving = Canvas(extent - 2.0, 60.0, 8.0, (138, 137, 136))
    paving.speckle(dice, 24, 2.0)
    paving.speckle(dice, 18)
    for number in range(8):
        paving.rect(extent / 2 - 1.06, 3.0 + number * 7.0, 0.12, 3.0, (222, 220, 210))
    paving.rect(0.4, 59.2 if side < 0 else 0.2, extent - 2.8, 0.3, (226, 224, 214))
    stage.slab(s + 1.0, HALF - 0.2 if side > 0 else -HALF + 0.2 - 60.0, extent - 2.0, 60.0, 0.012, paving.bake())
    for edge in (s + 0.2, s + extent - 0.2):
        for number in range(4):
            flora.plant(stage, dice, edge, side * (FRONT + 4 + number * dice.between(9, 12)), tall=0.6)
        for number in range(2):
            wall_across(stage, edge, FRONT + 1 + number * 14.0, 13.0, 0, 1.7,
                        plain(dice.pick(((150, 112, 84), (196, 190, 178))), dice, 4.0), side)  # fmt: skip
    wall_along(stage, side, s - 8, s + extent + 8, 62, 0, 10, dice.pick(flora.canopies))
    sign = Canvas(0.9, 2.4, 50.0)
    sign.rect(0.41, 0, 0.08, 2.0, props.STEEL)
    sign.polygon([(0.05, 2.35), (0.85, 2.35), (0.45, 1.55)], (214, 60, 50))
    sign.polygon([(0.2, 2.27), (0.7, 2.27), (0.45, 1.77)], (240, 238, 230))
    stage.cutout(s + extent - 0.4, side * (HALF + 1.6), 0.9, 2.4, sign.bake())
    name = Canvas(2.4, 3.0, 40.0)
    name.rect(0.1, 0, 0.08, 3.0, props.STEEL)
    name.rect(0.1, 2.6, 2.3, 0.34, (40, 84, 60))
    name.text(0.25, 2.66, 0.2, dice.pick(("HAWKEN", "CARMODY", "MACQUARIE", "CENTRAL", "SWANN", "IRONSIDE", "GAILEY")),
              (244, 244, 238))  # fmt: skip
    stage.wall((s + 0.6, side * (HALF + 1.3) + 1.2), (s + 0.6, side * (HALF + 1.3) - 1.2), 0, 3.0, name.bake(), "both")


def _put_shops(stage: Stage, dice: Dice, side: int, s: float, extent: float) -> None:
    """Put up a row of shops under an awning, at most two storeys high, behind a strip of paving."""
    style = replace(draw_style(dice), storeys=dice.pick((1, 2)))
    t, deep, high = dice.between(8.5, 12.0), 12.0, style.storeys * STOREY + 0.9
    wall_along(stage, side, s, s + extent, t, 0, STOREY, paint_street(dice, style, extent).bake())
    wall_along(stage, side, s, s + extent, t, STOREY, high, paint_upper(dice, style, extent).bake())
    wall_across(stage, s, t, deep, 0, STOREY, paint_street(dice, style, deep).bake(206), side)
    wall_across(stage, s, t, deep, STOREY, high, paint_upper(dice, style, deep).bake(206), side)
    stage.shade(s + extent / 2, side * (t + deep / 2), extent - 1.5, deep - 1.5, 0, high)
    paving = Canvas(extent, t - 7.4, 12.0, (170, 166, 158))
    paving.speckle(dice, 22, 1.0)
    stage.slab(s, 7.4 if side > 0 else -t, extent, t - 7.4, 0.014, paving.bake())
    rim = plain(toned(style.accent, 250), dice, 3.0)
    wall_along(stage, side, s, s + extent, t - 2.0, 2.9, 3.3, rim)
    wall_across(stage, s, t - 2.0, 2.0, 2.9, 3.3, rim, side)
    stage.slab(s, t - 2.0 if side > 0 else -t, extent, 2.0, 2.9, plain(toned(style.accent, 170), dice, 3.0), roof=True)


def _plant_park(stage: Stage, dice: Dice, flora: Flora, side: int, s: float, extent: float) -> None:
    """Leave a lawn with scattered trees and a bench."""
    for _ in range(int(extent * 0.35)):
        flora.plant(stage, dice, s + dice.between(0, extent), side * dice.between(FRONT + 1, 31), tall=0.65)
    for _ in range(int(extent * 0.3)):
        size = dice.between(0.5, 1.1)
        stage.cutout(s + dice.between(0, extent), side * dice.between(FRONT, 26), 2.4 * size, 1.6 * size,
                     dice.pick(flora.shrubs))  # fmt: skip
    ends = ((s + extent / 2 - 0.9, side * (FRONT + 0.4)), (s + extent / 2 + 0.9, side * (FRONT + 0.4)))
    stage.wall(*(ends if side > 0 else ends[::-1]), 0, 0.95, props.bench(dice).bake(), "both")
    rail = props.railing(dice, extent - 1, 0.8)
    wall_along(stage, side, s + 0.5, s + extent - 0.5, FRONT - 0.4, 0, 0.8, rail.bake())


def _set_signs(stage: Stage, dice: Dice, flora: Flora, length: float) -> None:
    """Stand signs, boxes and street trees on the verges."""
    s = -10.0
    while s < length + 100:
        s += dice.between(9, 24)
        side = dice.pick((1, -1))
        t = side * dice.between(5.6, 6.0)
        kind = dice.below(5)
        if kind <= 1:
            stage.cutout(s, t, 1.2, dice.between(2.2, 2.8), props.sign_post(dice).bake())
        elif kind == 2:
            body = plain(dice.pick(((96, 124, 100), (176, 176, 170))), dice)
            stage.box(s, t, dice.between(0.5, 1.1), 0.4, dice.between(0.7, 1.2), body, body, body)
        else:
            flora.plant(stage, dice, s, t, tall=0.3)


def park(stage: Stage, dice: Dice, traverse: TraverseSpec, length: float) -> None:
    """Leave cars at the kerb and in driveways."""
    s = -12.0
    while s < length + 70:
        s += dice.between(5.5, 17)
        if not dice.chance(traverse.traffic):
            continue
        colour, t = dice.pick(PAINTS), dice.pick((1, -1)) * (HALF - 1.0)
        flank, end = props.car_side(dice, colour).bake(), props.car_end(dice, colour).bake()
        stage.box(s, t, 4.2, 1.75, 1.5, flank, end, None)
        stage.slab(s - 1.1, t - 0.6, 1.7, 1.2, 1.47, plain(toned(colour, 240), dice))
        stage.shade(s, t, 4.0, 1.7, 0, 1.3)


def send_out(dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
    """Let cars come towards the camera on the other lane, and a few drive ahead of it."""
    movers = []
    for start in range(0, frames + 30, 14):
        if dice.chance(traverse.traffic):
            texture = props.car_end(dice, dice.pick(PAINTS)).bake()
            lane = -1.7 if traverse.lateral > 0 else 1.7
            movers.append(Mover(start + dice.between(0, 12), dice.between(-4.5, -3.0), lane, 1.75, 1.5, texture))
    return movers
