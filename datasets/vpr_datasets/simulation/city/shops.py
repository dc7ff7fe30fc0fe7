"""Ground floors: shop windows under signs and awnings, portals, gateways."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.windows import glaze, sash, surround
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import WOOD, plaster, tile, tinted, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour

BOARDS: tuple[Colour, ...] = (
    (178, 34, 38), (28, 70, 140), (236, 196, 40), (30, 104, 66), (236, 234, 228), (30, 32, 36), (214, 110, 40),
    (110, 40, 90), (40, 130, 150), (96, 60, 40), (222, 214, 190), (60, 70, 80),
)  # fmt: skip
GOODS: tuple[Colour, ...] = (
    (200, 60, 50), (60, 110, 170), (230, 190, 70), (240, 238, 230), (70, 130, 90), (50, 50, 56), (210, 140, 160),
    (150, 110, 70),
)  # fmt: skip

DENSITY = 36.0


def ink_on(board: Colour) -> Colour:
    """Return a colour that can be read on a board."""
    return (245, 242, 235) if sum(board) < 440 else (34, 34, 40)


def paint_ground_floor(
    dice: Dice, old: bool, colour: Colour, trim: Colour, width: float, high: float, words: tuple[str, ...]
) -> Canvas:
    """Paint the ground floor of a house, ``width`` metres wide."""
    base = toned(colour, 230) if old else tinted(dice, dice.pick(((120, 116, 110), (70, 72, 76), (186, 180, 168))), 12)
    canvas = Canvas(width, high, DENSITY, base)
    if old:
        plaster(canvas, dice)
        for number in range(int(high / 0.45)):
            canvas.rect(0, number * 0.45, width, 0.04, toned(base, 190))
    else:
        tile(canvas, dice)
    canvas.rect(0, 0, width, dice.between(0.3, 0.8), toned(base, 160))
    x, entrance = 0.4, False
    while x + 2.2 < width:
        room = min(dice.between(2.6, 5.5), width - x - 0.3)
        if room > width - x - 2.2:
            room = width - x - 0.3
        kind = dice.below(10)
        if not entrance and (kind >= 8 or x + room + 3 > width):
            entrance = True
            room = min(room, 2.6)
            _portal(canvas, dice, x, room, high, trim, old)
        elif kind <= 6:
            _shop(canvas, dice, x, room, high, words)
        else:
            _flat(canvas, dice, x, room, trim)
        x += room + dice.between(0.25, 0.7)
    canvas.rect(0, high - 0.3, width, 0.3, trim)
    canvas.rect(0, high - 0.36, width, 0.06, toned(base, 140))
    canvas.rect(0, 0, width, 0.06, toned(base, 110))
    return canvas


def _shop(canvas: Canvas, dice: Dice, x: float, width: float, high: float, words: tuple[str, ...]) -> None:
    frame = dice.pick(((40, 42, 46), (226, 224, 218), (110, 80, 54), (150, 152, 154), (60, 40, 34)))
    low, top = dice.between(0.2, 0.7), high - 1.05
    canvas.rect(x, low, width, top - low, tinted(dice, (74, 72, 70), 16), 120 + dice.below(100))
    shelf = dice.between(0.3, 0.7)
    for _ in range(int(width * 5)):
        left, y = dice.between(x + 0.1, x + width - 0.5), low + dice.pick((0.1, 0.1, 0.1 + shelf, 0.1 + 2 * shelf))
        canvas.rect(left, y, dice.between(0.1, 0.4), dice.between(0.15, shelf), tinted(dice, dice.pick(GOODS), 22),
                    110 + dice.below(110))  # fmt: skip
    # Glass mirrors the houses opposite.
    for _ in range(2):
        left = dice.between(x, x + width - 0.3)
        area = canvas.area(left, low, dice.between(0.3, 1.0), top - low)
        canvas.rgb[area] = (canvas.rgb[area] >> 1) + 76
    door = x + dice.between(0.2, 0.7) * (width - 1.0)
    canvas.rect(door, 0, 1.0, top, frame)
    glaze(canvas, dice, door + 0.1, 0.25, 0.8, top - 0.4, frame, lit=0.9)
    for number in range(int(width / 1.7) + 1):
        canvas.rect(min(x + number * 1.7, x + width - 0.07), low, 0.07, top - low, frame)
    canvas.frame(x, low, width, top - low, 0.08, frame)
    board = tinted(dice, dice.pick(BOARDS), 8)
    canvas.rect(x - 0.1, top + 0.06, width + 0.2, 0.62, board, 70)
    canvas.rect(x - 0.1, top + 0.03, width + 0.2, 0.05, toned(board, 150))
    name = dice.pick(words)
    tall = min(0.4, width / max(len(name), 3) * 1.05)
    canvas.text(x + 0.15, top + 0.17, tall, name, ink_on(board))


def _portal(canvas: Canvas, dice: Dice, x: float, width: float, high: float, trim: Colour, old: bool) -> None:
    """Let people in."""
    middle, half, top = x + width / 2, min(width * 0.36, 0.85), high - 1.2
    surround(canvas, middle - half, 0.0, 2 * half, top, trim if old else toned(trim, 180), "arch" if old else "flat")
    wood = tinted(dice, dice.pick((*WOOD, (60, 70, 60), (50, 52, 60))), 16)
    canvas.rect(middle - half, 0, 2 * half, top, wood)
    canvas.rect(middle - half + 0.08, top - 0.6, 2 * half - 0.16, 0.5, (84, 92, 92), 150)
    for left in (middle - half + 0.1, middle + 0.08):
        canvas.frame(left, 0.2, half - 0.2, top - 1.0, 0.07, toned(wood, 190))
        canvas.rect(left + 0.15, 1.2, half - 0.5, 0.8, (70, 76, 78), 90)
    canvas.rect(middle - 0.02, 0, 0.04, top - 0.6, toned(wood, 120))
    canvas.rect(middle + half + 0.25, 1.9, 0.28, 0.34, (40, 70, 140))


def _flat(canvas: Canvas, dice: Dice, x: float, width: float, trim: Colour) -> None:
    """Leave windows of a flat, with a sprayed word below."""
    for number in range(max(int(width / 2.0), 1)):
        left = x + number * 2.0 + 0.3
        surround(canvas, left, 1.3, 1.2, 1.7, trim, "stone")
        sash(canvas, dice, left, 1.3, 1.2, 1.7, (230, 228, 222))
    if dice.chance(0.4):
        colour = dice.pick(((40, 60, 150), (170, 40, 60), (30, 30, 34), (60, 140, 80)))
        left, y = x + dice.between(0.1, 0.6), 0.6
        for _ in range(9):
            right, up = left + dice.between(0.05, 0.35), min(max(y + dice.between(-0.4, 0.4), 0.35), 1.0)
            canvas.line(left, y, right, up, 0.07, colour)
            left, y = right, up


def put_fronts(stage: Stage, dice: Dice, side: int, s: float, width: float, t: float, words: tuple[str, ...]) -> None:
    """Hang awnings and signs out over the pavement."""
    if width > 7 and dice.chance(0.5):
        start, long = s + dice.between(0.3, width * 0.3), dice.between(3.0, width * 0.6)
        reach, colour = dice.between(0.9, 1.7), tinted(dice, dice.pick(BOARDS), 10)
        cloth = Canvas(long, 0.8, 34.0, colour)
        if dice.chance(0.5):
            for number in range(int(long / 0.6)):
                cloth.rect(number * 0.6, 0.22, 0.3, 0.6, (236, 232, 224))
        cloth.rect(0, 0.2, long, 0.04, toned(colour, 170))
        cloth.text(0.3, 0.02, 0.17, dice.pick(words), ink_on(colour))
        wall_along(stage, side, start, start + long, t - reach, 2.35, 3.15, cloth.bake())
        cover = plain(toned(colour, 170), dice)
        wall_across(stage, start, t - reach, reach, 2.55, 3.15, cover, side)
        stage.slab(start, t - reach if side > 0 else -t, long, reach, 2.6, cover, roof=True)
        stage.slab(start, t - reach if side > 0 else -t, long, reach, 3.14, plain(toned(colour, 240), dice))
    for _ in range(1 + int(width / 9)):
        if dice.chance(0.6):
            _hang_sign(stage, dice, side, s + dice.between(0.6, width - 0.6), t, words)


def _hang_sign(stage: Stage, dice: Dice, side: int, s: float, t: float, words: tuple[str, ...]) -> None:
    """Let a lit box stick out of the wall."""
    width, high, low = dice.between(0.7, 1.1), dice.pick((0.7, 0.9, 2.6)), dice.between(3.0, 4.2)
    colour = tinted(dice, dice.pick(BOARDS), 8)
    canvas = Canvas(width, high, 48.0, colour)
    canvas.frame(0, 0, width, high, 0.05, toned(colour, 170))
    name = dice.pick(words)
    if high > 2:
        for number, letter in enumerate(name[:7]):
            canvas.text(width * 0.34, high - 0.4 - number * 0.34, 0.26, letter, ink_on(colour))
    else:
        canvas.disc(width / 2, high * 0.62, width * 0.24, tinted(dice, (226, 222, 212), 20))
        canvas.text(0.08, 0.1, 0.2, name[:5], ink_on(colour))
    canvas.ink[:] = 110
    wall_across(stage, s, t - width - 0.1, width, low, low + high, canvas.bake(), side)
    post = plain((60, 62, 64), dice, 0.2)
    wall_across(stage, s, t - 0.1, 0.1, low + high * 0.3, low + high * 0.4, post, side)
