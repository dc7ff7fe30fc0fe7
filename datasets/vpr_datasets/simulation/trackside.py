"""What belongs to a railway: masts and wires, posts and signals, stations and bridges."""

from vpr_datasets.simulation import props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.houses import House, put_house
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import CONCRETE, tinted, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

STATIONS = ("ELVA", "MOEN", "HAUG", "FOSS", "LUND", "VIKA", "DALEN", "BERG")
STEEL: Colour = (96, 100, 104)
RUST: Colour = (112, 84, 68)
SNOW: Colour = (236, 240, 246)


def string_wires(stage: Stage, dice: Dice, length: float, tunnels: list[tuple[float, float]]) -> None:
    """Set masts with an arm over the track, and string the wires between them."""
    masts = {side: [_mast(dice, side, wooden).bake() for wooden in (True, False)] for side in (1, -1)}
    wire = plain((52, 52, 56), dice)
    side, kind, s = 1, 0, -28.0
    while s < length + 170:
        gap = dice.between(44, 54)
        if dice.chance(0.25):
            side, kind = -side, dice.below(2)
        if not any(start - 2 < s < stop + 2 for start, stop in tunnels):
            ends = ((s, 3.3), (s, -0.5)) if side > 0 else ((s, 0.5), (s, -3.3))
            stage.wall(*ends, 0, 7.6, masts[side][kind], "both")
        for part in range(2):
            start = s + part * gap / 2
            stage.slab(start, 0.2 * side, gap / 2, 0.045, 5.5, wire)
            stage.slab(start, 0.2 * side, gap / 2, 0.05, 6.5, wire)
            stage.slab(start, side * 3.1, gap / 2, 0.06, 7.3, wire)
        s += gap


def _mast(dice: Dice, side: int, wooden: bool) -> Canvas:
    """Paint a mast with its arm, 3.8 m wide and 7.6 m tall; it stands left of the track for ``side`` 1."""
    canvas = Canvas(3.8, 7.6, 40.0)

    def at(x: float) -> float:
        return x if side > 0 else 3.8 - x

    colour = (106, 88, 72) if wooden else STEEL
    foot = min(at(0.1), at(0.36))
    canvas.rect(foot, 0, 0.26, 7.6, colour)
    if not wooden:
        for number in range(12):
            canvas.rect(foot + 0.08, 0.3 + number * 0.6, 0.1, 0.4, toned(colour, 150))
    canvas.line(at(0.3), 6.7, at(3.4), 6.6, 0.09, STEEL)
    canvas.line(at(0.3), 5.5, at(2.9), 6.6, 0.08, STEEL)
    canvas.line(at(1.6), 5.95, at(3.5), 5.55, 0.06, STEEL)
    canvas.disc(at(0.55), 6.7, 0.12, (120, 76, 60))
    canvas.disc(at(0.6), 5.7, 0.11, (120, 76, 60))
    return canvas


def set_posts(stage: Stage, dice: Dice, length: float, tunnels: list[tuple[float, float]]) -> None:
    """Set kilometre posts, signals, speed boards and cabinets along the track."""
    s, number = dice.between(-10, 10), dice.between(80, 600)
    while s < length + 60:
        post = Canvas(0.9, 1.7, 50.0)
        post.rect(0.4, 0, 0.1, 1.0, STEEL)
        post.rect(0.05, 0.9, 0.8, 0.75, (238, 236, 228))
        post.text(0.1, 1.1, 0.32, f"{number:.1f}", (30, 30, 34))
        _put(stage, s, -2.7, 0.9, 1.7, post.bake(), tunnels)
        s, number = s + 100.0, number + 0.1
    s = 20.0
    while s < length + 60:
        s += dice.between(35, 90)
        kind, t = dice.below(4), dice.pick((1, -1)) * dice.between(2.5, 3.1)
        if kind == 0:
            _put(stage, s, t, 0.9, 5.2, _signal(dice).bake(), tunnels)
        elif kind == 1:
            _put(stage, s, t, 0.8, 2.2, _speed_board(dice).bake(), tunnels)
        elif not any(start - 2 < s < stop + 2 for start, stop in tunnels):
            body = plain(tinted(dice, (150, 154, 150), 20), dice)
            size = dice.between(0.7, 1.6)
            stage.box(s, t * 1.25, size, 0.7, dice.between(1.0, 1.8), body, body, body)


def _put(
    stage: Stage, s: float, t: float, width: float, high: float, texture: Texture, tunnels: list[tuple[float, float]]
) -> None:
    if not any(start - 2 < s < stop + 2 for start, stop in tunnels):
        stage.wall((s, t + width / 2), (s, t - width / 2), 0, high, texture)


def _signal(dice: Dice) -> Canvas:
    canvas = Canvas(0.9, 5.2, 40.0)
    canvas.rect(0.38, 0, 0.14, 4.2, STEEL)
    canvas.rect(0.1, 3.6, 0.7, 1.55, (28, 28, 30))
    lit = dice.below(3)
    for number, colour in enumerate(((70, 240, 120), (250, 60, 50), (250, 190, 60))):
        canvas.disc(
            0.45, 3.9 + number * 0.45, 0.14, colour if number == lit else (58, 58, 60), 254 if number == lit else 1
        )
    canvas.rect(0.15, 2.6, 0.6, 0.5, (236, 234, 226))
    canvas.text(0.2, 2.72, 0.26, f"{dice.below(90) + 10}", (30, 30, 34))
    return canvas


