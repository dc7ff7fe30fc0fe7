"""Eucalypts: single ones, and the crowns that close the view behind gardens."""

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.plants import roughen
from vpr_datasets.simulation.texture import SURFACE, Canvas, Colour

LEAVES: tuple[Colour, ...] = ((138, 154, 104), (120, 142, 94), (150, 162, 118), (110, 132, 88))
BARK: tuple[Colour, ...] = ((206, 198, 184), (186, 172, 154), (148, 128, 110), (220, 214, 204))


def gum(dice: Dice) -> Canvas:
    """Paint a eucalypt with a pale forked stem and loose tufts of leaves, 8 m wide and 13 m tall."""
    canvas = Canvas(8.0, 13.0, 20.0)
    leaf, bark = dice.pick(LEAVES), tinted(dice, dice.pick(BARK), 10)
    fork = dice.between(2.5, 4.5)
    foot = dice.between(3.6, 4.4)
    canvas.polygon([(foot - 0.28, 0), (foot + 0.28, 0), (4.16, fork), (3.84, fork)], bark)
    tips = []
    for _ in range(dice.below(3) + 4):
        knee = (4.0 + dice.between(-1.6, 1.6), fork + dice.between(1.4, 3.6))
        canvas.line(4.0, fork, *knee, 0.24, bark)
        for _ in range(3):
            tip = (knee[0] + dice.between(-1.7, 1.7), min(knee[1] + dice.between(0.6, 4.0), 12.0))
            canvas.line(*knee, *tip, 0.12, toned(bark, 220))
            tips.append(tip)
    for x, y in sorted(tips, key=lambda tip: tip[1]):
        for _ in range(9):
            spot = (x + dice.between(-1.0, 1.0), y + dice.between(-0.8, 0.6))
            tone = 170 + int(y * 9) + dice.below(60)
            canvas.disc(*spot, dice.between(0.25, 0.6), toned(tinted(dice, leaf, 8), tone))
    roughen(canvas, dice, 0.3, 152)
    canvas.speckle(dice, 44, 0.15)
    return canvas


def canopy(dice: Dice, length: float, height: float) -> Canvas:
    """Paint trees and shrubs that stand behind the gardens, a wall with a ragged top."""
    canvas = Canvas(length, height, 9.0, (70, 84, 54))
    rows, columns = canvas.ink.shape
    canvas.ink[:] = 0
    spots = [(dice.between(0, length), dice.between(0, height * 0.9)) for _ in range(int(length * height * 1.3))]
    for x, y in sorted(spots, key=lambda spot: -spot[1]):
        tone = 150 + int(y / height * 90) + dice.below(60)
        canvas.disc(x, y, dice.between(0.5, 1.2), toned(tinted(dice, dice.pick(LEAVES), 10), tone))
    profile = value_noise(dice, 1, columns, 30, 4)[0].astype(np.int64) * rows // 340
    row = np.arange(rows)[:, None]
    canvas.ink[row < profile[None]] = 0
    canvas.ink[rows // 2 :] = SURFACE
    canvas.speckle(dice, 40, 0.4)
    return canvas
