"""Trees of the north: spruces and birches, single ones and the edge of a wood."""

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.plants import crown, roughen
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.texture import Canvas, Colour

NEEDLES: tuple[Colour, ...] = ((64, 94, 58), (76, 104, 64), (56, 84, 60), (84, 108, 68))
BIRCH: dict[Season, tuple[Colour, ...]] = {
    "spring": ((150, 160, 92), (136, 120, 92), (164, 170, 104)),
    "summer": ((116, 158, 74), (134, 172, 82), (102, 144, 70)),
    "autumn": ((244, 196, 62), (232, 160, 54), (210, 180, 76)),
    "winter": ((128, 112, 104), (140, 126, 118), (116, 102, 96)),
}
SNOW: Colour = (236, 240, 246)


def spruce(dice: Dice, season: Season, snow: float) -> Canvas:
    """Paint a spruce, 4.4 m wide and 11 m tall; ``snow`` is the share of its branches that carry some."""
    canvas = Canvas(4.4, 11.0, 24.0)
    needle = tinted(dice, dice.pick(NEEDLES), 8)
    canvas.rect(2.08, 0, 0.24, 2.0, (84, 66, 54))
    slim, foot = dice.between(0.7, 1.1), dice.between(0.5, 1.6)
    layers = 26
    for layer in range(layers):
        share = layer / layers
        y = foot + (10.6 - foot) * share
        half = (2.1 - 1.95 * share) * slim * dice.between(0.8, 1.1)
        for side in (1, -1):
            reach = half * dice.between(0.75, 1.1)
            droop = 0.35 + reach * dice.between(0.1, 0.3)
            tip = (2.2 + side * reach, y - droop)
            colour = toned(needle, 150 + dice.below(90) + int(share * 60))
            canvas.polygon([(2.2, y + 0.45), tip, (2.2 + side * reach * 0.5, y - droop * 0.8), (2.2, y - 0.3)], colour)
            if dice.chance(snow):
                canvas.line(2.2 + side * 0.1, y + 0.42, tip[0], tip[1] + 0.08, 0.17, tinted(dice, SNOW, 8))
    canvas.line(2.2, 10.4, 2.2, 10.95, 0.1, needle)
    roughen(canvas, dice, 0.3, 176)
    canvas.speckle(dice, 34, 0.15)
    return canvas


def birch(dice: Dice, season: Season, snow: float) -> Canvas:
    """Paint a birch with one to three white stems, 5 m wide and 9 m tall; bare in winter, in bud in spring."""
    canvas = Canvas(5.0, 9.0, 24.0)
    leaf = dice.pick(BIRCH[season])
    twig: Colour = toned((92, 74, 72), 256)
    stems = [(dice.between(2.0, 3.0), dice.between(1.6, 3.4)) for _ in range(1 + dice.below(3))]
    for foot, top in stems:
        for _ in range(30 if season in ("winter", "spring") else 10):
            y = dice.between(2.4, 7.6)
            share = y / 8.0
            x = foot + (top - foot) * share
            end = x + dice.between(-1.3, 1.3)
            canvas.line(x, y, end, y + dice.between(0.3, 1.3), 0.05, twig)
            if dice.chance(snow * 0.6):
                canvas.line(x, y + 0.05, end, y + 0.8, 0.05, tinted(dice, SNOW, 8))
        canvas.line(foot, 0, top, 8.2, 0.16, (212, 208, 200))
        for _ in range(9):
            y = dice.between(0.2, 6.0)
            canvas.rect(foot + (top - foot) * y / 8.2 - 0.08, y, 0.12, 0.1, (60, 56, 54))
    if season in ("summer", "autumn"):
        crown(canvas, dice, leaf, (0.5, 2.2, 4.0, 6.4), 150, 0.36)
        roughen(canvas, dice, 0.34, 148)
    elif season == "spring":
        crown(canvas, dice, leaf, (0.5, 2.8, 4.0, 5.8), 60, 0.2)
        roughen(canvas, dice, 0.25, 138)
    canvas.speckle(dice, 30, 0.15)
    return canvas


def edge(dice: Dice, season: Season, snow: float, length: float, height: float, birches: float) -> Canvas:
    """Paint the edge of a wood as it closes the view, ``birches`` being the share of trees that are none of spruce."""
    canvas = Canvas(length, height, 12.0)
    rows, columns = canvas.ink.shape
    count = int(length * 2.6)
    # Trees farther back are drawn first: taller, and paler in the haze.
    for number in range(count):
        near = number / count
        x, tall = dice.between(0, length), height * (0.95 - 0.4 * near) * dice.between(0.75, 1.0)
        if dice.chance(birches):
            colour = toned(tinted(dice, dice.pick(BIRCH[season]), 10), 190 + int(50 * near))
            if season == "winter":
                for _ in range(14):
                    canvas.line(
                        x, tall * 0.2, x + dice.between(-1.1, 1.1), tall * dice.between(0.5, 0.95), 0.08, colour
                    )
            else:
                for _ in range(12):
                    canvas.disc(x + dice.between(-0.9, 0.9), tall * dice.between(0.3, 0.9), dice.between(0.35, 0.7),
                                toned(colour, 200 + dice.below(90)))  # fmt: skip
            canvas.line(x, 0, x, tall * 0.6, 0.12, (186, 182, 174))
        else:
            colour = toned(tinted(dice, dice.pick(NEEDLES), 8), 190 + int(40 * near))
            half = dice.between(0.9, 1.6)
            for step in range(9):
                y, wide = tall * step / 9.5, half * (1 - step / 9.5)
                shade = toned(colour, 190 + dice.below(80))
                canvas.polygon([(x - wide, y), (x + wide, y), (x + wide * 0.2, y + tall * 0.17),
                                (x - wide * 0.2, y + tall * 0.17)], shade)  # fmt: skip
                if dice.chance(snow * 0.8):
                    canvas.line(x - wide * 0.8, y + 0.1, x, y + tall * 0.14, 0.16, tinted(dice, SNOW, 10))
    canvas.speckle(dice, 40, 0.5)
    foot = np.clip(np.arange(rows)[:, None] - (rows - 24), 0, 24)
    dark = value_noise(dice, rows, columns, 6, 2).astype(np.int16) * foot >> 7
    canvas.tint(-dark.astype(np.int16))
    return canvas
