"""Gardens in front of suburban houses, and what stands at the kerb."""

from dataclasses import dataclass

from vpr_datasets.simulation import gums, plants, props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.houses import House, put_house
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import BRICK, PLASTER, WOOD, tinted, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

ROOFS: tuple[Colour, ...] = (
    (170, 92, 66),
    (140, 74, 60),
    (112, 116, 122),
    (186, 184, 178),
    (88, 104, 92),
    (92, 84, 84),
)
BOARDS: tuple[Colour, ...] = ((232, 230, 222), (216, 208, 176), (170, 190, 196), (188, 196, 168), (206, 170, 150))
FRONT = 8.0
"""How far from the middle of the road the gardens begin, in metres."""


@dataclass(frozen=True)
class Flora:
    """What grows in gardens, each in a few shapes that are used again and again."""

    gums: list[Texture]
    palms: list[Texture]
    trees: list[Texture]
    shrubs: list[Texture]
    canopies: list[Texture]

    def plant(self, stage: Stage, dice: Dice, s: float, t: float, *, tall: float = 0.5) -> None:
        """Plant a tree; ``tall`` is the share of eucalypts."""
        size, side = dice.between(0.6, 1.15), dice.pick((1, -1))
        if dice.chance(tall):
            stage.cutout(s, t, 8.0 * size * side, 13.0 * size, dice.pick(self.gums))
            stage.shade(s, t, 4.2 * size, 4.2 * size, 4.0 * size, 11.5 * size)
            stage.shade(s, t, 0.5, 0.5, 0, 4.0 * size)
        elif dice.chance(0.5):
            stage.cutout(s, t, 5.0 * size * side, 8.0 * size, dice.pick(self.palms))
            stage.shade(s, t, 3.0 * size, 3.0 * size, 4.4 * size, 6.0 * size)
        else:
            stage.cutout(s, t, 6.0 * size * side, 8.0 * size, dice.pick(self.trees))
            stage.shade(s, t, 3.6 * size, 3.6 * size, 2.5 * size, 7.0 * size)


def grow(seed: int) -> Flora:
    """Paint what grows there; the seasons hardly differ."""
    return Flora(
        [gums.gum(Dice(seed, "gum", number)).bake() for number in range(8)],
        [plants.palm(Dice(seed, "palm", number), "summer").bake() for number in range(5)],
        [plants.tree(Dice(seed, "tree", number), "summer").bake() for number in range(5)],
        [plants.shrub(Dice(seed, "shrub", number), "summer").bake() for number in range(8)],
        [gums.canopy(Dice(seed, "canopy", number), 26.0, 10.0).bake() for number in range(5)],
    )


def put_lot(stage: Stage, dice: Dice, flora: Flora, side: int, s: float, extent: float) -> None:
    """Put up a house behind its garden, with a fence, a driveway, a garage, shrubs and trees."""
    double = dice.chance(0.3)
    long, wide = min(dice.between(9, 13), extent - 3.5), dice.between(8, 10)
    t = dice.between(13, 17) + wide / 2
    kind = dice.pick(("wood", "brick", "plaster", "brick"))
    walls = tinted(dice, dice.pick({"wood": BOARDS, "brick": BRICK, "plaster": PLASTER}[kind]), 10)
    drive = s + 2.0 if dice.chance(0.5) else s + extent - 2.0
    middle = s + extent / 2 + (1.6 if drive < s + extent / 2 else -1.6)
    put_house(stage, dice, House(
        middle, side * t, long, wide, 5.4 if double else dice.between(2.7, 3.3), dice.between(1.6, 2.6), walls,
        tinted(dice, dice.pick(ROOFS), 10), material=kind, turned=dice.chance(0.35),
    ))  # fmt: skip
    _pave(stage, dice, side, drive, t - wide / 2)
    _enclose(stage, dice, flora, side, s, extent, drive)
    for _ in range(int(extent * 0.7)):
        size, place = dice.between(0.6, 1.6), s + dice.between(0.4, extent - 0.4)
        if abs(place - drive) > 2.4:
            stage.cutout(place, side * dice.between(FRONT + 0.8, t - wide / 2 - 0.6),
                         2.4 * size * dice.pick((1, -1)), 1.6 * size, dice.pick(flora.shrubs))  # fmt: skip
    for _ in range(dice.below(3)):
        place = s + dice.between(1, extent - 1)
        if abs(place - drive) > 2.4:
            flora.plant(stage, dice, place, side * dice.between(FRONT + 1.2, FRONT + 4), tall=0.25)
    for _ in range(3):
        flora.plant(stage, dice, s + dice.between(0, extent), side * (t + wide / 2 + dice.between(2, 9)), tall=0.7)


