"""Houses of Berlin: stuccoed ones of about 1900 and those that filled the gaps after the war."""

from dataclasses import dataclass, replace

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.shops import paint_ground_floor, put_fronts
from vpr_datasets.simulation.city.windows import glaze, sash, surround
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import blocks, plaster, tinted, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

STUCCO: tuple[Colour, ...] = (
    (222, 210, 182), (206, 186, 146), (196, 192, 184), (226, 222, 212), (204, 172, 150), (186, 190, 172),
    (212, 196, 120), (172, 160, 146), (190, 178, 166), (168, 176, 184), (214, 184, 168), (150, 140, 128),
)  # fmt: skip
RENDER: tuple[Colour, ...] = (
    (206, 204, 198), (190, 182, 164), (214, 208, 186), (170, 172, 172), (200, 186, 150), (156, 168, 172),
)  # fmt: skip
TILES: tuple[Colour, ...] = ((138, 80, 62), (120, 70, 58), (76, 78, 84), (96, 88, 84), (150, 94, 70))
ACCENTS: tuple[Colour, ...] = (
    (170, 60, 50),
    (52, 92, 140),
    (214, 160, 60),
    (80, 120, 90),
    (220, 218, 210),
    (70, 74, 80),
)

GROUND = 4.2
"""Height of the ground floor in metres."""

DENSITY = 20.0
"""Texels per metre of the upper storeys."""


@dataclass(frozen=True)
class House:
    """The looks of a house; lengths in metres."""

    kind: str
    colour: Colour
    trim: Colour
    frame: Colour
    accent: Colour
    roof: Colour
    storeys: int
    tall: float
    bays: int

    @property
    def eaves(self) -> float:
        """Height of the edge of the roof."""
        return GROUND + (self.storeys - 1) * self.tall


def draw_house(dice: Dice, width: float) -> House:
    """Draw the looks of a house that is ``width`` metres wide."""
    kind = dice.pick(("stucco", "stucco", "stucco", "stucco", "plain", "plain", "grid", "glass"))
    old = kind == "stucco"
    colour = tinted(dice, dice.pick(STUCCO if old else RENDER), 12)
    trim = dice.pick((toned(colour, 280), toned(colour, 230), (226, 222, 212))) if old else toned(colour, 280)
    frame = dice.pick(((232, 230, 224), (232, 230, 224), (96, 74, 56), (60, 66, 62))) if old else dice.pick(
        ((226, 226, 222), (70, 74, 78), (120, 122, 124)))  # fmt: skip
    return House(
        kind, colour, trim, frame, dice.pick(ACCENTS), dice.pick(TILES), dice.pick((4, 5, 5, 5, 6) if old else (4, 5, 6, 7)),
        dice.between(3.4, 3.9) if old else dice.between(2.8, 3.3), max(round(width / dice.between(2.4, 3.4)), 3),
    )  # fmt: skip


def put_house(
    stage: Stage,
    dice: Dice,
    side: int,
    s: float,
    width: float,
    t: float,
    words: tuple[str, ...],
    *,
    corner: bool = False,
) -> None:
    """Put up a house whose front is ``t`` metres beside the path; one at a corner has another front at its near end."""
    house = draw_house(dice, width)
    depth, lit = 13.0, 256 if side > 0 else 226
    ground = paint_ground_floor(dice, house.kind == "stucco", house.colour, house.trim, width, GROUND, words)
    wall_along(stage, side, s, s + width, t, 0, GROUND, ground.bake(lit))
    paint = {"stucco": _stucco, "plain": _plain, "grid": _grid, "glass": _glass}[house.kind]
    wall_along(stage, side, s, s + width, t, GROUND, house.eaves, paint(dice, house, width).bake(lit))
    if corner:
        deep = 24.0
        flank = paint_ground_floor(dice, house.kind == "stucco", house.colour, house.trim, deep, GROUND, words)
        wall_across(stage, s, t, deep, 0, GROUND, flank.bake(206), side)
        longer = replace(house, bays=max(round(house.bays * deep / width), 3))
        wall_across(stage, s, t, deep, GROUND, house.eaves, paint(dice, longer, deep).bake(206), side)
    else:
        wall_across(stage, s + 0.02, t, depth, 0, house.eaves, _fire_wall(dice, house, depth, words), side)
    stage.shade(s + width / 2, side * (t + depth / 2), width - 1.0, depth - 1.0, 0, house.eaves)
    put_fronts(stage, dice, side, s, width, t, words)
    if house.kind == "stucco":
        _put_cornice(stage, dice, house, side, s, width, t)
        _put_relief(stage, dice, house, side, s, width, t)
    _put_roof(stage, dice, house, side, s, width, t)


