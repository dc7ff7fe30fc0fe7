"""What stands beside and above a motorway: barriers, gantries, bridges, lamps, and the houses behind."""

from vpr_datasets.simulation import plants
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city import kit
from vpr_datasets.simulation.lots import plain
from vpr_datasets.simulation.materials import CONCRETE, blocks, concrete, tinted, toned
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

BLUE: Colour = (24, 72, 150)
WHITE: Colour = (240, 240, 236)
PLACES = ("HAMBURG", "DRESDEN", "MESSE", "FUNKTURM", "WEDDING", "SCHONEBERG", "SPANDAU", "KAISERDAMM", "HANNOVER",
          "TEMPELHOF", "STEGLITZ", "WILMERSDORF", "SCHMARGENDORF", "SIEMENSDAMM")  # fmt: skip


def along(
    stage: Stage, side: int, start: float, stop: float, t: float, low: float, high: float, texture: Texture
) -> None:
    """Put up a wall along the road that is seen from both sides; it follows the bend."""
    ends = ((start, side * t), (stop, side * t))
    stage.wall(*(ends if side > 0 else ends[::-1]), low, high, texture, "both")


def barrier(dice: Dice, kind: str, length: float, high: float, season: Season) -> Texture:
    """Paint a stretch of a noise barrier or retaining wall."""
    if kind == "glass":
        canvas = Canvas(length, high, 16.0)
        canvas.rect(0, 0, length, 1.2, dice.pick(CONCRETE))
        for number in range(int(length / 2.5) + 1):
            canvas.rect(min(number * 2.5, length - 0.2), 0, 0.2, high, (84, 104, 96))
        canvas.rect(0, high - 0.12, length, 0.12, (84, 104, 96))
        for number in range(int(length / 0.5)):
            canvas.rect(number * 0.5, 1.2, 0.06, high - 1.3, (150, 172, 176))
        return canvas.bake()
    if kind == "hedge":
        return plants.hedge(dice, season, length, high).bake()
    colours = {"wood": ((120, 96, 72), (104, 92, 80)), "panels": ((122, 146, 120), (150, 110, 92), (112, 132, 150)),
               "concrete": CONCRETE, "brick": ((140, 84, 66), (124, 78, 64))}[kind]  # fmt: skip
    canvas = Canvas(length, high, 16.0, tinted(dice, dice.pick(colours), 10))
    if kind == "concrete":
        concrete(canvas, dice)
    elif kind == "brick":
        blocks(canvas, dice, 0.14, 0.4, 16, -12)
    else:
        blocks(canvas, dice, 0.5 if kind == "panels" else 0.16, 4.0, 14, 26)
    canvas.speckle(dice, 18, 2.0)
    for number in range(int(length / 4.0) + 1):
        canvas.rect(min(number * 4.0, length - 0.25), 0, 0.25, high, (110, 112, 112))
    if dice.chance(0.45):
        _spray(canvas, dice)
    if dice.chance(0.5):
        _overgrow(canvas, dice)
    return canvas.bake()


def _spray(canvas: Canvas, dice: Dice) -> None:
    """Spray large letters on a wall."""
    word = dice.pick(("OPEK", "1UP", "SOKE", "BERLIN", "RADIC", "ZEN", "UNITY", "HALO", "KRS"))
    tall = min(canvas.height * 0.5, 2.0)
    x = dice.between(0.3, max(canvas.width - len(word) * tall, 0.4))
    fill = dice.pick(((206, 206, 210), (60, 130, 190), (220, 90, 120), (240, 200, 60), (90, 180, 110)))
    for number, letter in enumerate(word):
        left = x + number * tall * 0.92
        canvas.rect(left, 0.3 + 0.1 * (number % 2), tall * 0.84, tall, (30, 30, 36))
        canvas.rect(left + 0.08, 0.38 + 0.1 * (number % 2), tall * 0.68, tall * 0.84, fill)
        canvas.text(left + 0.14, 0.5 + 0.1 * (number % 2), tall * 0.62, letter, (30, 30, 36))


