"""Cars, vans, lorries and buses with all their sides, so that they look right from a car, a bicycle and a bus."""

from dataclasses import dataclass

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.words import ADVERTS
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

PAINTS: tuple[Colour, ...] = (
    (38, 40, 44), (60, 62, 66), (150, 152, 156), (196, 198, 200), (226, 226, 224), (110, 114, 120), (34, 52, 96),
    (150, 30, 34), (226, 226, 224), (44, 84, 60), (40, 84, 140), (190, 160, 120), (28, 28, 30), (90, 30, 36),
)  # fmt: skip
GLASS: Colour = (46, 54, 62)
RUBBER: Colour = (26, 26, 28)
YELLOW: Colour = (240, 202, 40)
"""Of Berlin's buses."""

DENSITY = 42.0


@dataclass(frozen=True)
class Block:
    """A box that is part of a vehicle, open where it has no texture.

    Lengths are in metres, ``rear`` and ``front`` from the vehicle's middle.
    """

    rear: float
    front: float
    inset: float
    low: float
    high: float
    flank: Texture | None
    mirrored: Texture | None
    back: Texture | None
    face: Texture | None
    lid: Texture | None


@dataclass(frozen=True)
class Vehicle:
    """A vehicle of so many blocks."""

    length: float
    width: float
    height: float
    blocks: tuple[Block, ...]
    shadow: Texture

    def put(self, stage: Stage, s: float, t: float, *, onward: bool = True) -> None:
        """Put it at a place; ``onward`` is facing along the path."""
        way = 1.0 if onward else -1.0
        for block in self.blocks:
            half = self.width / 2 - block.inset
            near, far = sorted((s + way * block.rear, s + way * block.front))
            right, left = t - half, t + half
            first, second = (block.flank, block.mirrored) if onward else (block.mirrored, block.flank)
            ends = (block.back, block.face) if onward else (block.face, block.back)
            sides = (((near, right), (far, right), first), ((far, left), (near, left), second),
                     ((near, left), (near, right), ends[0]), ((far, right), (far, left), ends[1]))  # fmt: skip
            for start, stop, texture in sides:
                if texture is not None:
                    stage.wall(start, stop, block.low, block.high, texture)
            if block.lid is not None:
                stage.slab(near, right, far - near, 2 * half, block.high, block.lid)
        # What it stands on is dark: without it, it would seem to float.
        stage.slab(s - self.length / 2 - 0.1, t - self.width / 2 - 0.12, self.length + 0.2, self.width + 0.24, 0.016,
                   self.shadow)  # fmt: skip


def _block(
    rear: float,
    front: float,
    inset: float,
    low: float,
    high: float,
    flank: Canvas | None,
    back: Canvas | None,
    face: Canvas | None,
    lid: Canvas | None,
    lettering: tuple[float, float, float, str, Colour] | None = None,
) -> Block:
    mirrored = None
    if flank is not None:
        mirrored = Canvas(flank.width, flank.height, flank.density)
        mirrored.rgb[:], mirrored.ink[:] = flank.rgb[:, ::-1], flank.ink[:, ::-1]
        if lettering is not None:
            # What is written must not be mirrored.
            x, y, tall, words, ink = lettering
            flank.text(x, y, tall, words, ink)
            mirrored.text(max(flank.width - x - 0.8 * tall * len(words), 0.1), y, tall, words, ink)
    baked = [
        None if canvas is None else canvas.bake(shade)
        for canvas, shade in ((flank, 256), (mirrored, 256), (back, 232), (face, 236), (lid, 270))
    ]
    return Block(rear, front, inset, low, high, *baked)


def _shadow() -> Texture:
    canvas = Canvas(1.0, 1.0, 8.0, (34, 34, 36))
    return canvas.bake()