def _fire_wall(dice: Dice, house: House, depth: float, words: tuple[str, ...]) -> Texture:
    """Paint the bare wall to which no neighbour has been built, on some with an old advertisement."""
    canvas = Canvas(depth, house.eaves, 10.0, tinted(dice, (168, 158, 146), 14))
    plaster(canvas, dice)
    canvas.speckle(dice, 20, 3.0)
    if dice.chance(0.2):
        canvas.rect(2.0, 6.0, 8.0, min(7.0, house.eaves - 7.0), tinted(dice, house.accent, 20))
        canvas.disc(6.0, 9.0, 1.6, (232, 228, 216))
        canvas.text(2.6, 6.6, 1.1, dice.pick(words)[:9], (244, 242, 236))
    return canvas.bake(200)


def _heads(dice: Dice, storeys: int) -> list[str]:
    """Choose what crowns the windows of each storey: the first floor has most, the last hardly any."""
    return [
        dice.pick(("gable", "arch", "flat")),
        *[dice.pick(("flat", "stone", "none"))] * (storeys - 3),
        "none",
        "none",
    ]


def _stucco(dice: Dice, house: House, width: float) -> Canvas:
    """Paint the upper storeys of an old house: mouldings, tall windows, belts."""
    canvas = Canvas(width, house.eaves - GROUND, DENSITY, house.colour)
    plaster(canvas, dice)
    canvas.speckle(dice, 12, 3.0)
    bay = width / house.bays
    heads = _heads(dice, house.storeys)
    wide, high = dice.between(1.05, 1.3), house.tall * dice.between(0.54, 0.62)
    rusticated = dice.below(3)
    for storey in range(house.storeys - 1):
        y = storey * house.tall
        if storey < rusticated:
            for number in range(int(house.tall / 0.42)):
                canvas.rect(0, y + number * 0.42, width, 0.05, toned(house.colour, 210))
        tone = toned(house.colour, 272) if storey == 0 else house.trim
        for number in range(house.bays):
            x = number * bay + (bay - wide) / 2
            surround(canvas, x, y + 0.75, wide, high, tone, heads[storey])
            sash(canvas, dice, x, y + 0.75, wide, high, house.frame)
            if storey in (1, 2) and house.accent[0] % 2:
                canvas.rect(x, y + 0.2, wide, 0.4, toned(house.colour, 236))
                canvas.frame(x, y + 0.2, wide, 0.4, 0.06, house.trim)
        canvas.rect(0, y, width, 0.22, house.trim)
        canvas.rect(0, y - 0.08, width, 0.1, toned(house.colour, 150))
    for x in (0.0, width - 0.5):
        for number in range(int(canvas.height / 0.8)):
            canvas.rect(x, number * 0.8, 0.5 - 0.12 * (number % 2), 0.7, toned(house.trim, 246))
    if dice.chance(0.5):
        for number in range(house.bays + 1):
            x = min(max(number * bay - 0.18, 0.0), width - 0.36)
            canvas.rect(x, house.tall, 0.36, house.tall * 2 - 0.1, house.trim)
            canvas.rect(x + 0.36, house.tall, 0.05, house.tall * 2 - 0.1, toned(house.colour, 190))
    canvas.rect(dice.between(0.2, width - 0.4), 0, 0.11, canvas.height, toned(house.colour, 140))
    return canvas


def _plain(dice: Dice, house: House, width: float) -> Canvas:
    """Paint the upper storeys of a house of the fifties: render, wide windows, recessed balconies."""
    canvas = Canvas(width, house.eaves - GROUND, DENSITY, house.colour)
    plaster(canvas, dice)
    bay, wide = width / house.bays, dice.between(1.3, 2.0)
    loggias = [number for number in range(house.bays) if dice.chance(0.3)]
    for storey in range(house.storeys - 1):
        y = storey * house.tall
        for number in range(house.bays):
            x = number * bay
            if number in loggias:
                canvas.rect(x + 0.15, y + 0.25, bay - 0.3, house.tall - 0.45, toned(house.colour, 110))
                glaze(canvas, dice, x + bay * 0.35, y + 0.3, bay * 0.5, house.tall * 0.66, house.frame)
                canvas.rect(x + 0.1, y + 0.2, bay - 0.2, 1.0, tinted(dice, house.accent, 6))
                canvas.rect(x + 0.1, y + 1.15, bay - 0.2, 0.07, toned(house.trim, 230))
                continue
            left = x + (bay - min(wide, bay - 0.4)) / 2
            canvas.rect(left - 0.1, y + 0.8, min(wide, bay - 0.4) + 0.2, 1.55, toned(house.colour, 282))
            glaze(canvas, dice, left, y + 0.9, min(wide, bay - 0.4), 1.4, house.frame)
            canvas.rect(left + min(wide, bay - 0.4) * 0.62, y + 0.9, 0.06, 1.4, house.frame)
            canvas.rect(left - 0.1, y + 0.76, min(wide, bay - 0.4) + 0.2, 0.07, toned(house.colour, 140))
    canvas.rect(0, canvas.height - 0.35, width, 0.35, toned(house.trim, 220))
    return canvas