def _speed_board(dice: Dice) -> Canvas:
    canvas = Canvas(0.8, 2.2, 50.0)
    canvas.rect(0.35, 0, 0.1, 1.5, STEEL)
    canvas.polygon([(0.05, 1.4), (0.75, 1.4), (0.75, 2.15), (0.05, 2.15)], (238, 206, 60))
    canvas.text(0.12, 1.55, 0.44, f"{dice.below(6) + 7}0", (30, 30, 34))
    return canvas


def put_station(stage: Stage, dice: Dice, side: int, s: float, extent: float, snow: float) -> None:
    """Lay a platform along the track, with lamps, a name and the station's house behind it."""
    t, deep, high, name = 1.8, dice.between(3.2, 4.4), 0.7, dice.pick(STATIONS)
    colour = tinted(dice, dice.pick(CONCRETE), 10)
    rim = Canvas(extent, high, 30.0, toned(colour, 230))
    rim.speckle(dice, 20, 0.6)
    rim.rect(0, high - 0.16, extent, 0.16, (226, 222, 212))
    wall_along(stage, side, s, s + extent, t, 0, high, rim.bake())
    wall_across(stage, s, t, deep, 0, high, plain(toned(colour, 210), dice, 3.0), side)
    top = Canvas(extent, deep, 12.0, SNOW if snow > 0.5 else colour)
    top.speckle(dice, 16, 1.0)
    edge = deep - 0.7 if side < 0 else 0.5
    # A slab's texture has its first row at its right-hand side.
    top.rect(0, deep - edge - 0.14, extent, 0.14, (232, 228, 210) if snow < 0.5 else (214, 212, 206))
    stage.slab(s, t if side > 0 else -t - deep, extent, deep, high, top.bake())
    for number in range(int(extent / 14)):
        post = props.lamp_post(Dice(dice.below(1 << 30), "lamp")).bake()
        stage.cutout(s + 5 + number * 14, side * (t + deep - 0.5), 1.6, high + 4.4, post, low=high)
    board = Canvas(3.2, 2.6, 40.0)
    board.rect(0.4, 0, 0.1, 2.0, STEEL)
    board.rect(2.7, 0, 0.1, 2.0, STEEL)
    board.rect(0, 1.8, 3.2, 0.8, (36, 66, 128))
    board.text(0.4, 1.95, 0.5, name, (240, 240, 236))
    where = s + extent * dice.between(0.3, 0.6)
    wall_across(stage, where, t + 0.9, 3.2, high, high + 2.6, board.bake(), side)
    walls = dice.pick(((196, 154, 84), (162, 60, 48), (222, 214, 190), (120, 140, 120)))
    put_house(stage, dice, House(
        s + extent * 0.55, side * (t + deep + 5.0), extent * 0.36, 8.0, dice.pick((3.6, 5.8)), 2.8, walls, (92, 84, 82),
        snow=snow,
    ))  # fmt: skip
    shelter = plain((120, 126, 130), dice)
    middle = s + extent * 0.18
    stage.wall(
        (middle - 2, side * (t + deep - 0.3)), (middle + 2, side * (t + deep - 0.3)), high, high + 2.3, shelter, "both"
    )
    stage.slab(middle - 2.2, (t + deep - 1.9) if side > 0 else -(t + deep), 4.4, 1.9, high + 2.4, shelter)


def put_bridge(stage: Stage, dice: Dice, s: float, extent: float) -> None:
    """Carry the track over water between trusses or railings."""
    colour = tinted(dice, dice.pick((RUST, STEEL, (92, 116, 104), (148, 60, 50))), 10)
    high = dice.pick((1.3, 4.6, 6.4))
    canvas = Canvas(extent, high, 24.0)
    panel = extent / max(int(extent / 5.0), 1)
    for number in range(int(extent / panel + 0.5)):
        x = number * panel
        canvas.rect(x, 0, 0.3 if high > 2 else 0.1, high, colour)
        if high > 2:
            canvas.line(x, 0, x + panel, high, 0.22, colour)
            canvas.line(x, high, x + panel, 0, 0.16, toned(colour, 210))
    for y in (0.0, 0.55, 1.1) if high < 2 else (0.0, 1.1, high - 0.4):
        canvas.rect(0, y, extent, 0.4 if y in (0.0, high - 0.4) else 0.08, colour)
    canvas.speckle(dice, 20, 0.5)
    truss = canvas.bake()
    for t in (3.0, -3.0):
        stage.wall((s, t), (s + extent, t), 0, high, truss, "both")
    beam = plain(toned(colour, 220), dice)
    if high > 6:
        for number in range(int(extent / panel) + 1):
            stage.wall((s + number * panel, 3.0), (s + number * panel, -3.0), high - 0.5, high, beam, "both")
    abutment = props.planter_side(dice, 2.4, 1.1).bake()
    for side in (1, -1):
        wall_across(stage, s - 0.2, 3.0, 2.4, 0, 1.1, abutment, side)