def _wheel(canvas: Canvas, x: float, radius: float) -> None:
    canvas.disc(x, radius, radius, RUBBER)
    canvas.disc(x, radius, radius * 0.58, (158, 160, 162))
    canvas.disc(x, radius, radius * 0.2, (60, 60, 62))


def _plate(canvas: Canvas, y: float, width: float) -> None:
    canvas.rect(width / 2 - 0.27, y, 0.54, 0.13, (232, 232, 226), 30)
    canvas.rect(width / 2 - 0.2, y + 0.03, 0.4, 0.06, (70, 70, 72))


def _ends(width: float, low: float, high: float, colour: Colour) -> tuple[Canvas, Canvas]:
    """Paint the back and the front of a car's body from the ground up."""
    ends = []
    for lamp, glow in (((186, 30, 30), 150), ((238, 236, 220), 230)):
        canvas = Canvas(width, high, DENSITY)
        for x in (0.1, width - 0.34):
            canvas.rect(x, 0, 0.24, low + 0.1, RUBBER)
        canvas.rect(0.0, low, width, high - low, colour)
        canvas.rect(0.0, low, width, 0.12, toned(colour, 150))
        canvas.rect(0.02, low + 0.1, width - 0.04, 0.05, toned(colour, 190))
        for x in (0.05, width - 0.4):
            canvas.rect(x, high - 0.3, 0.35, 0.17, lamp, glow)
        if glow > 200:
            canvas.rect(width * 0.3, high - 0.32, width * 0.4, 0.17, (30, 30, 32))
        _plate(canvas, low + 0.2, width)
        ends.append(canvas)
    return ends[0], ends[1]


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
        _wheel(flank, x, 0.32)
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
        _block(-length / 2, length / 2, 0.0, 0.0, belt, flank, *_ends(width, sill, belt, colour), bonnet),
        _block(rear, front, inset, belt, high, cabin, None, None, None),
        _block(rear + tail * 0.6, front - lean * 0.6, inset + 0.02, belt, high, None, screens[0], screens[1],
               roof),
    ), _shadow())  # fmt: skip


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
    _wheel(flank, 0.9, 0.36)
    back = Canvas(width, high, DENSITY)
    for x in (0.1, width - 0.4):
        back.rect(x, 0, 0.3, 0.4, RUBBER)
    back.rect(0, 0.3, width, high - 0.3, colour)
    back.rect(width / 2 - 0.02, 0.4, 0.04, high - 0.5, toned(colour, 150))
    for x in (0.14, width / 2 + 0.1):
        back.rect(x, 1.2, width / 2 - 0.26, 0.5, GLASS)
    for x in (0.02, width - 0.16):
        back.rect(x, 0.8, 0.14, 0.4, (186, 30, 30), 150)
    _plate(back, 0.5, width)
    face = Canvas(width, high, DENSITY, colour)
    face.rect(0.1, 1.15, width - 0.2, high - 1.45, GLASS)
    nosed = Canvas(nose, 1.15, DENSITY)
    nosed.polygon([(0, 0.3), (nose, 0.3), (nose, 0.85), (0, 1.15)], colour)
    _wheel(nosed, 0.3, 0.36)
    lid = Canvas(length - nose, width, 12.0, toned(colour, 250))
    lid.frame(0, 0, length - nose, width, 0.1, toned(colour, 200))
    hood = Canvas(nose, width, 12.0, toned(colour, 240))
    return Vehicle(length, width, high, (
        _block(-length / 2, length / 2 - nose, 0.0, 0.0, high, flank, back, face, lid, firm),
        _block(length / 2 - nose, length / 2, 0.05, 0.0, 0.98, nosed, None, _ends(width, 0.3, 0.98, colour)[1], hood),
    ), _shadow())  # fmt: skip


