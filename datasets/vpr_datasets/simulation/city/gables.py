"""Outlines of the gables of Amsterdam's houses, and the tops that they are painted on."""

from itertools import pairwise

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import toned
from vpr_datasets.simulation.texture import Canvas, Colour

STONE: Colour = (224, 218, 204)

HEIGHTS = {"step": 0.72, "neck": 0.78, "bell": 0.74, "spout": 0.62, "cornice": 0.16}
"""Height of each kind of gable as a share of the house's width."""

Outline = list[tuple[float, float]]


def outline(kind: str, width: float, high: float) -> Outline:
    """Return the right half of a gable from its foot to its top, and mirror it to the left."""
    half = width / 2
    if kind == "step":
        right = [(half, 0.0)]
        for number in range(4):
            x, y = half * (1 - number / 4), high * (number + 0.7) / 4.2
            right += [(x, y), (half * (1 - (number + 1) / 4) + 0.1, y)]
        right.append((0.14 * half, high))
    elif kind == "neck":
        right = [
            (half, 0.0),
            (half, 0.08 * high),
            (0.8 * half, 0.14 * high),
            (0.62 * half, 0.28 * high),
            (0.5 * half, 0.46 * high),
            (0.46 * half, 0.8 * high),
            (0.56 * half, 0.82 * high),
            (0.0, high),
        ]
    elif kind == "bell":
        right = [
            (half, 0.0),
            (half, 0.06 * high),
            (0.78 * half, 0.16 * high),
            (0.6 * half, 0.36 * high),
            (0.5 * half, 0.6 * high),
            (0.46 * half, 0.78 * high),
            (0.34 * half, 0.92 * high),
            (0.0, high),
        ]
    elif kind == "spout":
        right = [(half, 0.0), (half, 0.06 * high), (0.2 * half, 0.86 * high), (0.2 * half, high)]
    else:
        right = [(half, 0.0), (half, high)]
    points = [(half + x, y) for x, y in right]
    return points + [(width - x, y) for x, y in reversed(points)]


def paint_gable(canvas: Canvas, dice: Dice, kind: str, foot: float, colour: Colour) -> None:
    """Cut the top of a canvas, from ``foot`` metres up, to the shape of a gable, and trim its edge with stone."""
    width, high = canvas.width, canvas.height - foot
    points = outline(kind, width, high)
    top = Canvas(width, high, canvas.density)
    top.polygon(points, colour)
    rows = top.ink.shape[0]
    canvas.ink[:rows][top.ink == 0] = 0
    if kind == "cornice":
        canvas.rect(0, foot, width, high, STONE)
        canvas.rect(0, foot + high * 0.3, width, 0.08, toned(STONE, 170))
        canvas.rect(0, foot - 0.1, width, 0.1, toned(colour, 130))
        for number in range(int(width / 0.7)):
            canvas.rect(0.2 + number * 0.7, foot + high * 0.38, 0.22, high * 0.34, toned(STONE, 190))
        return
    bar = 0.16
    for (x0, y0), (x1, y1) in pairwise(points):
        inset0, inset1 = min(max(x0, 0.08), width - 0.08), min(max(x1, 0.08), width - 0.08)
        canvas.line(inset0, foot + y0 - 0.06, inset1, foot + y1 - 0.06, bar, STONE)
    if kind in ("neck", "bell"):
        canvas.rect(width * 0.34, foot + high * 0.76, width * 0.32, 0.14, STONE)
        for x in (0.2, 0.8):
            canvas.disc(width * x, foot + high * 0.16, width * 0.06, STONE)
            canvas.disc(width * x, foot + high * 0.16, width * 0.025, toned(STONE, 170))
    # The attic's hatch, and the beam by which furniture is hoisted.
    canvas.rect(width / 2 - 0.5, foot + high * 0.2, 1.0, 1.5, STONE)
    canvas.rect(width / 2 - 0.4, foot + high * 0.2, 0.8, 1.4, dice.pick(((50, 70, 56), (90, 40, 36), (54, 60, 66))))
    canvas.rect(width / 2 - 0.08, foot + high * 0.2 + 1.6, 0.16, 0.22, (40, 36, 34))
