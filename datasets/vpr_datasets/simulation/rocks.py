"""Rock: the walls of cuttings, and hills with tunnels through them."""

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.lots import wall_across, wall_along
from vpr_datasets.simulation.materials import blocks, tinted, toned
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.plants import EVERGREEN
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour

ROCK: tuple[Colour, ...] = ((126, 122, 118), (112, 106, 100), (138, 128, 116), (104, 106, 110))
SNOW: Colour = (232, 236, 244)


def rock(dice: Dice, length: float, height: float, colour: Colour, turf: Colour, snow: float) -> Canvas:
    """Paint a face of rock with cracks and ledges under a ragged edge of turf; snow stays on the ledges."""
    dice = dice.branch()
    canvas = Canvas(length, height, 16.0, colour)
    rows, columns = canvas.ink.shape
    canvas.speckle(dice, 60, 2.4)
    blocks(canvas, dice, dice.between(0.5, 1.1), dice.between(0.9, 2.2), 26, 0)
    for _ in range(int(length * height / 5)):
        x, y = dice.between(-1, length), dice.between(0, height)
        canvas.line(
            x, y, x + dice.between(-0.7, 0.7), y - dice.between(0.6, 2.4), 0.07, toned(colour, 110 + dice.below(60))
        )
        canvas.line(x, y, x + dice.between(0.5, 1.8), y + dice.between(-0.4, 0.4), 0.07, toned(colour, 140))
    canvas.speckle(dice, 46, 0.3)
    noise = value_noise(dice, rows, columns, 22, 3)
    moss = noise > 164
    canvas.rgb[moss] = toned(turf, 220)
    if snow:
        ledge = value_noise(dice, rows * 4, columns, 34, 3)[::4] > 176 - int(46 * snow)
        canvas.rgb[ledge] = SNOW
    ragged = value_noise(dice, 1, columns, 28, 4)[0].astype(np.int64) * rows // 900
    row = np.arange(rows)[:, None]
    canvas.rgb[row < ragged[None] + 9] = SNOW if snow > 0.5 else turf
    canvas.speckle(dice, 16, 0.2)
    canvas.ink[row < ragged[None]] = 0
    return canvas


def put_cutting(
    stage: Stage, dice: Dice, side: int, s: float, extent: float, turf: Colour, snow: float, most: float
) -> list[tuple[float, float, float]]:
    """Line one side of the track with rock; returns (s, t, height) of places on top where a tree may grow."""
    colour, pieces = tinted(dice, dice.pick(ROCK), 8), max(int(extent / 8), 1)
    piece, spots = extent / pieces, []
    for number in range(pieces):
        start, t = s + number * piece, dice.between(3.9, 5.2)
        share = (number + 1) / (pieces + 1)
        high = most * (0.35 + 2.2 * share * (1 - share)) * dice.between(0.75, 1.1)
        wall_along(
            stage, side, start, start + piece + 0.3, t, 0, high, rock(dice, piece, high, colour, turf, snow).bake(236)
        )
        wall_across(stage, start, t, 9.0, 0, high, rock(dice, 9.0, high, colour, turf, snow).bake(206), side)
        stage.shade(start + piece / 2, side * (t + 4.5), piece, 8.0, 0, high)
        spots += [(start + dice.between(0, piece), side * (t + dice.between(1.0, 8.0)), high * 0.8) for _ in range(3)]
    return spots


def put_tunnel(stage: Stage, dice: Dice, s: float, extent: float, turf: Colour, snow: float) -> None:
    """Lead the track into a hill; inside it is dark."""
    colour = tinted(dice, dice.pick(ROCK), 8)
    wide, tall = 34.0, dice.between(12.0, 17.0)
    face = rock(dice, 2 * wide, tall, colour, turf, snow)
    rows, columns = face.ink.shape
    # The hill falls off to both sides.
    aside = np.abs(np.arange(columns) - columns // 2)
    fall = np.maximum(aside - columns // 6, 0) * rows // columns * 2
    bush = toned(EVERGREEN[2], 220)
    row = np.arange(rows)[:, None]
    edge = value_noise(dice, 1, columns, 30, 4)[0].astype(np.int64) * rows // 1400 + fall
    face.rgb[(row < edge[None] + 22) & (value_noise(dice, rows, columns, 10, 2) > 110)] = bush if snow < 0.5 else SNOW
    face.ink[row < edge[None]] = 0
    stage.wall((s, wide), (s, -wide), 0, tall, face.bake(214))
    stage.wall((s - 0.4, 4.6), (s - 0.4, -4.6), 0, 8.2, _portal(dice, snow).bake(214))
    for step, rise in ((9.0, 3.5), (20.0, 8.0)):
        hill = rock(dice, 2 * wide - step, tall + rise, toned(turf, 200), turf, snow * 0.8)
        rows, columns = hill.ink.shape
        aside = np.abs(np.arange(columns) - columns // 2)
        hill.ink[np.arange(rows)[:, None] < (aside * rows // columns * 3 // 2)[None]] = 0
        stage.wall((s + step, wide - step / 2), (s + step, step / 2 - wide), 0, tall + rise, hill.bake(200))
    stage.shade(s + extent / 2 + 1, 0, extent - 4, 2 * wide - 20, 0, tall * 0.7)
    stage.tunnels.append((s, s + extent))


def _portal(dice: Dice, snow: float) -> Canvas:
    """Paint the mouth of a tunnel in masonry, 9.2 m wide and 8.2 m tall."""
    stone = tinted(dice, (150, 146, 138), 10)
    canvas = Canvas(9.2, 8.2, 36.0, stone)
    blocks(canvas, dice, 0.5, 0.9, 26, 40)
    canvas.rect(0, 7.7, 9.2, 0.5, SNOW if snow > 0.5 else toned(stone, 220))
    for radius, colour in ((3.0, toned(stone, 190)), (2.6, (4, 4, 5))):
        canvas.disc(4.6, 4.2, radius, colour)
        canvas.rect(4.6 - radius, 0, 2 * radius, 4.2, colour)
    return canvas