def lorry(dice: Dice) -> Vehicle:
    """Draw a lorry with a box or tarpaulin."""
    length, width, high, cab = dice.between(8.0, 12.5), 2.5, 3.7, 2.1
    colour, paint = (
        tinted(dice, dice.pick(((226, 226, 222), (30, 70, 130), (170, 44, 40), (64, 110, 70), (206, 190, 60))), 8),
        dice.pick(PAINTS),
    )
    flank = Canvas(length - cab, high, 30.0)
    flank.rect(0, 0.55, length, 0.4, (56, 58, 60))
    flank.rect(0, 1.0, length - cab - 0.15, high - 1.0, colour)
    flank.speckle(dice, 14, 1.0)
    firm = 0.8, 2.0, 0.8, dice.pick(ADVERTS), (244, 244, 240) if sum(colour) < 480 else (36, 60, 110)
    for x in (1.2, 2.5):
        _wheel(flank, x, 0.48)
    back = Canvas(width, high, DENSITY)
    for x in (0.1, width - 0.6):
        back.rect(x, 0, 0.5, 0.6, RUBBER)
    back.rect(0, 0.5, width, 0.2, (50, 50, 52))
    back.rect(0, 0.9, width, high - 0.9, toned(colour, 240))
    back.rect(width / 2 - 0.03, 1.0, 0.06, high - 1.1, toned(colour, 160))
    back.frame(0, 0.95, width, high - 0.95, 0.07, (150, 152, 154))
    for x in (0.05, width - 0.35):
        back.rect(x, 0.62, 0.3, 0.16, (196, 30, 30), 150)
    _plate(back, 0.68, width)
    head = Canvas(cab, 3.0, 30.0)
    head.rect(0, 0.4, cab, 2.6, paint)
    head.rect(cab * 0.4, 1.7, cab * 0.5, 0.9, GLASS)
    _wheel(head, cab * 0.55, 0.48)
    face = Canvas(width, 3.0, DENSITY, paint)
    face.rect(0.12, 1.7, width - 0.24, 1.0, GLASS)
    face.rect(0.5, 0.8, width - 1.0, 0.6, (36, 36, 38))
    face.rect(0, 0, width, 0.4, RUBBER)
    for x in (0.08, width - 0.5):
        face.rect(x, 0.55, 0.42, 0.22, (240, 238, 224), 230)
    _plate(face, 0.45, width)
    lid = Canvas(length - cab, width, 8.0, toned(colour, 250))
    return Vehicle(length, width, high, (
        _block(-length / 2, length / 2 - cab, 0.0, 0.0, high, flank, back, Canvas(width, high, 10.0, colour), lid, firm),
        _block(length / 2 - cab, length / 2, 0.05, 0.0, 3.0, head, None, face, Canvas(1, 1, 4.0, paint)),
    ), _shadow())  # fmt: skip


