"""Façades: what a building shows to the path, above and at street level."""

from dataclasses import dataclass

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import WALLS, tinted, toned
from vpr_datasets.simulation.texture import Canvas, Colour

STOREY = 3.4
"""Height of a storey in metres; the ground floor is one storey."""

UPPER_DENSITY = 18.0
STREET_DENSITY = 40.0
"""Texels per metre of the upper storeys, and of the ground floor, which is seen from near."""

ACCENTS: tuple[Colour, ...] = (
    (190, 48, 44), (36, 92, 168), (236, 178, 40), (46, 128, 84), (232, 228, 220), (40, 44, 52),
    (212, 108, 40), (112, 60, 132), (60, 156, 168),
)  # fmt: skip
WORDS = (
    "LIBRARY", "CAFE", "BOOKS", "GYM", "LAW", "PHYSICS", "BLOCK A", "BLOCK C", "BLOCK K", "STUDIO", "CANTEEN",
    "HALL 4", "HALL 7", "NEWS", "BAKERY", "MUSIC", "CLINIC", "BANK", "ARTS", "LAB 12", "LAB 3", "OFFICE",
    "STUDENT UNION", "COPY SHOP", "BIKES", "NOODLES", "ENGINEERING", "POST", "GALLERY", "CHEMISTRY",
)  # fmt: skip


@dataclass(frozen=True)
class Style:
    """What makes a building look like itself on all its sides."""

    material: int
    colour: Colour
    trim: Colour
    glass: Colour
    accent: Colour
    window: str
    bay: float
    share: float
    storeys: int


def draw_style(dice: Dice) -> Style:
    """Draw the look of a building."""
    material = dice.below(len(WALLS))
    colour = tinted(dice, dice.pick(WALLS[material][1]), 14)
    return Style(
        material,
        colour,
        dice.pick(((232, 230, 224), toned(colour, 150), (62, 66, 72), (118, 122, 126))),
        dice.pick(((58, 74, 88), (74, 96, 104), (44, 52, 60), (90, 116, 128))),
        dice.pick(ACCENTS),
        dice.pick(("punched", "ribbon", "curtain", "fins", "balcony", "punched", "tall")),
        dice.pick((1.8, 2.4, 3.0, 3.6, 4.5)),
        dice.between(0.45, 0.8),
        dice.pick((1, 2, 2, 3, 3, 4, 5, 7)),
    )


def _clad(canvas: Canvas, dice: Dice, style: Style) -> None:
    WALLS[style.material][0](canvas, dice)