def _grid(dice: Dice, house: House, width: float) -> Canvas:
    """Paint an office house: a grid of stone or concrete before bands of glass."""
    canvas = Canvas(width, house.eaves - GROUND, DENSITY, house.colour)
    blocks(canvas, dice, house.tall / 4, 1.2, 14, 22)
    canvas.speckle(dice, 14, 2.0)
    bay, pier = width / house.bays, dice.between(0.3, 0.8)
    parapet = dice.between(0.5, 1.1)
    for storey in range(house.storeys - 1):
        y = storey * house.tall
        for number in range(house.bays):
            x = number * bay + pier / 2
            glaze(canvas, dice, x, y + parapet, bay - pier, house.tall - parapet - 0.25, house.frame, lit=0.5)
            canvas.rect(x + (bay - pier) / 2, y + parapet, 0.06, house.tall - parapet - 0.25, house.frame)
            canvas.rect(x, y + house.tall - 0.35, bay - pier, 0.12, toned(house.colour, 110))
            if parapet > 0.8:
                canvas.rect(x, y + 0.1, bay - pier, parapet - 0.2, tinted(dice, toned(house.accent, 220), 6))
    return canvas


def _glass(dice: Dice, house: House, width: float) -> Canvas:
    """Paint a curtain wall."""
    tint = tinted(dice, dice.pick(((92, 122, 140), (78, 98, 104), (112, 128, 120))), 10)
    canvas = Canvas(width, house.eaves - GROUND, DENSITY, tint)
    bay = width / max(round(width / 1.5), 3)
    for storey in range(house.storeys - 1):
        y = storey * house.tall
        canvas.rect(0, y, width, 0.8, toned(tint, 170))
        for number in range(max(round(width / 1.5), 3)):
            glow = 100 + dice.below(120) if dice.chance(0.4) else 8
            pane = toned(tint, 190 + dice.below(130))
            canvas.rect(number * bay, y + 0.8, bay, house.tall - 0.8, pane, glow)
            canvas.rect(
                number * bay, y + 0.8 + (house.tall - 0.8) * dice.between(0.4, 0.8), bay, 0.9, toned(pane, 285), glow
            )
            canvas.rect(number * bay - 0.04, y, 0.08, house.tall, toned(house.trim, 170))
        canvas.rect(0, y + 0.75, width, 0.08, toned(house.trim, 200))
    return canvas


def _put_cornice(stage: Stage, dice: Dice, house: House, side: int, s: float, width: float, t: float) -> None:
    """Let a moulded edge jut out below the roof."""
    reach = dice.between(0.45, 0.8)
    edge = Canvas(width, 0.75, 30.0, house.trim)
    edge.rect(0, 0, width, 0.12, toned(house.trim, 170))
    edge.rect(0, 0.5, width, 0.07, toned(house.trim, 190))
    for number in range(int(width / 0.5)):
        edge.rect(number * 0.5, 0.14, 0.24, 0.26, toned(house.trim, 200))
    edge.speckle(dice, 12, 1.0)
    wall_along(stage, side, s, s + width, t - reach, house.eaves - 0.75, house.eaves, edge.bake())
    under = plain(toned(house.trim, 150), dice)
    wall_across(stage, s, t - reach, reach, house.eaves - 0.75, house.eaves, under, side)
    stage.slab(s, t - reach if side > 0 else -t, width, reach, house.eaves - 0.75, under)