def bus(dice: Dice) -> Vehicle:
    """Draw a yellow bus, most of them with two decks."""
    double = dice.chance(0.65)
    length, width, high = dice.between(11.0, 13.0), 2.5, 4.05 if double else 3.0
    colour = tinted(dice, YELLOW, 6)
    decks = (1.05, 2.6) if double else (1.05,)
    flank = Canvas(length, high, 32.0)
    flank.rect(0, 0.3, length, high - 0.3, colour)
    flank.rect(0, 0.3, length, 0.14, (56, 58, 60))
    advert = dice.pick(ADVERTS)
    board = dice.pick(((190, 40, 44), (30, 80, 150), (240, 240, 236), (40, 44, 48)))
    for low in decks:
        flank.rect(0.2, low, length - 0.4, 1.0, GLASS, 110)
        for number in range(int(length / 1.5)):
            flank.rect(0.2 + number * 1.5, low, 0.09, 1.0, (30, 32, 34))
            if dice.chance(0.4):
                flank.disc(0.8 + number * 1.5, low + 0.25, 0.16, (120, 96, 84), 60)
    ink = (30, 30, 32) if sum(board) > 600 else (244, 240, 232)
    if double:
        flank.rect(1.0, 2.1, length - 3.5, 0.45, board)
    for x in (length * 0.3, length * 0.84):
        flank.rect(x, 0.35, 1.1, 1.75, (52, 60, 68), 100)
        flank.rect(x + 0.53, 0.35, 0.05, 1.75, (30, 32, 34))
    for x in (length * 0.22, length * 0.78):
        _wheel(flank, x, 0.48)
    ends = []
    for rear in (True, False):
        canvas = Canvas(width, high, DENSITY)
        canvas.rect(0, 0.25, width, high - 0.25, colour)
        for x in (0.1, width - 0.4):
            canvas.rect(x, 0, 0.3, 0.3, RUBBER)
        for low in decks[1:] if rear else decks:
            canvas.rect(0.12, low, width - 0.24, 1.05, GLASS, 60)
        lamp = (186, 30, 30) if rear else (240, 238, 226)
        for x in (0.08, width - 0.4):
            canvas.rect(x, 0.5, 0.32, 0.2, lamp, 200)
        sign = 2.2 if double else 2.2
        canvas.rect(0.5, sign, width - 1.0, 0.32, (24, 24, 26))
        canvas.text(0.62, sign + 0.06, 0.2, dice.pick(("M19", "M29", "X10", "109", "M46", "110")) + (" ZOO" if not rear else ""),
                    (250, 190, 60))  # fmt: skip
        if rear:
            canvas.rect(0.4, 1.0, width - 0.8, 0.9, board)
            canvas.text(0.5, 1.3, 0.26, advert[:8], ink)
        _plate(canvas, 0.4, width)
        ends.append(canvas)
    lid = Canvas(length, width, 10.0, (226, 214, 170))
    lid.frame(0, 0, length, width, 0.2, toned(colour, 220))
    lid.rect(length * 0.4, 0.6, 1.8, 1.3, (190, 190, 186))
    return Vehicle(length, width, high, (
        _block(-length / 2, length / 2, 0.0, 0.0, high, flank, ends[0], ends[1], lid,
               (1.6, 2.17, 0.3, advert, ink) if double else None),
    ), _shadow())  # fmt: skip


def cyclist(dice: Dice, colours: tuple[Colour, ...] = PAINTS) -> Canvas:
    """Paint somebody on a bicycle, as seen from behind or in front; 0.8 m wide and 1.8 m tall."""
    canvas = Canvas(0.8, 1.8, 60.0)
    shirt = tinted(dice, dice.pick((*colours, (190, 60, 50), (60, 120, 170), (220, 180, 60))), 14)
    skin = dice.pick(((226, 186, 160), (188, 142, 112), (130, 92, 72)))
    canvas.rect(0.375, 0.0, 0.05, 0.7, RUBBER)
    canvas.rect(0.36, 0.62, 0.08, 0.3, (70, 72, 76))
    canvas.rect(0.14, 0.98, 0.52, 0.04, (60, 62, 64))
    trousers = dice.pick(((40, 46, 66), (52, 52, 54), (110, 96, 80)))
    canvas.polygon([(0.26, 0.9), (0.4, 0.9), (0.36, 0.25), (0.26, 0.25)], trousers)
    canvas.polygon([(0.4, 0.9), (0.54, 0.9), (0.54, 0.45), (0.44, 0.45)], toned(trousers, 220))
    canvas.polygon([(0.25, 0.85), (0.55, 0.85), (0.6, 1.4), (0.2, 1.4)], shirt)
    for x0, x1 in ((0.22, 0.17), (0.58, 0.63)):
        canvas.line(x0, 1.35, x1, 1.02, 0.09, toned(shirt, 210))
    canvas.disc(0.4, 1.56, 0.12, skin)
    canvas.disc(0.4, 1.61, 0.12, dice.pick(((40, 32, 28), (110, 80, 50), (200, 200, 196), (180, 40, 40))))
    canvas.rect(0.36, 0.7, 0.08, 0.06, (200, 30, 30), 160)
    return canvas