def _window(
    canvas: Canvas, dice: Dice, style: Style, x: float, y: float, width: float, height: float, *, lit: float
) -> None:
    """Glaze one window; behind some a light is on after dark, or a blind is down."""
    glow = 90 + dice.below(140) if dice.chance(lit) else 8
    glass = tinted(dice, style.glass, 12)
    canvas.rect(x, y, width, height, glass, glow)
    # The upper part of a pane mirrors the sky.
    canvas.rect(x, y + height * 0.55, width, height * 0.45, toned(glass, 330), glow)
    if dice.chance(0.4):
        drop = height * dice.between(0.15, 0.8)
        canvas.rect(x, y + height - drop, width, drop, tinted(dice, (196, 190, 176), 16), max(glow * 3 // 4, 1))
    if width > 1.0:
        for part in range(1, int(width / 0.9) + 1):
            canvas.rect(x + width * part / (int(width / 0.9) + 1) - 0.03, y, 0.06, height, style.trim)
    canvas.frame(x, y, width, height, 0.08, style.trim)


def paint_upper(dice: Dice, style: Style, width: float, lit: float = 0.3) -> Canvas:
    """Paint the storeys above the ground floor, ``width`` metres wide."""
    height = (style.storeys - 1) * STOREY + 0.9
    canvas = Canvas(width, height, UPPER_DENSITY, style.colour)
    _clad(canvas, dice, style)
    bays = max(int(width / style.bay), 1)
    bay = width / bays
    blank = dice.below(bays) if bays > 3 and dice.chance(0.6) else -1
    for storey in range(style.storeys - 1):
        y = storey * STOREY
        if style.window == "ribbon":
            canvas.rect(0, y + 0.9, width, 1.6, style.trim)
        if style.window == "curtain":
            canvas.rect(0, y, width, 0.35, style.trim)
        for number in range(bays):
            if number == blank:
                continue
            x = number * bay
            if style.window == "ribbon":
                _window(canvas, dice, style, x, y + 1.0, bay, 1.4, lit=lit)
            elif style.window == "curtain":
                _window(canvas, dice, style, x, y + 0.35, bay, STOREY - 0.35, lit=lit)
            elif style.window == "tall":
                _window(canvas, dice, style, x + bay * 0.3, y + 0.3, bay * 0.4, 2.6, lit=lit)
            else:
                wide = bay * style.share
                _window(canvas, dice, style, x + (bay - wide) / 2, y + 0.9, wide, 1.7, lit=lit)
            if style.window == "balcony" and number % 2 == storey % 2:
                canvas.rect(x + bay * 0.06, y + 0.15, bay * 0.88, 0.95, toned(style.accent, 220))
                canvas.rect(x + bay * 0.06, y + 0.0, bay * 0.88, 0.16, style.trim)
        if style.window == "fins":
            for number in range(int(STOREY / 0.34)):
                canvas.rect(0, y + number * 0.34, width, 0.13, tinted(dice, style.trim, 8))
    canvas.rect(0, height - 0.5, width, 0.5, style.trim)
    canvas.rect(0, height - 0.58, width, 0.08, toned(style.trim, 120))
    if dice.chance(0.5):
        x = blank * bay if blank >= 0 else dice.between(0, width * 0.6)
        stripe = dice.between(0.6, 1.6)
        canvas.rect(x + bay * 0.2, 0, min(stripe, bay), height - 0.6, style.accent)
    if width > 8 and dice.chance(0.6):
        words = dice.pick(WORDS)
        tall = dice.between(0.7, 1.2)
        x = dice.between(0.5, max(width - len(words) * tall * 0.9, 0.6))
        canvas.rect(x - 0.2, height - 1.1 - tall, len(words) * tall * 0.86, tall + 0.4, toned(style.accent, 230))
        canvas.text(x, height - 0.9 - tall, tall, words, (240, 238, 230))
    return canvas


def _shop(canvas: Canvas, dice: Dice, style: Style, x: float, width: float) -> None:
    """Fill a shop window with things, and put a sign above."""
    canvas.rect(x + 0.15, 0.4, width - 0.3, 2.1, tinted(dice, (104, 98, 88), 20), 150 + dice.below(90))
    for _ in range(int(width * 4)):
        left, low = dice.between(x + 0.2, x + width - 0.7), dice.pick((0.45, 1.0, 1.55))
        colour = tinted(dice, dice.pick(ACCENTS), 20)
        canvas.rect(left, low, dice.between(0.1, 0.5), dice.between(0.15, 0.5), colour, 120 + dice.below(100))
    canvas.frame(x + 0.1, 0.35, width - 0.2, 2.2, 0.09, style.trim)
    board = dice.pick(ACCENTS)
    canvas.rect(x + 0.1, 2.62, width - 0.2, 0.6, board, 60)
    words = dice.pick(WORDS)
    ink = (245, 242, 235) if sum(board) < 420 else (30, 30, 34)
    canvas.text(x + 0.35, 2.72, 0.38, words, ink)


def _door(canvas: Canvas, dice: Dice, style: Style, x: float, width: float) -> None:
    """Put in double doors with a lit transom."""
    middle, half = x + width / 2, min(width * 0.4, 1.1)
    colour = tinted(dice, dice.pick(ACCENTS), 12)
    canvas.rect(middle - half - 0.15, 0, 2 * half + 0.3, 2.8, style.trim)
    canvas.rect(middle - half, 2.2, 2 * half, 0.5, (150, 150, 140), 200)
    canvas.rect(middle - half, 0, half - 0.03, 2.1, colour)
    canvas.rect(middle + 0.03, 0, half - 0.03, 2.1, colour)
    if dice.chance(0.6):
        for left in (middle - half + 0.2, middle + 0.23):
            canvas.rect(left, 0.9, half - 0.45, 1.0, style.glass, 120)
    canvas.rect(middle + half + 0.4, 1.3, 0.35, 0.5, (235, 235, 225), 40)


def _vents(canvas: Canvas, dice: Dice, style: Style, x: float, width: float) -> None:
    """Close an opening with a roller door or a grating."""
    low, high = dice.pick(((0.0, 2.7), (1.6, 2.6), (0.3, 1.3)))
    colour = tinted(dice, (120, 124, 126), 30)
    canvas.rect(x + 0.2, low, width - 0.4, high - low, colour)
    for number in range(int((high - low) / 0.14)):
        canvas.rect(x + 0.2, low + number * 0.14, width - 0.4, 0.06, toned(colour, 150))


def _mural(canvas: Canvas, dice: Dice, style: Style, x: float, width: float) -> None:
    """Cover a wall with a mural."""
    canvas.rect(x + 0.1, 0.3, width - 0.2, 2.8, tinted(dice, dice.pick(ACCENTS), 20))
    for _ in range(7):
        colour = tinted(dice, dice.pick(ACCENTS), 24)
        left, low = dice.between(x + 0.3, x + width - 1.0), dice.between(0.4, 2.0)
        if dice.chance(0.5):
            canvas.rect(left, low, dice.between(0.2, 0.7), dice.between(0.3, 1.0), colour)
        else:
            canvas.disc(min(left + 0.3, x + width - 0.6), low + 0.3, dice.between(0.15, 0.42), colour)


def _posters(canvas: Canvas, dice: Dice, style: Style, x: float, width: float) -> None:
    """Stick bills on a blank wall."""
    for number in range(int((width - 0.4) / 0.75)):
        if dice.chance(0.75):
            left, low = x + 0.25 + number * 0.75, dice.between(1.0, 1.5)
            canvas.rect(left, low, 0.55, 0.8, tinted(dice, (225, 222, 210), 24))
            canvas.rect(left + 0.06, low + 0.35, 0.43, 0.38, tinted(dice, dice.pick(ACCENTS), 20))
            canvas.rect(left + 0.06, low + 0.1, 0.3, 0.08, (60, 60, 60))


def paint_street(dice: Dice, style: Style, width: float) -> Canvas:
    """Paint the ground floor, ``width`` metres wide: doors, shop windows, vents, murals, posters."""
    canvas = Canvas(width, STOREY, STREET_DENSITY, toned(style.colour, 244))
    _clad(canvas, dice, style)
    canvas.rect(0, 0, width, dice.between(0.15, 0.5), toned(style.trim, 200))
    unit = max(style.bay, 2.4)
    units = max(int(width / unit), 1)
    unit = width / units
    fillings = (_shop, _door, _vents, _mural, _posters, _shop)
    previous = -1
    for number in range(units):
        kind = dice.below(len(fillings) + 2)
        kind = (kind + 1) % (len(fillings) + 2) if kind == previous else kind
        previous = kind
        x = number * unit
        if kind < len(fillings):
            fillings[kind](canvas, dice, style, x, unit)
        else:
            _window(canvas, dice, style, x + unit * 0.15, 0.95, unit * 0.7, 1.6, lit=0.5)
        if dice.chance(0.3):
            pipe = x + dice.between(0.0, 0.2)
            canvas.rect(pipe, 0, 0.12, STOREY, toned(style.trim, 170))
    canvas.rect(0, STOREY - 0.14, width, 0.14, toned(style.trim, 190))
    low = np.arange(canvas.ink.shape[0], dtype=np.int16)[:, None]
    # Splashes and shadow near the ground seat the wall on it.
    foot = np.clip(low - (canvas.ink.shape[0] - 16), 0, 16).astype(np.int16)
    canvas.tint(np.broadcast_to(-foot * np.int16(2), canvas.ink.shape).copy())
    return canvas
