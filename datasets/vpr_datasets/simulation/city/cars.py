"""Cars and vans."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.vehicles import (
    DENSITY,
    GLASS,
    PAINTS,
    RUBBER,
    YELLOW,
    Vehicle,
    block,
    ends_of,
    plate,
    shadow,
    wheel,
)
from vpr_datasets.simulation.city.words import ADVERTS
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.texture import Canvas


def car(dice: Dice) -> Vehicle:
    """Draw a car: a saloon, an estate or a small one."""
    colour = tinted(dice, dice.pick(PAINTS), 10)
    kind = dice.below(4)
    length, width = (4.5, 1.8) if kind <= 1 else (3.8, 1.7) if kind == 2 else (4.6, 1.9)
    sill, belt = 0.26, 0.9 if kind < 3 else 1.05
    high = belt + (0.54 if kind < 3 else 0.66)
    front, rear = length * 0.2, -length * (0.3 if kind == 0 else 0.46)
    flank = Canvas(length, belt, DENSITY)
    flank.polygon([(0.0, sill), (length, sill), (length, belt - 0.2), (length * 0.72, belt), (0.0, belt)], colour)
    flank.rect(0.0, belt - 0.1, length * 0.98, 0.06, toned(colour, 285))
    flank.rect(0.0, sill, length, 0.12, toned(colour, 120))
    for x in (length * 0.38, length * 0.6):
        flank.rect(x, sill + 0.1, 0.02, belt - sill - 0.1, toned(colour, 140))
        flank.rect(x - 0.3, belt - 0.2, 0.2, 0.04, toned(colour, 150))
    for x in (length * 0.19, length * 0.81):
        flank.disc(x, 0.33, 0.4, (22, 22, 24))
        wheel(flank, x, 0.32)
    span, inset = front - rear, 0.12
    cabin = Canvas(span, high - belt, DENSITY)
    lean, tail = 0.75, 0.5 if kind != 1 else 0.2
    tall = high - belt
    cabin.polygon([(0, 0), (span, 0), (span - lean, tall), (tail, tall)], toned(colour, 240))
    cabin.polygon(
        [(0.2, 0.04), (span - 0.28, 0.04), (span - lean - 0.05, tall - 0.08), (tail + 0.1, tall - 0.08)], GLASS
    )
    cabin.polygon([(span * 0.5, 0.04), (span - 0.28, 0.04), (span - lean - 0.05, tall - 0.08),
                   (span * 0.5, tall - 0.08)], (58, 68, 78))  # fmt: skip
    for x in (span * 0.3, span * 0.52):
        cabin.rect(x, 0, 0.08, tall, toned(colour, 170))
    screens = []
    for _ in range(2):
        screen = Canvas(width - 2 * inset, tall, DENSITY, toned(colour, 235))
        screen.rect(0.08, 0.03, screen.width - 0.16, tall - 0.1, GLASS)
        screen.polygon([(0.1, 0.05), (0.7, 0.05), (1.0, tall - 0.1), (0.6, tall - 0.1)], (86, 98, 108))
        screens.append(screen)
    bonnet = Canvas(length, width, 14.0, toned(colour, 250))
    bonnet.speckle(dice, 10)
    bonnet.rect(length * 0.74, 0.1, 0.06, width - 0.2, toned(colour, 150))
    roof = Canvas(span - lean - tail, width - 2 * inset, 14.0, toned(colour, 245))
    # The ends of the cabin stand where the screens lean most, half way up.
    return Vehicle(length, width, high, (
        block(-length / 2, length / 2, 0.0, 0.0, belt, flank, *ends_of(width, sill, belt, colour), bonnet),
        block(rear, front, inset, belt, high, cabin, None, None, None),
        block(rear + tail * 0.6, front - lean * 0.6, inset + 0.02, belt, high, None, screens[0], screens[1],
               roof),
    ), shadow())  # fmt: skip


def van(dice: Dice) -> Vehicle:
    """Draw a delivery van with a firm's name on it."""
    colour = tinted(
        dice, dice.pick(((232, 232, 230), (232, 232, 230), (196, 198, 200), YELLOW, (40, 60, 110), (120, 124, 128))), 6
    )
    length, width, high, nose = dice.between(4.8, 5.9), 2.0, dice.between(1.95, 2.6), 0.9
    flank = Canvas(length - nose, high, DENSITY)
    flank.rect(0, 0.3, length, high - 0.3, colour)
    flank.rect(0, 0.3, length, 0.2, (60, 60, 62))
    flank.polygon(
        [
            (length - nose - 1.0, 1.15),
            (length - nose, 1.15),
            (length - nose - 0.4, high - 0.25),
            (length - nose - 1.0, high - 0.25),
        ],
        GLASS,
    )
    flank.rect(length - nose - 1.1, 0.4, 0.03, high - 0.5, toned(colour, 170))
    firm = 0.5, high * 0.55, 0.34, dice.pick(ADVERTS), dice.pick(((180, 40, 40), (30, 70, 150), (40, 44, 48)))
    flank.rect(0.5, high * 0.46, dice.between(1.0, 2.4), 0.06, dice.pick(((180, 40, 40), (30, 70, 150))))
    wheel(flank, 0.9, 0.36)
    back = Canvas(width, high, DENSITY)
    for x in (0.1, width - 0.4):
        back.rect(x, 0, 0.3, 0.4, RUBBER)
    back.rect(0, 0.3, width, high - 0.3, colour)
    back.rect(width / 2 - 0.02, 0.4, 0.04, high - 0.5, toned(colour, 150))
    for x in (0.14, width / 2 + 0.1):
        back.rect(x, 1.2, width / 2 - 0.26, 0.5, GLASS)
    for x in (0.02, width - 0.16):
        back.rect(x, 0.8, 0.14, 0.4, (186, 30, 30), 150)
    plate(back, 0.5, width)
    face = Canvas(width, high, DENSITY, colour)
    face.rect(0.1, 1.15, width - 0.2, high - 1.45, GLASS)
    nosed = Canvas(nose, 1.15, DENSITY)
    nosed.polygon([(0, 0.3), (nose, 0.3), (nose, 0.85), (0, 1.15)], colour)
    wheel(nosed, 0.3, 0.36)
    lid = Canvas(length - nose, width, 12.0, toned(colour, 250))
    lid.frame(0, 0, length - nose, width, 0.1, toned(colour, 200))
    hood = Canvas(nose, width, 12.0, toned(colour, 240))
    return Vehicle(length, width, high, (
        block(-length / 2, length / 2 - nose, 0.0, 0.0, high, flank, back, face, lid, firm),
        block(length / 2 - nose, length / 2, 0.05, 0.0, 0.98, nosed, None, ends_of(width, 0.3, 0.98, colour)[1], hood),
    ), shadow())  # fmt: skip
