"""Trees, palms, shrubs, grasses and hedges."""

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.texture import SURFACE, Canvas, Colour

LEAVES: dict[Season, tuple[Colour, ...]] = {
    "spring": ((124, 164, 70), (146, 178, 84), (222, 190, 200), (104, 150, 66)),
    "summer": ((72, 110, 46), (90, 126, 52), (58, 94, 50), (104, 132, 60)),
    "autumn": ((190, 116, 40), (168, 72, 36), (206, 160, 56), (128, 110, 52)),
    "winter": ((96, 84, 70), (84, 78, 70), (110, 96, 80), (74, 84, 62)),
}
EVERGREEN: tuple[Colour, ...] = ((64, 98, 48), (84, 116, 56), (52, 84, 52))
BARK: tuple[Colour, ...] = ((104, 86, 68), (84, 70, 58), (134, 118, 98), (70, 62, 56))


def roughen(canvas: Canvas, dice: Dice, cell: float, keep: int) -> None:
    """Eat holes into what is painted wherever noise exceeds ``keep``."""
    size = max(int(cell * canvas.density), 2)
    rows, columns = canvas.ink.shape
    canvas.ink[value_noise(dice, rows, columns, size, 2) > keep] = 0


def crown(
    canvas: Canvas, dice: Dice, leaf: Colour, box: tuple[float, float, float, float], clumps: int, size: float
) -> None:
    """Heap clumps of leaves in the ellipse of a box (x, y, width, height): dark below, light on top."""
    x, y, width, height = box
    spots: list[tuple[float, float]] = []
    while len(spots) < clumps:
        u, v = dice.between(-1, 1), dice.between(-1, 1)
        if u * u + v * v <= 1:
            spots.append((v, u))
    for v, u in sorted(spots):
        tone = 130 + int((v + 1) * 62) + dice.below(40)
        radius = size * dice.between(0.6, 1.2)
        canvas.disc(x + width * (u + 1) / 2, y + height * (v + 1) / 2, radius, toned(tinted(dice, leaf, 8), tone))


def tree(dice: Dice, season: Season) -> Canvas:
    """Paint a broad-leaved tree, 6 m wide and 8 m tall; a bare one in winter."""
    canvas = Canvas(6.0, 8.0, 36.0)
    leaf, bark = dice.pick(LEAVES[season]), tinted(dice, dice.pick(BARK), 10)
    bottom = dice.between(2.2, 3.4)
    for _ in range(9 if season != "winter" else 40):
        canvas.line(3.0, dice.between(1.8, bottom + 0.8), dice.between(0.8, 5.2), dice.between(4.0, 7.4), 0.07, bark)
    if season != "winter":
        crown(canvas, dice, leaf, (0.7, bottom, 4.6, 7.5 - bottom), 150, 0.46)
        roughen(canvas, dice, 0.36, 150)
        canvas.speckle(dice, 60, 0.16)
    lean = dice.between(-0.3, 0.3)
    foot = dice.between(0.16, 0.3)
    canvas.polygon([(3 - foot + lean, 0), (3 + foot + lean, 0), (3 + foot * 0.5, 4.2), (3 - foot * 0.5, 4.2)], bark)
    canvas.speckle(dice, 24)
    return canvas


def palm(dice: Dice, season: Season) -> Canvas:
    """Paint a palm, 5 m wide and 8 m tall."""
    canvas = Canvas(5.0, 8.0, 36.0)
    bark, leaf = tinted(dice, dice.pick(BARK), 10), tinted(dice, dice.pick(EVERGREEN), 10)
    top = dice.between(4.8, 6.2)
    lean = dice.between(-0.5, 0.5)
    canvas.polygon([(2.35 + lean, 0), (2.65 + lean, 0), (2.6, top), (2.4, top)], bark)
    for number in range(22):
        reach = dice.between(1.3, 2.4) * (1 if number % 2 else -1)
        rise, fall = dice.between(0.3, 1.7), dice.between(0.4, 2.6)
        colour = toned(leaf, 150 + dice.below(130))
        last = (2.5, top)
        for part in range(1, 8):
            share = part / 7
            point = (2.5 + reach * share, top + rise * share * 1.6 - (rise * 0.6 + fall) * share * share)
            canvas.line(*last, *point, 0.06, colour)
            for side in (0.5, -0.35):
                canvas.line(*point, point[0] + reach * 0.08, point[1] - side, 0.04, colour)
            last = point
    canvas.speckle(dice, 20)
    return canvas


