"""Narrow houses of Amsterdam, shoulder to shoulder, most of them of brick and under a gable."""

from dataclasses import dataclass
from functools import lru_cache

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.gables import HEIGHTS, STONE, paint_gable
from vpr_datasets.simulation.city.windows import sash
from vpr_datasets.simulation.lots import wall_across, wall_along
from vpr_datasets.simulation.materials import brick, plaster, tinted, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

BRICKS: tuple[Colour, ...] = (
    (132, 84, 66), (104, 66, 54), (84, 60, 52), (150, 104, 80), (118, 78, 66), (70, 58, 54), (160, 128, 104),
)  # fmt: skip
PAINTED: tuple[Colour, ...] = ((216, 210, 196), (188, 190, 184), (120, 128, 118), (206, 190, 150), (96, 98, 100))
DOORS: tuple[Colour, ...] = ((40, 70, 54), (30, 40, 60), (110, 36, 34), (44, 44, 46), (120, 90, 60), (30, 66, 84))
ROOFS: tuple[Colour, ...] = ((150, 82, 58), (120, 70, 56), (74, 74, 80))

GROUND = 3.6
"""Height of the ground floor in metres."""

DENSITY = 24.0


@dataclass(frozen=True)
class House:
    """The looks of a house; lengths in metres."""

    width: float
    brick: bool
    colour: Colour
    frame: Colour
    shutters: Colour | None
    gable: str
    storeys: int
    tall: float
    bays: int
    roof: Colour

    @property
    def eaves(self) -> float:
        """Height at which the gable begins."""
        return GROUND + (self.storeys - 1) * self.tall

    @property
    def high(self) -> float:
        """Height of the top of the gable."""
        return self.eaves + HEIGHTS[self.gable] * self.width


@lru_cache(maxsize=2048)
def draw_house(seed: int, number: int, style: str, width: float) -> House:
    """Draw the looks of a house; ``style`` tells apart what stood on the same plot at different times."""
    dice = Dice(seed, "canal house", number, style)
    solid = dice.chance(0.78)
    colour = tinted(dice, dice.pick(BRICKS if solid else PAINTED), 12)
    gable = dice.pick(("neck", "bell", "step", "spout", "cornice", "cornice", "bell", "neck"))
    shutters = tinted(dice, dice.pick(DOORS), 10) if dice.chance(0.25) else None
    return House(
        width, solid, colour, dice.pick(((232, 228, 216), (232, 228, 216), (200, 190, 160), (60, 70, 62))), shutters,
        "cornice" if width > 7.6 else gable, dice.pick((3, 3, 4, 4, 5)), dice.between(2.7, 3.3),
        3 if width > 6.2 or dice.chance(0.4) else 2, dice.pick(ROOFS),
    )  # fmt: skip


@lru_cache(maxsize=2048)
def paint_upper(seed: int, number: int, style: str, width: float, shade: int) -> Texture:
    """Paint the front above the ground floor, gable and all."""
    house, dice = draw_house(seed, number, style, width), Dice(seed, "upper", number, style)
    canvas = Canvas(width, house.high - GROUND, DENSITY, house.colour)
    (brick if house.brick else plaster)(canvas, dice)
    foot = house.eaves - GROUND
    paint_gable(canvas, dice, house.gable, foot, house.colour)
    bay = width / house.bays
    for storey in range(house.storeys - 1):
        y = storey * house.tall
        wide = min(1.25, bay - 0.5)
        high = house.tall * (0.66 - 0.03 * storey)
        for column in range(house.bays):
            x = column * bay + (bay - wide) / 2
            canvas.rect(x - 0.12, y + 0.5, wide + 0.24, high + 0.16, toned(house.colour, 190))
            canvas.rect(x - 0.1, y + 0.42, wide + 0.2, 0.12, STONE)
            canvas.rect(x - 0.06, y + 0.55 + high, wide + 0.12, 0.2, STONE if house.brick else toned(house.colour, 220))
            sash(canvas, dice, x, y + 0.54, wide, high, house.frame, panes=3 if dice.chance(0.5) else 2)
            if house.shutters is not None and bay - wide > 0.8:
                for left in (x - 0.42, x + wide + 0.06):
                    canvas.rect(left, y + 0.54, 0.36, high, house.shutters)
        if not house.brick or dice.chance(0.3):
            canvas.rect(0, y - 0.06, width, 0.14, STONE)
        for column in range(house.bays + 1):
            if house.brick and dice.chance(0.7):
                canvas.rect(min(max(column * bay - 0.05, 0), width - 0.1), y + 0.1, 0.1, 0.4, (44, 42, 42))
    canvas.rect(0, 0, 0.07, foot, toned(house.colour, 150))
    canvas.rect(width - 0.07, 0, 0.07, foot, toned(house.colour, 170))
    return canvas.bake(shade)