def _put_relief(stage: Stage, dice: Dice, house: House, side: int, s: float, width: float, t: float) -> None:
    """Hang balconies before the windows, or build bays out."""
    bay, low = width / house.bays, GROUND
    middle = [number for number in range(house.bays) if dice.chance(0.4)][:2]
    if dice.chance(0.35) and house.bays >= 4:
        number = dice.pick((0, house.bays // 2, house.bays - 1))
        top = GROUND + (house.storeys - 2) * house.tall
        _put_bay(stage, dice, house, side, s + number * bay + 0.2, bay - 0.4, t, low + 0.1, top)
        middle = [other for other in middle if other != number]
    rail = Canvas(bay * 0.9, 1.0, 44.0)
    for number in range(int(bay * 0.9 / 0.13)):
        rail.rect(number * 0.13, 0, 0.045, 1.0, (52, 54, 56))
    for y in (0.1, 0.5, 0.93):
        rail.rect(0, y, bay * 0.9, 0.06, (52, 54, 56))
    solid = plain(toned(house.colour, 250), dice)
    texture, end = (rail.bake(), rail.bake()) if dice.chance(0.6) else (solid, solid)
    stone = plain(toned(house.trim, 170), dice)
    for number in middle:
        left = s + number * bay + bay * 0.05
        for storey in range(dice.below(2), house.storeys - 2):
            y = GROUND + storey * house.tall + 0.12
            wall_along(stage, side, left, left + bay * 0.9, t - 0.95, y, y + 1.0, texture)
            wall_along(stage, side, left, left + bay * 0.9, t - 0.97, y - 0.16, y, stone)
            wall_across(stage, left, t - 0.95, 0.95, y - 0.16, y + 1.0, end, side)
            stage.slab(left, t - 0.95 if side > 0 else -t, bay * 0.9, 0.95, y - 0.16, stone)


def _put_bay(
    stage: Stage, dice: Dice, house: House, side: int, s: float, width: float, t: float, low: float, high: float
) -> None:
    """Build one bay out over several storeys."""
    reach = 0.95
    front = Canvas(width, high - low, DENSITY, toned(house.colour, 264))
    plaster(front, dice)
    flank = Canvas(reach, high - low, DENSITY, toned(house.colour, 240))
    plaster(flank, dice)
    for storey in range(int((high - low) / house.tall)):
        y = storey * house.tall
        surround(front, width * 0.2, y + 0.7, width * 0.6, house.tall * 0.58, house.trim, "flat", 0.1)
        sash(front, dice, width * 0.2, y + 0.7, width * 0.6, house.tall * 0.58, house.frame, panes=3)
        sash(flank, dice, 0.22, y + 0.7, 0.5, house.tall * 0.58, house.frame, panes=1)
        for canvas in (front, flank):
            canvas.rect(0, y, canvas.width, 0.22, house.trim)
    wall_along(stage, side, s, s + width, t - reach, low, high, front.bake())
    wall_across(stage, s, t - reach, reach, low, high, flank.bake(216), side)
    under = plain(toned(house.trim, 140), dice)
    stage.slab(s, t - reach if side > 0 else -t, width, reach, low, under)
    rail = Canvas(width, 0.9, 40.0)
    for number in range(int(width / 0.14)):
        rail.rect(number * 0.14, 0, 0.05, 0.9, (60, 62, 64))
    rail.rect(0, 0.82, width, 0.08, (60, 62, 64))
    wall_along(stage, side, s, s + width, t - reach, high, high + 0.9, rail.bake())


def _put_roof(stage: Stage, dice: Dice, house: House, side: int, s: float, width: float, t: float) -> None:
    """Put a steep roof with dormers on an old house, a set-back storey on some new ones, and chimneys on both."""
    if house.kind == "stucco" or dice.chance(0.3):
        rise = dice.between(2.2, 3.4)
        roof = Canvas(width, rise, DENSITY, house.roof)
        blocks(roof, dice, 0.25, 0.3, 20, 22)
        roof.speckle(dice, 18, 1.5)
        for number in range(house.bays):
            if dice.chance(0.55):
                x = (number + 0.5) * width / house.bays
                roof.rect(x - 0.75, 0.2, 1.5, min(2.0, rise - 0.3), toned(house.trim, 240))
                sash(roof, dice, x - 0.5, 0.4, 1.0, 1.3, house.frame)
                roof.rect(x - 0.9, min(2.0, rise - 0.3) + 0.1, 1.8, 0.14, toned(house.roof, 170))
        wall_along(stage, side, s, s + width, t + 0.7, house.eaves, house.eaves + rise, roof.bake(244))
        wall_across(stage, s, t + 0.7, 8.0, house.eaves, house.eaves + rise - 0.4, plain(house.roof, dice, 3.0), side)
    elif dice.chance(0.5):
        attic = Canvas(width * 0.8, 2.8, DENSITY, toned(house.colour, 230))
        for number in range(int(width * 0.8 / 2.0)):
            glaze(attic, dice, number * 2.0 + 0.2, 0.3, 1.6, 2.0, house.frame)
        wall_along(stage, side, s + width * 0.1, s + width * 0.9, t + 2.0, house.eaves, house.eaves + 2.8, attic.bake())
    chimney = Canvas(0.9, 1.6, 20.0, (150, 90, 70))
    blocks(chimney, dice, 0.12, 0.3, 24, 20)
    texture = chimney.bake()
    for _ in range(dice.below(3)):
        place = s + dice.between(1.0, width - 1.0)
        wall_along(
            stage, side, place, place + 0.9, t + 3.0, house.eaves + 1.0, house.eaves + dice.between(3.4, 4.6), texture
        )
