"""Lorries and buses."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.vehicles import (
    DENSITY,
    GLASS,
    PAINTS,
    RUBBER,
    YELLOW,
    Vehicle,
    block,
    plate,
    shadow,
    wheel,
)
from vpr_datasets.simulation.city.words import ADVERTS
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.texture import Canvas


def lorry(dice: Dice) -> Vehicle:
    """Draw a lorry with a box or tarpaulin."""
    length, width, high, cab = dice.between(8.0, 12.5), 2.5, 3.7, 2.1
    colour, paint = (
        tinted(dice, dice.pick(((226, 226, 222), (30, 70, 130), (170, 44, 40), (64, 110, 70), (206, 190, 60))), 8),
        dice.pick(PAINTS),
    )
    flank = Canvas(length - cab, high, 30.0)
    flank.rect(0, 0.55, length, 0.4, (56, 58, 60))
    flank.rect(0, 1.0, length - cab - 0.15, high - 1.0, colour)
    flank.speckle(dice, 14, 1.0)
    firm = 0.8, 2.0, 0.8, dice.pick(ADVERTS), (244, 244, 240) if sum(colour) < 480 else (36, 60, 110)
    for x in (1.2, 2.5):
        wheel(flank, x, 0.48)
    back = Canvas(width, high, DENSITY)
    for x in (0.1, width - 0.6):
        back.rect(x, 0, 0.5, 0.6, RUBBER)
    back.rect(0, 0.5, width, 0.2, (50, 50, 52))
    back.rect(0, 0.9, width, high - 0.9, toned(colour, 240))
    back.rect(width / 2 - 0.03, 1.0, 0.06, high - 1.1, toned(colour, 160))
    back.frame(0, 0.95, width, high - 0.95, 0.07, (150, 152, 154))
    for x in (0.05, width - 0.35):
        back.rect(x, 0.62, 0.3, 0.16, (196, 30, 30), 150)
    plate(back, 0.68, width)
    head = Canvas(cab, 3.0, 30.0)
    head.rect(0, 0.4, cab, 2.6, paint)
    head.rect(cab * 0.4, 1.7, cab * 0.5, 0.9, GLASS)
    wheel(head, cab * 0.55, 0.48)
    face = Canvas(width, 3.0, DENSITY, paint)
    face.rect(0.12, 1.7, width - 0.24, 1.0, GLASS)
    face.rect(0.5, 0.8, width - 1.0, 0.6, (36, 36, 38))
    face.rect(0, 0, width, 0.4, RUBBER)
    for x in (0.08, width - 0.5):
        face.rect(x, 0.55, 0.42, 0.22, (240, 238, 224), 230)
    plate(face, 0.45, width)
    lid = Canvas(length - cab, width, 8.0, toned(colour, 250))
    return Vehicle(length, width, high, (
        block(-length / 2, length / 2 - cab, 0.0, 0.0, high, flank, back, Canvas(width, high, 10.0, colour), lid, firm),
        block(length / 2 - cab, length / 2, 0.05, 0.0, 3.0, head, None, face, Canvas(1, 1, 4.0, paint)),
    ), shadow())  # fmt: skip


def bus(dice: Dice) -> Vehicle:
    """Draw a yellow bus, most of them with two decks."""
    double = dice.chance(0.65)
    length, width, high = dice.between(11.0, 13.0), 2.5, 4.05 if double else 3.0
    colour = tinted(dice, YELLOW, 6)
    decks = (1.05, 2.6) if double else (1.05,)
    flank = Canvas(length, high, 32.0)
    flank.rect(0, 0.3, length, high - 0.3, colour)
    flank.rect(0, 0.3, length, 0.14, (56, 58, 60))
    advert = dice.pick(ADVERTS)
    board = dice.pick(((190, 40, 44), (30, 80, 150), (240, 240, 236), (40, 44, 48)))
    for low in decks:
        flank.rect(0.2, low, length - 0.4, 1.0, GLASS, 110)
        for number in range(int(length / 1.5)):
            flank.rect(0.2 + number * 1.5, low, 0.09, 1.0, (30, 32, 34))
            if dice.chance(0.4):
                flank.disc(0.8 + number * 1.5, low + 0.25, 0.16, (120, 96, 84), 60)
    ink = (30, 30, 32) if sum(board) > 600 else (244, 240, 232)
    if double:
        flank.rect(1.0, 2.1, length - 3.5, 0.45, board)
    for x in (length * 0.3, length * 0.84):
        flank.rect(x, 0.35, 1.1, 1.75, (52, 60, 68), 100)
        flank.rect(x + 0.53, 0.35, 0.05, 1.75, (30, 32, 34))
    for x in (length * 0.22, length * 0.78):
        wheel(flank, x, 0.48)
    ends = []
    for rear in (True, False):
        canvas = Canvas(width, high, DENSITY)
        canvas.rect(0, 0.25, width, high - 0.25, colour)
        for x in (0.1, width - 0.4):
            canvas.rect(x, 0, 0.3, 0.3, RUBBER)
        for low in decks[1:] if rear else decks:
            canvas.rect(0.12, low, width - 0.24, 1.05, GLASS, 60)
        lamp = (186, 30, 30) if rear else (240, 238, 226)
        for x in (0.08, width - 0.4):
            canvas.rect(x, 0.5, 0.32, 0.2, lamp, 200)
        sign = 2.2
        canvas.rect(0.5, sign, width - 1.0, 0.32, (24, 24, 26))
        canvas.text(
            0.62,
            sign + 0.06,
            0.2,
            dice.pick(("M19", "M29", "X10", "109", "M46", "110")) + (" ZOO" if not rear else ""),
            (250, 190, 60),
        )
        if rear:
            canvas.rect(0.4, 1.0, width - 0.8, 0.9, board)
            canvas.text(0.5, 1.3, 0.26, advert[:8], ink)
        plate(canvas, 0.4, width)
        ends.append(canvas)
    lid = Canvas(length, width, 10.0, (226, 214, 170))
    lid.frame(0, 0, length, width, 0.2, toned(colour, 220))
    lid.rect(length * 0.4, 0.6, 1.8, 1.3, (190, 190, 186))
    return Vehicle(length, width, high, (
        block(-length / 2, length / 2, 0.0, 0.0, high, flank, ends[0], ends[1], lid,
               (1.6, 2.17, 0.3, advert, ink) if double else None),
    ), shadow())  # fmt: skip