def _pave(stage: Stage, dice: Dice, side: int, s: float, end: float) -> None:
    """Lead a driveway from the road to a garage or a carport, and put a letterbox and a bin beside it."""
    colour = tinted(dice, dice.pick(((176, 172, 164), (150, 148, 146), (168, 122, 100))), 10)
    start = 4.8
    canvas = Canvas(3.0, end - start, 16.0, colour)
    canvas.speckle(dice, 20, 0.8)
    canvas.speckle(dice, 14)
    stage.slab(s - 1.5, start if side > 0 else -end, 3.0, end - start, 0.015, canvas.bake())
    door = Canvas(3.2, 2.6, 30.0, tinted(dice, (206, 202, 194), 20))
    for number in range(6):
        door.rect(0.3, 0.1 + number * 0.36, 2.6, 0.3, tinted(dice, (188, 186, 182), 8))
    door.frame(0, 0, 3.2, 2.6, 0.22, tinted(dice, dice.pick(BRICK), 10))
    roof = plain(dice.pick(ROOFS), dice, 3.0)
    body = plain(tinted(dice, dice.pick(BRICK), 12), dice, 3.0)
    wall_along(stage, side, s - 1.6, s + 1.6, end, 0, 2.6, door.bake(250))
    wall_across(stage, s - 1.6, end, 5.0, 0, 2.6, body, side)
    wall_along(stage, side, s - 1.9, s + 1.9, end - 0.2, 2.6, 3.0, roof)
    wall_across(stage, s - 1.9, end - 0.2, 5.4, 2.6, 3.0, roof, side)
    stage.shade(s, side * (end + 2.5), 3.0, 4.6, 0, 2.8)
    box = plain(tinted(dice, dice.pick((*BRICK, (60, 70, 80))), 12), dice)
    stage.box(s + 2.0, side * (FRONT - 0.3), 0.35, 0.35, 1.1, box, box, box)
    if dice.chance(0.6):
        colour = dice.pick(((40, 84, 60), (60, 60, 64), (44, 64, 104)))
        texture, lid = props.bin_side(dice, colour).bake(), plain(dice.pick(((196, 60, 50), (222, 190, 60))), dice)
        stage.box(s - 2.1, side * 5.4, 0.6, 0.7, 1.05, texture, texture, lid)


def _enclose(stage: Stage, dice: Dice, flora: Flora, side: int, s: float, extent: float, drive: float) -> None:
    """Run a fence, a wall or a hedge along the front, open at the drive, and one to the neighbour."""
    kind = dice.pick(("pickets", "wall", "hedge", "open", "boards", "railing"))
    high = {"pickets": 1.1, "wall": 0.8, "hedge": 1.3, "open": 0.0, "boards": 1.75, "railing": 1.2}[kind]
    high *= dice.between(0.85, 1.15)
    paint = dice.branch()
    for start, stop in ((s + 0.2, drive - 1.7), (drive + 1.7, s + extent - 0.2)):
        if high and stop - start > 1.0:
            wall_along(
                stage, side, start, stop, FRONT, 0, high, _fence(Dice(paint.below(1 << 30)), kind, stop - start, high)
            )
            stage.shade((start + stop) / 2, side * FRONT, stop - start, 0.5, 0, high)
    boards = _fence(dice.branch(), "boards", 12.0, 1.7)
    wall_across(stage, s, FRONT + 2.0, 12.0, 0, 1.7, boards, side)
    stage.shade(s, side * (FRONT + 8.0), 0.5, 12.0, 0, 1.7)


def _fence(dice: Dice, kind: str, length: float, high: float) -> Texture:
    if kind == "hedge":
        return plants.hedge(dice, "summer", length, high).bake()
    if kind == "railing":
        return props.railing(dice, length, high).bake()
    if kind == "wall":
        return props.planter_side(dice, length, high).bake(236)
    canvas = Canvas(length, high, 30.0)
    colour = tinted(dice, (232, 230, 224) if kind == "pickets" else dice.pick(WOOD), 12)
    gap, width = (0.22, 0.12) if kind == "pickets" else (0.16, 0.15)
    for number in range(int(length / gap) + 1):
        canvas.rect(number * gap, 0, width, high - dice.between(0, 0.06), tinted(dice, colour, 10))
    for y in (0.25, high - 0.3):
        canvas.rect(0, y, length, 0.08, toned(colour, 220))
    return canvas.bake(240)


def string_poles(stage: Stage, dice: Dice, length: float, beyond: float) -> None:
    """Set wooden poles with cross-arms along one side of the road, with wires and lamps."""
    poles = [_pole(Dice(dice.below(1 << 30), "pole")).bake() for _ in range(3)]
    wire = plain((58, 58, 62), dice)
    side, s = dice.pick((1, -1)), -24.0
    while s < length + beyond - 30:
        gap = dice.between(34, 44)
        t = side * 5.75
        stage.wall((s, t + 2.1), (s, t - 2.1), 0, 9.2, dice.pick(poles), "both")
        stage.shade(s, t, 0.5, 0.5, 0, 9.0)
        stage.lamp(s, t, 6.6, 1.0)
        for across in (-1.0, -0.4, 0.4, 1.0):
            stage.slab(s, t + across, gap, 0.055, 8.45, wire)
        stage.slab(s, t, gap, 0.08, 6.9, wire)
        s += gap
        if dice.chance(0.12):
            side = -side


def _pole(dice: Dice) -> Canvas:
    """Paint a pole, 4.2 m wide and 9.2 m tall."""
    canvas = Canvas(4.2, 9.2, 34.0)
    colour = tinted(dice, (112, 96, 82), 12)
    canvas.rect(1.97, 0, 0.26, 9.2, colour)
    canvas.rect(0.9, 8.3, 2.4, 0.14, toned(colour, 200))
    canvas.rect(1.3, 6.8, 1.6, 0.12, toned(colour, 200))
    for x in (1.05, 1.65, 2.45, 3.05):
        canvas.rect(x, 8.42, 0.12, 0.22, (190, 190, 186))
    if dice.chance(0.6):
        canvas.rect(2.3, 5.9, 0.5, 0.9, (128, 132, 132))
    canvas.line(2.1, 6.2, 0.4, 6.6, 0.08, (128, 132, 132))
    canvas.rect(0.1, 6.5, 0.5, 0.16, (230, 228, 216), 254)
    canvas.rect(1.99, 1.6, 0.22, 0.4, (226, 200, 70))
    return canvas
