"""Things of the street, painted: lights, signs, columns and shelters."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.shops import BOARDS, GOODS, ink_on
from vpr_datasets.simulation.city.words import ADVERTS, STREETS
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.texture import Canvas, Colour

STEEL: Colour = (108, 112, 114)
WHITE: Colour = (238, 238, 232)
RED: Colour = (196, 30, 38)
BLUE: Colour = (26, 74, 150)


def lamp(dice: Dice, tall: float, *, twin: bool = False) -> Canvas:
    """Paint a lamp post, 4.4 m wide: one arm or two, or an old gas light."""
    canvas = Canvas(4.4, tall, 26.0)
    steel = tinted(dice, dice.pick((STEEL, (64, 74, 68), (150, 152, 152))), 8)
    canvas.rect(2.1, 0, 0.2, tall - 0.3, steel)
    canvas.rect(2.05, 0, 0.3, 1.2, toned(steel, 210))
    for way in (-1, 1) if twin else (1,):
        canvas.line(2.2, tall - 0.5, 2.2 + way * 1.5, tall - 0.12, 0.1, steel)
        left = 2.2 + way * 1.1 if way > 0 else 0.3
        canvas.rect(left, tall - 0.22, 0.9, 0.16, (226, 224, 212), 254)
    return canvas


def traffic_light(dice: Dice) -> Canvas:
    """Paint traffic lights on a post, 1.2 m wide and 3.6 m tall."""
    canvas = Canvas(1.2, 3.6, 50.0)
    canvas.rect(0.54, 0, 0.12, 3.6, STEEL)
    canvas.rect(0.43, 2.5, 0.34, 1.0, (24, 26, 26))
    shown = dice.pick((0, 2, 2))
    for number, (dark, bright) in enumerate((((80, 26, 26), (250, 50, 40)), ((84, 66, 24), (250, 190, 50)),
                                             ((24, 70, 48), (60, 230, 140)))):  # fmt: skip
        canvas.disc(0.6, 3.33 - number * 0.32, 0.12, bright if number == shown else dark, 254 if number == shown else 1)
    canvas.rect(0.2, 1.9, 0.26, 0.42, (24, 26, 26))
    canvas.disc(0.33, 2.0, 0.09, (60, 230, 140) if shown == 0 else (240, 60, 50), 200)
    canvas.rect(0.68, 1.1, 0.16, 0.24, (236, 200, 40))
    return canvas


def mast_light() -> Canvas:
    """Paint lights that hang out over the lanes, 5 m wide and 6 m tall, the post on the right."""
    canvas = Canvas(5.0, 6.0, 36.0)
    canvas.rect(4.72, 0, 0.2, 5.8, STEEL)
    canvas.rect(0.4, 5.55, 4.4, 0.14, STEEL)
    for x in (0.4, 4.3):
        low = 4.6 if x < 1 else 2.5
        canvas.rect(x, low, 0.4, 1.1, (24, 26, 26))
        for number, colour in enumerate(((90, 28, 26), (84, 66, 24), (60, 230, 140))):
            canvas.disc(x + 0.2, low + 0.92 - number * 0.35, 0.14, colour, 254 if number == 2 else 1)
    return canvas


def sign(dice: Dice) -> Canvas:
    """Paint a road sign or two on a pole, 1.4 m wide and 3 m tall."""
    canvas = Canvas(1.4, 3.0, 50.0)
    canvas.rect(0.66, 0, 0.08, 3.0, (150, 152, 152))
    y = 2.55
    for _ in range(1 + dice.below(2)):
        kind = dice.below(8)
        if kind <= 1:
            canvas.disc(0.7, y, 0.32, RED)
            canvas.disc(0.7, y, 0.24, BLUE)
            canvas.line(0.5, y + 0.2, 0.9, y - 0.2, 0.07, RED)
        elif kind == 2:
            canvas.disc(0.7, y, 0.34, RED)
            canvas.disc(0.7, y, 0.26, WHITE)
            canvas.text(0.5, y - 0.12, 0.24, dice.pick(("30", "50")), (24, 24, 26))
        elif kind == 3:
            canvas.polygon([(0.3, y), (0.7, y - 0.4), (1.1, y), (0.7, y + 0.4)], WHITE)
            canvas.polygon([(0.4, y), (0.7, y - 0.3), (1.0, y), (0.7, y + 0.3)], (244, 200, 40))
        elif kind == 4:
            canvas.rect(0.38, y - 0.32, 0.64, 0.64, BLUE)
            canvas.text(0.56, y - 0.2, 0.4, "P", WHITE)
        elif kind == 5:
            canvas.polygon([(0.3, y + 0.3), (1.1, y + 0.3), (0.7, y - 0.4)], RED)
            canvas.polygon([(0.42, y + 0.23), (0.98, y + 0.23), (0.7, y - 0.24)], WHITE)
        elif kind == 6:
            canvas.disc(0.7, y, 0.34, BLUE)
            canvas.line(0.7, y - 0.24, 0.7, y + 0.16, 0.08, WHITE)
            canvas.polygon([(0.5, y + 0.06), (0.9, y + 0.06), (0.7, y + 0.28)], WHITE)
        else:
            canvas.rect(0.05, y - 0.2, 1.3, 0.42, (244, 200, 40))
            canvas.text(0.15, y - 0.09, 0.2, dice.pick(("ZENTRUM", "MESSE", "ZOO", "TEGEL")), (24, 24, 26))
        y -= 0.82
    return canvas


def name_sign(dice: Dice) -> Canvas:
    """Paint the name of a side street on a post, 2.2 m wide and 3 m tall."""
    canvas = Canvas(2.2, 3.0, 50.0)
    canvas.rect(0.1, 0, 0.09, 3.0, STEEL)
    canvas.rect(0.1, 2.6, 2.1, 0.36, WHITE)
    canvas.frame(0.1, 2.6, 2.1, 0.36, 0.03, (40, 40, 42))
    canvas.text(0.2, 2.68, 0.19, dice.pick(STREETS), (24, 24, 26))
    return canvas


def poster(dice: Dice, width: float, high: float, density: float = 44.0) -> Canvas:
    """Paint one advertisement."""
    ground = tinted(dice, dice.pick((*BOARDS, *GOODS)), 20)
    canvas = Canvas(width, high, density, ground)
    canvas.disc(
        width * dice.between(0.3, 0.7),
        high * dice.between(0.5, 0.7),
        min(width, high) * dice.between(0.18, 0.32),
        tinted(dice, dice.pick(GOODS), 20),
    )
    canvas.rect(width * dice.between(0, 0.5), high * dice.between(0.2, 0.6), width * 0.4, high * dice.between(0.1, 0.3),
                tinted(dice, dice.pick(GOODS), 20))  # fmt: skip
    word = dice.pick(ADVERTS)
    canvas.text(width * 0.07, high * 0.06, min(high * 0.14, width / len(word) * 1.1), word, ink_on(ground))
    canvas.frame(0, 0, width, high, 0.04, (230, 228, 222))
    canvas.ink[:] = 60
    return canvas


def column(dice: Dice) -> Canvas:
    """Paint an advertising column, 1.5 m wide and 3.7 m tall, round by its shading."""
    canvas = Canvas(1.5, 3.7, 44.0)
    canvas.rect(0.06, 0, 1.38, 3.2, (150, 146, 138))
    for y, high in ((0.5, 1.3), (1.85, 1.3)):
        x = 0.08
        while x < 1.2:
            wide = min(dice.between(0.4, 0.9), 1.42 - x)
            one = poster(dice, wide, high)
            rows, columns = canvas.area(x, y, wide, high)
            patch = canvas.rgb[rows, columns][: one.rgb.shape[0], : one.rgb.shape[1]]
            patch[:] = one.rgb[: patch.shape[0], : patch.shape[1]]
            x += wide
    canvas.rect(0, 3.2, 1.5, 0.16, (70, 84, 76))
    canvas.polygon([(0.1, 3.36), (1.4, 3.36), (0.9, 3.65), (0.6, 3.65)], (84, 100, 90))
    columns = canvas.ink.shape[1]
    # The edges of a cylinder turn away from the light.
    for number in range(columns):
        away = abs(2 * number - columns) * 100 // columns
        canvas.rgb[:, number] = (canvas.rgb[:, number].astype("uint16") * (256 - away * away // 90) >> 8).astype(
            "uint8"
        )
    return canvas


def underground(dice: Dice) -> Canvas:
    """Paint the blue sign of an underground station on its post, 1 m wide and 3.6 m tall."""
    canvas = Canvas(1.0, 3.6, 50.0)
    canvas.rect(0.45, 0, 0.1, 2.7, STEEL)
    canvas.rect(0.05, 2.65, 0.9, 0.9, BLUE, 160)
    for area in ((0.24, 2.85, 0.14, 0.55), (0.62, 2.85, 0.14, 0.55), (0.3, 2.78, 0.4, 0.14)):
        canvas.rect(*area, WHITE, 220)
    return canvas


def stop_post() -> Canvas:
    """Paint the yellow and green H of a bus stop, 0.9 m wide and 3 m tall."""
    canvas = Canvas(0.9, 3.0, 50.0)
    canvas.rect(0.4, 0, 0.08, 2.9, STEEL)
    canvas.disc(0.45, 2.6, 0.36, (30, 120, 60))
    canvas.disc(0.45, 2.6, 0.29, (244, 206, 50))
    canvas.text(0.31, 2.45, 0.32, "H", (30, 120, 60))
    canvas.rect(0.2, 1.2, 0.5, 0.75, WHITE)
    for number in range(6):
        canvas.rect(0.26, 1.3 + number * 0.1, 0.36, 0.04, (90, 90, 92))
    return canvas


def switch_box(dice: Dice, width: float, high: float) -> Canvas:
    """Paint a grey box with stickers and scrawls."""
    canvas = Canvas(width, high, 44.0, tinted(dice, (150, 150, 142), 12))
    canvas.frame(0, 0, width, high, 0.04, (110, 110, 104))
    for _ in range(5):
        canvas.rect(
            dice.between(0.05, width - 0.2),
            dice.between(0.2, high - 0.2),
            0.14,
            0.12,
            tinted(dice, dice.pick(GOODS), 20),
        )
    x, y, colour = 0.1, high * 0.5, dice.pick(((30, 40, 120), (150, 30, 60), (30, 30, 32)))
    for _ in range(8):
        left, up = min(x + dice.between(0.0, 0.25), width), min(max(y + dice.between(-0.3, 0.3), 0.1), high)
        canvas.line(x, y, left, up, 0.05, colour)
        x, y = left, up
    return canvas