def _overgrow(canvas: Canvas, dice: Dice) -> None:
    """Let ivy climb up."""
    for _ in range(int(canvas.width * 14)):
        x, y = dice.between(0, canvas.width), dice.between(0, 1) * dice.between(0, 1) * canvas.height
        canvas.disc(x, y, dice.between(0.08, 0.28), toned((74, 104, 52), 150 + dice.below(130)))


def guide(dice: Dice, width: float, high: float) -> Canvas:
    """Paint a blue direction sign."""
    canvas = Canvas(width, high, 30.0, BLUE)
    canvas.frame(0.05, 0.05, width - 0.1, high - 0.1, 0.08, WHITE)
    rows = max(int((high - 0.5) / 0.75), 1)
    for row in range(rows):
        word = dice.pick(PLACES)
        canvas.text(width * 0.22, high - 0.85 - row * 0.75, min(0.46, width * 0.74 / len(word) * 1.15), word, WHITE)
    canvas.rect(width * 0.1, 0.35, 0.14, high * 0.5, WHITE)
    canvas.polygon(
        [(width * 0.1 - 0.16, high * 0.5), (width * 0.1 + 0.3, high * 0.5), (width * 0.1 + 0.07, high * 0.72)], WHITE
    )
    if dice.chance(0.5):
        canvas.rect(width * 0.72, 0.2, width * 0.2, 0.42, WHITE)
        canvas.text(width * 0.74, 0.28, 0.26, dice.pick(("A100", "A115", "A111")), BLUE)
    canvas.ink[:] = 50
    return canvas


def put_gantry(stage: Stage, dice: Dice, s: float, right: float, left: float) -> None:
    """Carry signs above the carriageway."""
    steel = plain((120, 126, 128), dice)
    for t in (right, left):
        stage.box(s, t, 0.4, 0.4, 7.4, steel, steel, None)
    truss = Canvas(left - right, 0.9, 24.0)
    for y in (0.0, 0.76):
        truss.rect(0, y, left - right, 0.14, (120, 126, 128))
    for number in range(int((left - right) / 0.9)):
        truss.line(number * 0.9, 0, number * 0.9 + 0.45, 0.8, 0.07, (120, 126, 128))
        truss.line(number * 0.9 + 0.45, 0.8, number * 0.9 + 0.9, 0, 0.07, (120, 126, 128))
    stage.wall((s, left), (s, right), 6.6, 7.5, truss.bake(), "both")
    t = left - dice.between(0.8, 1.6)
    while t - 3.0 > right:
        width = min(dice.between(3.0, 4.6), t - right - 0.4)
        high = dice.pick((1.3, 2.1, 2.9))
        stage.wall((s - 0.25, t), (s - 0.25, t - width), 5.6, 5.6 + high, guide(dice, width, high).bake())
        t -= width + dice.between(0.3, 1.6)


