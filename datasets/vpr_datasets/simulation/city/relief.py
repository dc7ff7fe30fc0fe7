"""What juts out of the fronts of Berlin's houses, and the roofs above them."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.berlin import DENSITY, GROUND, House
from vpr_datasets.simulation.city.windows import glaze, sash, surround
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import blocks, plaster, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas


def put_cornice(stage: Stage, dice: Dice, house: House, side: int, s: float, width: float, t: float) -> None:
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


def put_relief(stage: Stage, dice: Dice, house: House, side: int, s: float, width: float, t: float) -> None:
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


def put_roof(stage: Stage, dice: Dice, house: House, side: int, s: float, width: float, t: float) -> None:
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
