"""What breaks the rows of houses: squares with trees, towers set back from the road, railways that cross above."""

from vpr_datasets.simulation import plants, props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city import kit
from vpr_datasets.simulation.city.shops import ink_on, paint_ground_floor
from vpr_datasets.simulation.city.trees import TALL, WIDE
from vpr_datasets.simulation.city.windows import glaze
from vpr_datasets.simulation.city.words import ADVERTS, SHOPS
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import CONCRETE, brick, tile, tinted, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Texture


def plant_square(
    stage: Stage, dice: Dice, trees: list[Texture], side: int, s: float, width: float, front: float
) -> None:
    """Plant trees and shrubs on a lawn before a house that is set back."""
    lawn = Canvas(width - 1.0, 9.0, 10.0, (104, 132, 66))
    lawn.speckle(dice, 40)
    lawn.rect(width * 0.4, 0, 2.0, 9.0, (182, 174, 156))
    stage.slab(s + 0.5, front if side > 0 else -front - 9.0, width - 1.0, 9.0, 0.014, lawn.bake())
    rail = props.railing(dice, width - 1.0, 0.9)
    wall_along(stage, side, s + 0.5, s + width - 0.5, front - 0.1, 0, 0.9, rail.bake())
    shrubs = [plants.shrub(dice.branch(), "summer").bake() for _ in range(3)]
    for number in range(3 + dice.below(3)):
        size = dice.between(0.9, 1.5)
        place = s + 2.0 + number * (width - 4.0) / 5
        stage.cutout(place, side * (front + dice.between(1.5, 8.0)), WIDE * size, TALL * size, dice.pick(trees))
    for _ in range(int(width * 0.8)):
        size = dice.between(0.6, 1.2)
        stage.cutout(
            s + dice.between(0.8, width - 0.8),
            side * (front + dice.between(0.5, 4.0)),
            2.4 * size,
            1.6 * size,
            dice.pick(shrubs),
        )
    if dice.chance(0.5):
        foot = plain((150, 146, 138), dice)
        stage.box(s + width / 2, side * (front + 2.0), 1.6, 1.6, 1.8, foot, foot, foot)
        bronze = (70, 92, 80)
        figure = Canvas(1.2, 2.6, 40.0)
        figure.polygon([(0.3, 0), (0.9, 0), (0.8, 1.6), (0.4, 1.6)], bronze)
        figure.disc(0.6, 1.9, 0.24, bronze)
        figure.line(0.6, 1.4, 1.1, 2.2, 0.14, bronze)
        stage.cutout(s + width / 2, side * (front + 2.0), 1.2, 4.4, figure.bake(), low=1.8)


def put_tower(stage: Stage, dice: Dice, side: int, s: float, width: float, t: float) -> None:
    """Put up a tall office house with its name on the roof."""
    high, depth = dice.between(30.0, 62.0), 16.0
    colour = tinted(
        dice, dice.pick(((190, 192, 190), (110, 124, 136), (170, 150, 124), (84, 88, 94), (206, 198, 180))), 10
    )
    accent = tinted(dice, dice.pick(((60, 84, 110), (120, 60, 50), (70, 100, 90), (60, 62, 66))), 10)
    bay, tall, upright = dice.between(1.4, 3.0), dice.between(3.0, 3.6), dice.chance(0.5)
    base = paint_ground_floor(dice, False, colour, toned(colour, 200), width, 4.6, SHOPS)
    wall_along(stage, side, s, s + width, t, 0, 4.6, base.bake())
    faces = []
    for span in (width, depth):
        canvas = Canvas(span, high - 4.6, 12.0, colour)
        tile(canvas, dice)
        for storey in range(int((high - 4.6) / tall)):
            y = storey * tall
            if not upright:
                canvas.rect(0, y, span, tall * 0.35, accent)
            for number in range(int(span / bay)):
                x = number * bay
                glaze(canvas, dice, x + 0.15, y + tall * 0.38, bay - 0.3, tall * 0.52, toned(colour, 200), lit=0.4)
                if upright:
                    canvas.rect(x - 0.12, y, 0.3, tall, accent)
        faces.append(canvas)
    wall_along(stage, side, s, s + width, t, 4.6, high, faces[0].bake(256 if side > 0 else 230))
    wall_across(stage, s, t, depth, 0, high, faces[1].bake(204), side)
    board = tinted(dice, dice.pick(((200, 40, 40), (30, 80, 170), (240, 240, 236))), 8)
    sign = Canvas(min(width * 0.8, 11.0), 2.6, 14.0)
    word = dice.pick(ADVERTS)
    sign.rect(0, 0, sign.width, 2.6, board, 150)
    sign.text(0.5, 0.6, min(1.5, sign.width / len(word)), word, ink_on(board))
    wall_along(stage, side, s + 1.0, s + 1.0 + sign.width, t + 0.5, high + 0.4, high + 3.0, sign.bake())
    stage.shade(s + width / 2, side * (t + depth / 2), width - 1, depth - 1, 0, high)


def put_viaduct(stage: Stage, dice: Dice, s: float, right: float, left: float) -> None:
    """Lead a railway over the road, on girders or on a brick arch's abutments."""
    wide, level, deep, span = dice.between(8.0, 12.0), dice.between(4.9, 5.6), dice.between(1.2, 1.9), left - right
    colour = tinted(dice, dice.pick(((84, 110, 96), (92, 98, 110), (120, 74, 60), *CONCRETE)), 10)
    beam = Canvas(span, deep, 16.0, colour)
    for number in range(int(span / 1.2)):
        beam.rect(number * 1.2, 0.1, 0.1, deep - 0.2, toned(colour, 180))
        for y in (0.2, deep - 0.3):
            beam.disc(number * 1.2 + 0.05, y, 0.06, toned(colour, 290))
    for y in (0.0, deep - 0.16):
        beam.rect(0, y, span, 0.16, toned(colour, 200))
    beam.speckle(dice, 22, 1.5)
    board = kit.poster(dice, 7.0, min(deep, 1.3), 20.0)
    rows, columns = beam.area(span * 0.3, 0.1, 7.0, min(deep, 1.3))
    patch = beam.rgb[rows, columns][: board.rgb.shape[0], : board.rgb.shape[1]]
    patch[:] = board.rgb[: patch.shape[0], : patch.shape[1]]
    rail = props.railing(dice, span, 1.1).bake()
    face = beam.bake(228)
    for place in (s, s + wide):
        stage.wall((place, left), (place, right), level, level + deep, face, "both")
        stage.wall((place, left), (place, right), level + deep, level + deep + 1.1, rail, "both")
    under = plain(toned(colour, 130), dice, 6.0)
    stage.slab(s, right, wide, span, level, under, roof=True)
    wall = Canvas(wide, level, 20.0, (136, 88, 70))
    brick(wall, dice)
    wall.speckle(dice, 24, 2.0)
    for side, edge in ((1, left - 2.6), (-1, -right - 2.6)):
        wall_along(stage, side, s, s + wide, edge, 0, level, wall.bake(200))
        wall_across(stage, s, edge, 5.0, 0, level + deep, wall.bake(220), side)
    post = plain(toned(colour, 210), dice)
    for t in (right + 7.0, left - 7.0):
        for place in (s + 0.6, s + wide - 0.6):
            stage.box(place, t, 0.35, 0.35, level, post, post, None)
