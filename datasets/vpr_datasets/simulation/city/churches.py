"""Churches and towers of an old town, seen above the roofs."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import brick, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas


def tower(dice: Dice) -> Canvas:
    """Paint a tower with galleries and a spire, 11 m wide and 46 to 64 m tall."""
    high = dice.between(46.0, 64.0)
    canvas = Canvas(11.0, high, 9.0)
    colour = dice.pick(((136, 96, 76), (156, 140, 120), (116, 84, 72)))
    width, y = dice.between(7.0, 9.5), 0.0
    body = high * dice.between(0.4, 0.52)
    canvas.rect(5.5 - width / 2, 0, width, body, colour)
    brick(canvas, dice)
    stone = (206, 198, 180)
    for level in range(int(body / 8)):
        low = level * 8.0 + 3.0
        canvas.rect(5.5 - width * 0.16, low, width * 0.32, 4.0, toned(colour, 120))
        canvas.disc(5.5, low + 4.0, width * 0.16, toned(colour, 120))
        canvas.rect(5.5 - width / 2, level * 8.0, width, 0.5, stone)
    canvas.disc(5.5, body - 3.0, width * 0.24, (40, 50, 70))
    canvas.ring(5.5, body - 3.0, width * 0.24, 0.3, (214, 180, 80))
    y = body
    while y < high - 9:
        width *= dice.between(0.66, 0.82)
        part = min(dice.between(5.0, 8.0), high - 8 - y)
        canvas.rect(5.5 - width * 0.6, y, width * 1.2, 0.6, stone)
        canvas.rect(5.5 - width / 2, y + 0.6, width, part - 0.6, dice.pick((stone, (110, 130, 120), colour)))
        canvas.rect(5.5 - width * 0.2, y + 1.4, width * 0.4, part - 2.4, (50, 54, 56))
        y += part
    lead = dice.pick(((96, 122, 112), (92, 96, 102)))
    canvas.polygon([(5.5 - width * 0.55, y), (5.5 + width * 0.55, y), (5.6, high - 1.0), (5.4, high - 1.0)], lead)
    canvas.disc(5.5, y + 1.2, width * 0.5, lead)
    canvas.rect(5.42, high - 2.0, 0.16, 2.0, (190, 160, 80))
    return canvas


def put_church(stage: Stage, dice: Dice, side: int, s: float, width: float, t: float) -> None:
    """Put up the nave of a church beside a square, buttresses and pointed windows."""
    colour = dice.pick(((140, 98, 78), (120, 86, 72), (164, 150, 130)))
    wall = Canvas(width, 13.0, 18.0, colour)
    brick(wall, dice)
    count = max(int(width / 5.0), 1)
    for number in range(count):
        x = (number + 0.5) * width / count
        wall.rect(x - 1.3, 2.5, 2.6, 6.0, (190, 182, 166))
        wall.polygon([(x - 1.3, 8.5), (x + 1.3, 8.5), (x, 11.2)], (190, 182, 166))
        wall.rect(x - 1.05, 2.8, 2.1, 5.7, (60, 70, 78), 40)
        wall.polygon([(x - 1.05, 8.5), (x + 1.05, 8.5), (x, 10.7)], (60, 70, 78))
        for bar in range(1, 4):
            wall.rect(x - 1.05 + bar * 0.525, 2.8, 0.1, 6.4, (190, 182, 166))
        edge = number * width / count
        wall.rect(edge, 0, 0.9, 10.5, toned(colour, 226))
        wall.rect(edge, 10.3, 0.9, 0.3, (190, 182, 166))
    wall.rect(0, 12.6, width, 0.4, (190, 182, 166))
    ends = ((s, side * t), (s + width, side * t))
    stage.wall(*(ends if side > 0 else ends[::-1]), 0, 13.0, wall.bake(256 if side > 0 else 230))
    roof = Canvas(width, 8.0, 14.0, (86, 90, 98))
    roof.speckle(dice, 24, 2.0)
    for number in range(int(width / 0.9)):
        roof.rect(number * 0.9, 0, 0.08, 8.0, (70, 74, 82))
    back = ((s, side * (t + 5)), (s + width, side * (t + 5)))
    stage.wall(*(back if side > 0 else back[::-1]), 13.0, 21.0, roof.bake(230))
    gable = Canvas(14.0, 22.0, 14.0, None)
    gable.polygon([(0, 0), (14.0, 0), (14.0, 13.0), (7.0, 21.5), (0, 13.0)], colour)
    brick(gable, dice)
    gable.rect(5.0, 5.0, 4.0, 8.0, (60, 70, 78))
    gable.disc(7.0, 13.0, 2.0, (60, 70, 78))
    flank = ((s, side * t + side * 14.0), (s, side * t)) if side > 0 else ((s, -t), (s, -t - 14.0))
    stage.wall(*flank, 0, 22.0, gable.bake(206))
    stage.cutout(s + width - 4.0, side * (t + 8), 11.0 * dice.pick((1, -1)), 54.0, tower(dice).bake())
    stage.shade(s + width / 2, side * (t + 7), width - 1, 12.0, 0, 17.0)
