"""The storeys above the ground floor of Berlin's houses."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.berlin import DENSITY, GROUND, House
from vpr_datasets.simulation.city.windows import glaze, sash, surround
from vpr_datasets.simulation.materials import blocks, plaster, tinted, toned
from vpr_datasets.simulation.texture import Canvas


def _heads(dice: Dice, storeys: int) -> list[str]:
    """Choose what crowns the windows of each storey: the first floor has most, the last hardly any."""
    return [
        dice.pick(("gable", "arch", "flat")),
        *[dice.pick(("flat", "stone", "none"))] * (storeys - 3),
        "none",
        "none",
    ]


def stucco(dice: Dice, house: House, width: float) -> Canvas:
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


def rendered(dice: Dice, house: House, width: float) -> Canvas:
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


def grid(dice: Dice, house: House, width: float) -> Canvas:
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


def glass(dice: Dice, house: House, width: float) -> Canvas:
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
