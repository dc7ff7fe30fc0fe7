"""Canals: their water and walls, the bridges over them, and the boats on them."""

from functools import lru_cache

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.shops import GOODS
from vpr_datasets.simulation.lots import plain
from vpr_datasets.simulation.materials import blocks, brick, tinted, toned
from vpr_datasets.simulation.spec import Epoch
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

WATER = -1.5
"""Level of the water in metres."""


@lru_cache(maxsize=4)
def water(seed: int) -> Texture:
    """Paint water: green and dark, with streaks of mirrored sky and walls."""
    dice = Dice(seed, "water")
    canvas = Canvas(16.0, 24.0, 12.0, (96, 112, 106))
    for _ in range(420):
        colour = dice.pick(((132, 150, 152), (78, 90, 82), (110, 100, 88), (152, 168, 172), (84, 104, 96)))
        canvas.rect(
            dice.between(-1, 16),
            dice.between(0, 24),
            dice.between(0.2, 1.6),
            dice.between(0.1, 0.5),
            tinted(dice, colour, 10),
        )
    canvas.speckle(dice, 16, 1.0)
    return canvas.bake()


@lru_cache(maxsize=4)
def quay_wall(seed: int) -> Texture:
    """Paint the brick wall of a quay, dark and green at the water, a band of stone on top."""
    dice = Dice(seed, "quay wall")
    canvas = Canvas(8.0, -WATER, 26.0, (112, 82, 70))
    brick(canvas, dice)
    canvas.rect(0, 0, 8.0, 0.4, (56, 66, 50))
    canvas.speckle(dice, 24, 1.0)
    canvas.rect(0, -WATER - 0.22, 8.0, 0.22, (166, 160, 150))
    return canvas.bake(220)


def flood(stage: Stage, seed: int, s: float, length: float, near: float, far: float) -> None:
    """Fill a canal between two places beside the path (``near`` < ``far``, signed) with water, and wall it in."""
    wall = quay_wall(seed)
    for end in (s, s + length):
        stage.wall((end, far), (end, near), WATER, 0.0, wall, "both")
    pieces = max(round(length / 8.0), 1)
    step = length / pieces
    for number in range(pieces):
        start = s + number * step
        stage.slab(start - 1.0, near - 1.5, step + 2.0, far - near + 3.0, WATER, water(seed))
        for t in (near, far):
            stage.wall((start, t), (start + step, t), WATER, 0.0, wall, "both")


def railing(dice: Dice, length: float, stone: Colour | None) -> Texture:
    """Paint the railing of a bridge: iron between posts, or a low wall."""
    canvas = Canvas(length, 1.1, 36.0, stone)
    if stone is not None:
        blocks(canvas, dice, 0.3, 0.9, 14, 26)
        canvas.rect(0, 0.95, length, 0.15, toned(stone, 280))
        return canvas.bake()
    iron = dice.pick(((30, 50, 40), (40, 42, 46), (50, 60, 80)))
    for number in range(int(length / 0.16)):
        canvas.rect(number * 0.16, 0.1, 0.035, 0.95, iron)
    for number in range(int(length / 2.0) + 1):
        canvas.rect(min(number * 2.0, length - 0.12), 0, 0.12, 1.1, iron)
    for y in (0.1, 0.6, 1.02):
        canvas.rect(0, y, length, 0.06, iron)
    return canvas.bake()


def put_bridge(stage: Stage, dice: Dice, s: float, near: float, far: float) -> None:
    """Lead a street over a canal beside the path, seen from the quay: a flat arch of brick under a railing."""
    span, wide = abs(far - near), dice.between(5.0, 7.0)
    colour = tinted(dice, dice.pick(((124, 84, 70), (150, 140, 126), (110, 78, 68))), 8)
    face = Canvas(span, 1.5 - WATER, 24.0, colour)
    brick(face, dice)
    arches = dice.pick((1, 3))
    room = span / arches
    for number in range(arches):
        middle = (number + 0.5) * room
        points = [
            (middle + room * 0.42 * u, (1.0 - WATER) * (1 - u * u) * 0.8) for u in (-1, -0.7, -0.4, 0, 0.4, 0.7, 1)
        ]
        face.polygon([(x, y + 0.12) for x, y in points], (190, 182, 168))
        hole = Canvas(span, face.height, 24.0)
        hole.polygon([*points, (middle + room * 0.42, 0.0), (middle - room * 0.42, 0.0)], (1, 1, 1))
        face.rgb[hole.ink > 0] = (28, 32, 30)
    face.rect(0, face.height - 0.24, span, 0.24, (190, 184, 172))
    rail = railing(dice, span, None)
    texture = face.bake(224)
    for place in (s, s + wide):
        stage.wall((place, far), (place, near), WATER, 1.5, texture, "both")
        stage.wall((place, far), (place, near), 1.5, 2.6, rail, "both")
    deck = plain((140, 128, 118), dice, 4.0)
    stage.slab(s, min(near, far), wide, span, 1.5, deck)
    ramp = plain(toned(colour, 240), dice, 4.0)
    for t, way in ((near, -1), (far, 1)):
        stage.wall((s, t), (s, t + way * 2.5), 0, 0.9, ramp, "both")


def moor(stage: Stage, dice: Dice, epoch: Epoch, s: float, t: float, way: int) -> None:
    """Moor a boat along a quay at ``t``; ``way`` points to the middle of the canal."""
    house = epoch == "today" and dice.chance(0.3)
    length, width = (dice.between(11, 16), 3.2) if house or epoch == "archive" else (dice.between(4.5, 7.5), 1.8)
    middle = t + way * (width / 2 + 0.5)
    hull = tinted(dice, dice.pick(((40, 44, 52), (60, 40, 34), (34, 60, 50), (200, 196, 186), (90, 40, 36))), 10)
    side = Canvas(length, 0.9, 24.0)
    side.polygon([(0.0, 0.9), (length, 0.9), (length - 0.8, 0.0), (0.6, 0.0)], hull)
    side.rect(0, 0.76, length, 0.14, toned(hull, 330))
    end = plain(hull, dice)
    top = plain(tinted(dice, (130, 100, 70), 20), dice, 2.0)
    stage.box(s, middle, length, width, WATER + 0.9, side.bake(), end, top, low=WATER)
    if house:
        cabin = Canvas(length * 0.8, 2.0, 24.0, tinted(dice, dice.pick(GOODS), 20))
        for number in range(int(length * 0.8 / 2.0)):
            cabin.rect(number * 2.0 + 0.4, 0.7, 1.2, 0.8, (66, 78, 86), 100)
            cabin.frame(number * 2.0 + 0.4, 0.7, 1.2, 0.8, 0.08, (230, 228, 220))
        stage.box(s, middle, length * 0.8, width * 0.8, WATER + 2.9, cabin.bake(), plain((150, 140, 120), dice),
                  plain((90, 92, 94), dice, 2.0), low=WATER + 0.9)  # fmt: skip
    elif epoch == "archive":
        for number in range(3):
            load = plain(tinted(dice, (120, 104, 84), 24), dice)
            stage.box(s - 3 + number * 2.6, middle, 2.0, 1.8, WATER + dice.between(1.3, 2.0), load, load, load,
                      low=WATER + 0.9)  # fmt: skip
        mast = plain((90, 74, 58), dice, 0.3)
        stage.box(s + 1, middle, 0.14, 0.14, 6.0, mast, mast, None, low=WATER)