def shrub(dice: Dice, season: Season) -> Canvas:
    """Paint a round shrub, 2.4 m wide and 1.6 m tall."""
    canvas = Canvas(2.4, 1.6, 60.0)
    leaf = dice.pick(LEAVES[season] if dice.chance(0.4) else EVERGREEN)
    crown(canvas, dice, leaf, (0.35, 0.1, 1.7, dice.between(0.7, 1.2)), 60, 0.24)
    if dice.chance(0.3) and season in ("spring", "summer"):
        bloom = dice.pick(((220, 90, 110), (240, 220, 120), (230, 230, 240), (170, 100, 190)))
        for _ in range(30):
            canvas.disc(dice.between(0.4, 2.0), dice.between(0.3, 1.1), 0.035, bloom)
    roughen(canvas, dice, 0.2, 165)
    canvas.speckle(dice, 50, 0.07)
    return canvas


def grasses(dice: Dice, season: Season) -> Canvas:
    """Paint a tuft of long blades, 2 m wide and 1.4 m tall."""
    canvas = Canvas(2.0, 1.4, 60.0)
    leaf = dice.pick(EVERGREEN if season in ("spring", "summer") else LEAVES[season])
    leaf = toned(leaf, 300)
    for _ in range(90):
        foot, lean = dice.between(0.7, 1.3), dice.between(-0.9, 0.9)
        tall = dice.between(0.5, 1.1)
        colour = toned(leaf, 120 + dice.below(150))
        canvas.line(foot, 0, foot + lean * 0.35, tall, 0.035, colour)
        canvas.line(foot + lean * 0.35, tall, foot + lean * 0.75, tall * 0.85, 0.025, colour)
    return canvas


def hedge(dice: Dice, season: Season, length: float, height: float) -> Canvas:
    """Paint the side of a hedge with a ragged top edge."""
    canvas = Canvas(length, height, 40.0, dice.pick(EVERGREEN))
    canvas.speckle(dice, 70, 0.12)
    canvas.speckle(dice, 50, 0.6)
    rows, columns = canvas.ink.shape
    ragged = value_noise(dice, 1, columns, 8, 3)[0].astype(np.int64) * rows // 1600
    canvas.ink[np.arange(rows)[:, None] < ragged[None]] = 0
    return canvas


def vines(dice: Dice, season: Season, length: float, height: float) -> Canvas:
    """Paint a wire fence overgrown with climbers; see-through in places."""
    canvas = Canvas(length, height, 40.0)
    post = (96, 104, 104)
    for number in range(int(length / 0.16) + 1):
        canvas.rect(number * 0.16, 0, 0.03, height, post)
    for number in range(int(height / 0.16) + 1):
        canvas.rect(0, number * 0.16, length, 0.03, post)
    for number in range(int(length / 2.4) + 1):
        canvas.rect(min(number * 2.4, length - 0.1), 0, 0.1, height, post)
    canvas.rect(0, height - 0.08, length, 0.08, post)
    rows, columns = canvas.ink.shape
    growth = value_noise(dice, rows, columns, 50, 4) > 134
    leaf = dice.pick(LEAVES[season])
    canvas.rgb[growth] = leaf
    canvas.ink[growth] = SURFACE
    canvas.speckle(dice, 60, 0.12)
    return canvas