def put_bridge(stage: Stage, dice: Dice, s: float, right: float, left: float) -> float:
    """Lead a road or railway over the motorway; returns its width."""
    wide, level, deep = dice.between(7.0, 18.0), dice.between(5.2, 6.4), dice.between(1.0, 1.8)
    colour = tinted(dice, dice.pick((*CONCRETE, (88, 116, 108), (96, 104, 120))), 10)
    span = left - right
    beam = Canvas(span, deep, 16.0, colour)
    concrete(beam, dice)
    beam.rect(0, deep - 0.25, span, 0.25, toned(colour, 280))
    if dice.chance(0.5):
        beam.text(
            span * dice.between(0.3, 0.6),
            0.25,
            deep * 0.5,
            dice.pick(("PAULSBORNER BR.", "1UP CREW", "RATHENAU", "KURFURSTEN")),
            (40, 42, 48),
        )
    rail = Canvas(span, 1.2, 20.0)
    for number in range(int(span / 0.35)):
        rail.rect(number * 0.35, 0, 0.1, 1.2, (90, 100, 100))
    rail.rect(0, 1.08, span, 0.12, (90, 100, 100))
    face, fence = beam.bake(220), rail.bake()
    for place in (s, s + wide):
        stage.wall((place, left), (place, right), level, level + deep, face, "both")
        stage.wall((place, left), (place, right), level + deep, level + deep + 1.2, fence, "both")
    under = Canvas(wide, span, 6.0, toned(colour, 150))
    under.speckle(dice, 20, 2.0)
    for number in range(int(span / 2.2)):
        under.rect(0, number * 2.2, wide, 0.5, toned(colour, 110))
    stage.slab(s, right, wide, span, level, under.bake(), roof=True)
    pier = Canvas(wide * 0.7, level, 12.0, toned(colour, 230))
    concrete(pier, dice)
    side = pier.bake(220)
    for t in (6.9, -9.6, 20.6):
        stage.box(s + wide / 2, t, wide * 0.7, 0.8, level, side, side, None)
    for way in (1, -1):
        edge = left if way > 0 else -right
        slope = plain(tinted(dice, (112, 118, 84), 10), dice, 6.0)
        along(stage, way, s - 6, s + wide + 6, edge - 2.0, 0, level, slope)
    if dice.chance(0.6):
        lamp = kit.lamp(dice, 7.0).bake()
        for t in (right * 0.6, left * 0.6):
            stage.cutout(s + wide / 2, t, 4.4, level + deep + 7.0, lamp, low=level + deep)
    return wide


def put_block(stage: Stage, dice: Dice, side: int, s: float, t: float, low: float = 0.0) -> float:
    """Stand a block of flats or offices behind the barrier; returns its length."""
    length, high = dice.between(14, 44), dice.pick((14.0, 17.0, 20.0, 24.0, 34.0, 48.0))
    colour = tinted(
        dice,
        dice.pick(
            ((196, 188, 170), (176, 160, 140), (206, 204, 198), (150, 156, 160), (190, 150, 120), (120, 130, 140))
        ),
        12,
    )
    accent = dice.pick(((170, 60, 50), (60, 90, 140), (210, 160, 70), (90, 120, 96), toned(colour, 200)))
    faces = []
    bay, wide, tall = dice.between(2.2, 4.0), dice.between(0.4, 0.85), dice.between(2.8, 3.4)
    for span in (length, 12.0):
        canvas = Canvas(span, high, 9.0, colour)
        canvas.speckle(dice, 14, 4.0)
        for storey in range(int(high / tall)):
            for number in range(int(span / bay)):
                glow = 90 + dice.below(140) if dice.chance(0.3) else 8
                pane = tinted(dice, (70, 82, 92), 14)
                canvas.rect(
                    number * bay + bay * (1 - wide) / 2, storey * tall + 0.9, bay * wide, tall * 0.5, pane, glow
                )
                if number % 3 == 1:
                    canvas.rect(number * bay, storey * tall + 0.1, bay, 0.8, accent)
        canvas.rect(0, high - 0.6, span, 0.6, toned(colour, 190))
        faces.append(canvas)
    ends = ((s, side * t), (s + length, side * t))
    stage.wall(*(ends if side > 0 else ends[::-1]), low, high, faces[0].bake(256 if side > 0 else 226))
    flank = ((s, t + 12), (s, t)) if side > 0 else ((s, -t), (s, -t - 12))
    stage.wall(*flank, low, high, faces[1].bake(204))
    if dice.chance(0.3):
        board = Canvas(min(length * 0.6, 12.0), 2.4, 16.0)
        word = dice.pick(("HOTEL", "RADIO", "MESSE", "ZENTRALE", "PHARMA", "BANK"))
        board.text(0.2, 0.2, 2.0, word, dice.pick(((200, 40, 40), (40, 80, 170), (240, 240, 236))))
        stage.wall(*((ends[0], (s + board.width, side * t)) if side > 0 else ((s + board.width, side * t), ends[0])),
                   high, high + 2.4, board.bake())  # fmt: skip
    return length