def put_house(
    stage: Stage, seed: int, number: int, style: str, side: int, s: float, width: float, t: float, ground: Texture
) -> House:
    """Put up a house whose front is ``t`` metres beside the path, on top of its ground floor."""
    house = draw_house(seed, number, style, width)
    wall_along(stage, side, s, s + width, t, 0, GROUND, ground)
    upper = paint_upper(seed, number, style, width, 256 if side > 0 else 228)
    wall_along(stage, side, s, s + width, t, GROUND, house.high, upper)
    wall_across(stage, s + 0.02, t, 11.0, 0, house.eaves, _flank(_near(house.colour)), side)
    _put_roof(stage, house, side, s, t)
    stage.shade(s + width / 2, side * (t + 5.5), width - 0.6, 10.0, 0, house.eaves)
    return house


def put_across(
    stage: Stage, seed: int, number: int, style: str, side: int, s: float, width: float, t: float, ground: Texture
) -> None:
    """Put up a house at a corner, whose front looks back along the path."""
    house = draw_house(seed, number, style, width)
    wall_across(stage, s, t, width, 0, GROUND, ground, side)
    wall_across(stage, s, t, width, GROUND, house.high, paint_upper(seed, number, style, width, 212), side)


def _put_roof(stage: Stage, house: House, side: int, s: float, t: float) -> None:
    """Let the roof show behind the gable, its ridge at right angles to the street; or along it behind a cornice."""
    rise = house.width * 0.55
    if house.gable == "cornice":
        wall_along(stage, side, s, s + house.width, t + 0.9, house.high - 0.1, house.high + 1.3, _tiles(house.roof))
        return
    ends = ((s, side * (t + 2.5)), (s + house.width, side * (t + 2.5)))
    stage.wall(*(ends if side > 0 else ends[::-1]), house.eaves, house.eaves + rise, _slope(house.roof))
    middle = s + house.width / 2
    ridge = ((middle, side * (t + 11.0)), (middle, side * (t + 0.4)))
    stage.wall(*(ridge if side > 0 else ridge[::-1]), house.eaves, house.eaves + rise, _tiles(house.roof))


def _near(colour: Colour) -> Colour:
    """Return one of a few colours, so that flanks can share their textures."""
    red, green, blue = (part // 24 * 24 + 12 for part in colour)
    return red, green, blue


@lru_cache(maxsize=64)
def _flank(colour: Colour) -> Texture:
    dice = Dice(*colour, "flank")
    canvas = Canvas(6.0, 6.0, 12.0, toned(colour, 220))
    brick(canvas, dice)
    canvas.speckle(dice, 24, 2.0)
    return canvas.bake(200)


@lru_cache(maxsize=8)
def _tiles(colour: Colour) -> Texture:
    canvas = Canvas(5.0, 3.0, 20.0, colour)
    brick(canvas, Dice(*colour, "tiles"))
    return canvas.bake(220)


@lru_cache(maxsize=8)
def _slope(colour: Colour) -> Texture:
    canvas = Canvas(4.0, 3.0, 20.0)
    canvas.polygon([(0, 0), (4.0, 0), (2.0, 3.0)], colour)
    brick(canvas, Dice(*colour, "slope"))
    return canvas.bake(190)
