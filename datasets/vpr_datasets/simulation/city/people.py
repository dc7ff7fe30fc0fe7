"""People and carts of a hundred years ago, lamps of any time, and the bollards of Amsterdam."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.texture import Canvas

DARK = ((44, 42, 42), (60, 56, 52), (80, 74, 66), (34, 36, 44))


def townsman(dice: Dice) -> Canvas:
    """Paint somebody in a long coat or skirt and a hat, 0.9 m wide and 1.85 m tall."""
    canvas = Canvas(0.9, 1.85, 60.0)
    cloth = tinted(dice, dice.pick(DARK), 8)
    if dice.chance(0.45):
        canvas.polygon([(0.2, 0.04), (0.7, 0.04), (0.56, 1.0), (0.34, 1.0)], cloth)
        if dice.chance(0.5):
            canvas.polygon([(0.3, 0.1), (0.6, 0.1), (0.52, 0.98), (0.38, 0.98)], (200, 196, 188))
    else:
        canvas.polygon([(0.3, 0.05), (0.43, 0.05), (0.46, 0.8), (0.32, 0.8)], cloth)
        canvas.polygon([(0.48, 0.05), (0.62, 0.05), (0.56, 0.8), (0.44, 0.8)], toned(cloth, 210))
    canvas.polygon([(0.29, 0.75), (0.61, 0.75), (0.62, 1.4), (0.54, 1.5), (0.36, 1.5), (0.28, 1.4)], toned(cloth, 290))
    for x in (0.27, 0.63):
        canvas.line(x, 1.4, x + (0.02 if x < 0.5 else -0.02), 0.85, 0.1, toned(cloth, 240))
    canvas.disc(0.45, 1.64, 0.1, (206, 176, 150))
    hat = tinted(dice, dice.pick((*DARK, (190, 180, 150))), 8)
    canvas.rect(0.3, 1.68, 0.3, 0.04, hat)
    canvas.rect(0.36, 1.7, 0.18, dice.between(0.06, 0.14), hat)
    return canvas


def cart(dice: Dice) -> Canvas:
    """Paint a cart with two high wheels and its load, 3 m long and 2 m tall, some with a horse before it."""
    horse = dice.chance(0.5)
    canvas = Canvas(5.4 if horse else 3.0, 2.2, 44.0)
    wood = tinted(dice, (104, 84, 62), 12)
    canvas.rect(0.2, 0.75, 2.4, 0.5, wood)
    canvas.line(2.5, 0.9, 3.4 if horse else 2.95, 0.8, 0.08, wood)
    for number in range(4):
        canvas.rect(0.3 + number * 0.55, 1.2, 0.5, dice.between(0.2, 0.7), tinted(dice, (150, 136, 110), 24))
    canvas.ring(1.2, 0.62, 0.56, 0.08, (60, 50, 42))
    for x, y in ((0.5, 0.0), (0.0, 0.5), (0.36, 0.36), (0.36, -0.36)):
        canvas.line(1.2 - x, 0.62 - y, 1.2 + x, 0.62 + y, 0.05, (60, 50, 42))
    if horse:
        coat = tinted(dice, dice.pick(((84, 60, 44), (50, 46, 44), (170, 164, 154))), 8)
        canvas.rect(3.2, 0.95, 1.5, 0.6, coat)
        for x in (3.25, 3.5, 4.3, 4.55):
            canvas.rect(x, 0.0, 0.13, 1.0, toned(coat, 220))
        canvas.polygon([(4.4, 1.4), (4.75, 1.2), (5.1, 2.0), (4.8, 2.1)], coat)
        canvas.polygon([(4.8, 2.1), (5.1, 2.0), (5.35, 1.75), (5.25, 1.65)], coat)
        canvas.line(3.2, 1.5, 3.05, 0.7, 0.08, toned(coat, 150))
    return canvas


def lantern(dice: Dice) -> Canvas:
    """Paint a lantern on an iron post, 0.9 m wide and 3.8 m tall."""
    canvas = Canvas(0.9, 3.8, 44.0)
    iron = dice.pick(((34, 52, 44), (36, 38, 42)))
    canvas.rect(0.41, 0, 0.08, 3.0, iron)
    canvas.rect(0.36, 0, 0.18, 0.8, iron)
    canvas.rect(0.25, 2.75, 0.4, 0.05, iron)
    canvas.polygon([(0.3, 3.0), (0.6, 3.0), (0.72, 3.5), (0.18, 3.5)], (226, 222, 200))
    canvas.polygon([(0.14, 3.5), (0.76, 3.5), (0.5, 3.75), (0.4, 3.75)], iron)
    canvas.ink[canvas.area(0.2, 3.05, 0.5, 0.4)] = canvas.ink[canvas.area(0.2, 3.05, 0.5, 0.4)] * 200
    return canvas


def old_car(dice: Dice) -> Canvas:
    """Paint an upright black car of the thirties from its side, 4 m long and 1.7 m tall."""
    canvas = Canvas(4.0, 1.7, 44.0)
    colour = tinted(dice, dice.pick(((36, 36, 40), (50, 44, 40), (70, 72, 70))), 6)
    canvas.polygon([(0.1, 0.4), (3.9, 0.4), (3.9, 0.95), (2.7, 1.05), (2.5, 1.65), (0.6, 1.65), (0.3, 1.0)], colour)
    for x in (0.75, 1.6):
        canvas.rect(x, 1.1, 0.7, 0.42, (150, 150, 144))
    for x in (0.8, 3.2):
        canvas.disc(x, 0.4, 0.52, toned(colour, 200))
        canvas.disc(x, 0.36, 0.36, (24, 24, 26))
        canvas.disc(x, 0.36, 0.18, (130, 128, 124))
    canvas.disc(3.85, 0.85, 0.12, (220, 216, 200))
    return canvas
