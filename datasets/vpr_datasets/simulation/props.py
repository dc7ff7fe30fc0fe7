"""Street furniture, and the people and vehicles that pass by or stay."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import ACCENTS, WORDS
from vpr_datasets.simulation.materials import BRICK, CONCRETE, WOOD, blocks, tinted, toned
from vpr_datasets.simulation.texture import Canvas, Colour

STEEL: Colour = (104, 108, 112)
SKIN: tuple[Colour, ...] = ((226, 186, 160), (188, 142, 112), (130, 92, 72), (96, 68, 54))


def lamp_post(dice: Dice) -> Canvas:
    """Paint a street lamp, 1.6 m wide and 4.6 m tall, whose head glows."""
    canvas = Canvas(1.6, 4.6, 50.0)
    steel = tinted(dice, dice.pick((STEEL, (56, 60, 64), (150, 152, 150))), 8)
    canvas.rect(0.74, 0, 0.12, 4.2, steel)
    canvas.rect(0.68, 0, 0.24, 0.5, toned(steel, 200))
    if dice.chance(0.5):
        canvas.disc(0.8, 4.25, 0.26, (240, 238, 226), 254)
    else:
        canvas.rect(0.3, 4.2, 1.0, 0.1, steel)
        canvas.rect(0.2, 4.05, 0.5, 0.16, (240, 238, 226), 254)
        canvas.rect(0.9, 4.05, 0.5, 0.16, (240, 238, 226), 254)
    if dice.chance(0.5):
        colour = dice.pick(ACCENTS)
        canvas.rect(0.9, 2.3, 0.55, 1.3, colour)
        canvas.disc(1.17, 3.1, 0.17, tinted(dice, (225, 225, 215), 20))
    return canvas


def sign_post(dice: Dice) -> Canvas:
    """Paint a sign on a pole, 1.2 m wide and 2.6 m tall."""
    canvas = Canvas(1.2, 2.6, 60.0)
    canvas.rect(0.57, 0, 0.07, 2.5, STEEL)
    colour = dice.pick(ACCENTS)
    shape = dice.below(4)
    if shape == 0:
        canvas.disc(0.6, 2.15, 0.38, colour)
        canvas.disc(0.6, 2.15, 0.27, (236, 234, 226))
        canvas.rect(0.4, 2.1, 0.4, 0.1, (40, 40, 44))
    elif shape == 1:
        canvas.rect(0.1, 1.6, 1.0, 0.85, colour)
        canvas.frame(0.1, 1.6, 1.0, 0.85, 0.05, (236, 234, 226))
        canvas.text(0.2, 1.95, 0.26, dice.pick(("P", "P 2", "EXIT", "GATE", "12", "7B")), (240, 240, 232))
    elif shape == 2:
        canvas.polygon([(0.1, 1.7), (1.1, 1.7), (0.6, 2.5)], (220, 60, 50))
        canvas.polygon([(0.28, 1.8), (0.92, 1.8), (0.6, 2.32)], (240, 238, 228))
    else:
        for number in range(3):
            canvas.rect(0.05, 1.5 + number * 0.34, 1.1, 0.26, colour)
            canvas.rect(0.15, 1.58 + number * 0.34, dice.between(0.4, 0.9), 0.09, (240, 240, 232))
    return canvas


def board(dice: Dice, width: float) -> Canvas:
    """Paint a notice board or map on two legs, 2.2 m tall."""
    canvas = Canvas(width, 2.2, 60.0)
    frame = tinted(dice, dice.pick((*WOOD, STEEL)), 10)
    canvas.rect(0.05, 0, 0.1, 2.2, frame)
    canvas.rect(width - 0.15, 0, 0.1, 2.2, frame)
    canvas.rect(0.05, 0.8, width - 0.1, 1.4, frame)
    canvas.rect(0.13, 0.88, width - 0.26, 1.24, tinted(dice, (214, 210, 196), 14), 40)
    for _ in range(9):
        left, low = dice.between(0.2, width - 0.6), dice.between(0.95, 1.7)
        canvas.rect(left, low, 0.32, 0.36, tinted(dice, dice.pick((*ACCENTS, (236, 234, 226))), 16), 40)
    return canvas


def machine(dice: Dice, width: float, height: float) -> Canvas:
    """Paint the front of a vending machine, ticket machine or cabinet that glows a little."""
    colour = dice.pick(ACCENTS)
    canvas = Canvas(width, height, 60.0, colour)
    canvas.rect(0.1, 0.5, width * 0.65, height - 0.65, (52, 58, 66), 140)
    rows = max(int((height - 0.7) / 0.3), 1)
    for row in range(rows):
        for column in range(max(int(width * 0.65 / 0.16), 1)):
            item = tinted(dice, dice.pick(ACCENTS), 20)
            canvas.rect(0.14 + column * 0.15, 0.56 + row * 0.29, 0.09, 0.19, item, 190)
    canvas.rect(width * 0.8, 0.9, width * 0.12, 0.4, (220, 220, 214), 160)
    canvas.frame(0, 0, width, height, 0.05, toned(colour, 180))
    return canvas


def bin_side(dice: Dice, colour: Colour) -> Canvas:
    """Paint one side of a litter bin, 0.7 m wide and 1.2 m tall."""
    canvas = Canvas(0.7, 1.2, 60.0, colour)
    canvas.rect(0, 1.08, 0.7, 0.12, toned(colour, 150))
    canvas.rect(0.12, 0.85, 0.46, 0.18, (30, 30, 32))
    canvas.rect(0.15, 0.3, 0.4, 0.42, (232, 230, 222))
    canvas.disc(0.35, 0.51, 0.13, dice.pick(ACCENTS))
    canvas.rect(0, 0, 0.7, 0.1, (44, 44, 46))
    return canvas


def planter_side(dice: Dice, length: float, height: float) -> Canvas:
    """Paint the side of a box of brick, concrete or wood: a planter, low wall, plinth or step."""
    colour = tinted(dice, dice.pick((*BRICK, *CONCRETE, *CONCRETE, *WOOD)), 10)
    canvas = Canvas(length, height, 50.0, colour)
    blocks(canvas, dice, dice.pick((0.1, 0.2, 1.0)), dice.pick((0.3, 0.6, 1.2)), 18, 26)
    canvas.speckle(dice, 18, 0.5)
    canvas.rect(0, height - 0.08, length, 0.08, toned(colour, 285))
    return canvas


def bench(dice: Dice) -> Canvas:
    """Paint a bench seen from the front, 1.8 m wide and 0.95 m tall."""
    canvas = Canvas(1.8, 0.95, 60.0)
    wood = tinted(dice, dice.pick(WOOD), 12)
    for x in (0.15, 1.55):
        canvas.rect(x, 0, 0.09, 0.95, (58, 60, 64))
    for y in (0.42, 0.6, 0.72, 0.84):
        canvas.rect(0, y, 1.8, 0.09, tinted(dice, wood, 10))
    return canvas


def railing(dice: Dice, length: float, height: float) -> Canvas:
    """Paint a railing: bars, wires, or panels of glass or mesh."""
    canvas = Canvas(length, height, 44.0)
    steel = tinted(dice, dice.pick(((150, 156, 160), (60, 64, 68), (200, 198, 190))), 10)
    style = dice.below(3)
    if style == 0:
        for number in range(int(length / 0.14)):
            canvas.rect(number * 0.14, 0, 0.035, height, steel)
    elif style == 1:
        for number in range(5):
            canvas.rect(0, 0.15 + number * 0.18, length, 0.035, steel)
    else:
        colour = dice.pick(ACCENTS)
        for number in range(int(length / 1.5)):
            canvas.rect(number * 1.5 + 0.12, 0.12, 1.26, height - 0.3, toned(colour, 200))
    for number in range(int(length / 1.5) + 1):
        canvas.rect(min(number * 1.5, length - 0.07), 0, 0.07, height, toned(steel, 220))
    canvas.rect(0, height - 0.08, length, 0.08, steel)
    return canvas


def parasol(dice: Dice) -> Canvas:
    """Paint a parasol or market tent with tables below, 4 m wide and 3 m tall."""
    canvas = Canvas(4.0, 3.0, 44.0)
    colour = dice.pick(ACCENTS)
    canvas.rect(1.97, 0, 0.08, 2.6, STEEL)
    canvas.polygon([(0.1, 2.15), (3.9, 2.15), (2.4, 2.95), (1.6, 2.95)], colour)
    canvas.polygon([(0.1, 2.15), (1.2, 2.15), (1.75, 2.95), (1.6, 2.95)], toned(colour, 300))
    canvas.rect(0.1, 1.92, 3.8, 0.26, toned(colour, 190))
    canvas.text(0.5, 1.96, 0.17, dice.pick(WORDS), (240, 238, 230))
    for x in (0.4, 2.5):
        canvas.rect(x, 0.7, 1.0, 0.06, (70, 72, 76))
        canvas.rect(x + 0.46, 0, 0.07, 0.7, (70, 72, 76))
        for seat in (x - 0.25, x + 0.85):
            canvas.rect(seat, 0.4, 0.4, 0.06, (40, 42, 46))
            canvas.rect(seat, 0, 0.05, 0.85, (40, 42, 46))
            canvas.rect(seat + 0.35, 0, 0.05, 0.42, (40, 42, 46))
    return canvas


def person(dice: Dice) -> Canvas:
    """Paint a person walking, 0.9 m wide and 1.85 m tall."""
    canvas = Canvas(0.9, 1.85, 60.0)
    skin, shirt = dice.pick(SKIN), tinted(dice, dice.pick(ACCENTS), 30)
    trousers = tinted(dice, dice.pick(((40, 46, 66), (52, 52, 54), (120, 104, 84), (90, 96, 110))), 14)
    stride = dice.between(0.05, 0.2)
    canvas.polygon([(0.36, 0.95), (0.47, 0.95), (0.41 - stride, 0.04), (0.31 - stride, 0.04)], trousers)
    canvas.polygon([(0.44, 0.95), (0.55, 0.95), (0.6 + stride, 0.04), (0.5 + stride, 0.04)], toned(trousers, 210))
    for foot in (0.28 - stride, 0.49 + stride):
        canvas.rect(foot, 0, 0.17, 0.07, (50, 46, 44))
    for shoulder, elbow, hand in ((0.3, 0.24, 0.3 - stride), (0.6, 0.66, 0.6 + stride)):
        canvas.line(shoulder, 1.4, elbow, 1.12, 0.09, toned(shirt, 205))
        canvas.line(elbow, 1.12, hand, 0.9, 0.08, skin)
    canvas.polygon([(0.34, 0.9), (0.56, 0.9), (0.62, 1.38), (0.54, 1.5), (0.36, 1.5), (0.28, 1.38)], shirt)
    canvas.rect(0.41, 1.46, 0.08, 0.12, toned(skin, 220))
    canvas.disc(0.45, 1.67, 0.1, skin)
    canvas.disc(0.45, 1.72, 0.09, dice.pick(((40, 32, 28), (110, 80, 50), (70, 66, 64))))
    if dice.chance(0.5):
        canvas.rect(0.36, 1.02, 0.18, 0.38, toned(dice.pick(ACCENTS), 180))
    return canvas


def bicycle(dice: Dice) -> Canvas:
    """Paint a bicycle from its side, 1.8 m long and 1.1 m tall."""
    canvas = Canvas(1.8, 1.1, 60.0)
    colour = dice.pick(ACCENTS)
    for x in (0.36, 1.44):
        canvas.ring(x, 0.35, 0.33, 0.05, (34, 34, 36))
    for line in ((0.36, 0.35, 0.7, 0.85), (0.7, 0.85, 1.3, 0.85), (0.85, 0.35, 1.3, 0.85), (0.85, 0.35, 0.68, 0.95)):
        canvas.line(*line, 0.05, colour)
    for line in ((0.36, 0.35, 0.85, 0.35), (1.44, 0.35, 1.28, 1.02), (1.16, 1.03, 1.36, 1.03), (0.58, 0.97, 0.8, 0.97)):
        canvas.line(*line, 0.05, (50, 52, 54))
    return canvas


def car_side(dice: Dice, colour: Colour) -> Canvas:
    """Paint the side of a car, 4.2 m long and 1.5 m tall."""
    canvas = Canvas(4.2, 1.5, 50.0)
    canvas.polygon([(0.05, 0.3), (4.15, 0.3), (4.15, 0.8), (3.2, 0.95), (0.1, 0.95)], colour)
    canvas.polygon([(0.5, 0.9), (3.3, 0.9), (2.6, 1.48), (1.0, 1.48)], toned(colour, 235))
    canvas.polygon([(0.75, 0.95), (1.75, 0.95), (1.75, 1.4), (1.08, 1.4)], (46, 54, 62))
    canvas.polygon([(1.85, 0.95), (3.05, 0.95), (2.52, 1.4), (1.85, 1.4)], (52, 62, 70))
    for x in (0.85, 3.35):
        canvas.disc(x, 0.33, 0.33, (28, 28, 30))
        canvas.disc(x, 0.33, 0.18, (150, 152, 154))
    canvas.rect(0.05, 0.62, 0.1, 0.14, (190, 40, 36))
    canvas.rect(4.05, 0.62, 0.1, 0.14, (240, 236, 210))
    return canvas


def car_end(dice: Dice, colour: Colour) -> Canvas:
    """Paint the front or back of a car, 1.75 m wide and 1.5 m tall."""
    canvas = Canvas(1.75, 1.5, 50.0)
    canvas.rect(0.1, 0.0, 0.25, 0.4, (28, 28, 30))
    canvas.rect(1.4, 0.0, 0.25, 0.4, (28, 28, 30))
    canvas.rect(0.03, 0.28, 1.69, 0.68, colour)
    canvas.polygon([(0.12, 0.95), (1.63, 0.95), (1.42, 1.48), (0.33, 1.48)], toned(colour, 225))
    canvas.polygon([(0.24, 1.0), (1.51, 1.0), (1.34, 1.4), (0.41, 1.4)], (50, 60, 68))
    canvas.rect(0.08, 0.66, 0.3, 0.16, (200, 60, 48))
    canvas.rect(1.37, 0.66, 0.3, 0.16, (200, 60, 48))
    canvas.rect(0.6, 0.42, 0.55, 0.14, (232, 230, 210))
    return canvas
