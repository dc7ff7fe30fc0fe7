"""Detached houses and barns under gabled roofs."""

from dataclasses import dataclass

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import WOOD, blocks, brick, plaster, tinted, toned, wood
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import SURFACE, Canvas, Colour, Texture

DENSITY = 22.0


@dataclass(frozen=True)
class House:
    """A house: its middle (s, t), its sizes in metres, and what it is made of.

    ``length`` goes along the path, and the ridge with it unless the house is ``turned``.
    """

    s: float
    t: float
    length: float
    width: float
    eaves: float
    rise: float
    walls: Colour
    roof: Colour
    material: str = "wood"
    turned: bool = False
    barn: bool = False
    snow: float = 0.0


def put_house(stage: Stage, dice: Dice, house: House) -> None:
    """Put up four walls, two gables and, in the plane of the ridge, a wall that passes for the roof.

    Seen from lower than the eaves it covers just what the slopes would, and the inner sides of the gables the
    rest.
    """
    near, far = house.s - house.length / 2, house.s + house.length / 2
    right, left = house.t - house.width / 2, house.t + house.width / 2
    corners = ((near, left), (near, right), (far, right), (far, left))
    long = _side(dice, house, house.length), _side(dice, house, house.length)
    short = _side(dice, house, house.width), _side(dice, house, house.width)
    for number, canvas in enumerate((short[0], long[0], short[1], long[1])):
        shade = (208, 236, 224, 250)[number]
        stage.wall(corners[number], corners[(number + 1) % 4], 0, house.eaves, canvas.bake(shade))
    high = house.eaves + house.rise
    roof = _roof(dice, house, house.width if house.turned else house.length)
    if house.turned:
        stage.wall((house.s, left), (house.s, right), house.eaves, high, roof, "both")
        ends = ((corners[1], corners[2]), (corners[3], corners[0]))
    else:
        stage.wall((near, house.t), (far, house.t), house.eaves, high, roof, "both")
        ends = ((corners[0], corners[1]), (corners[2], corners[3]))
    span = house.length if house.turned else house.width
    outer, inner = _gable(dice, house, span, house.walls), _gable(dice, house, span, house.roof)
    for first, second in ends:
        stage.wall(first, second, house.eaves, high, outer)
        stage.wall(second, first, house.eaves, high, inner)
    stage.shade(house.s, house.t, house.length - 1.6, house.width - 1.6, 0, house.eaves + house.rise * 0.6)
    if not house.barn and dice.chance(0.7):
        _put_chimney(stage, dice, house, high)


def _clad(canvas: Canvas, dice: Dice, material: str) -> None:
    {"wood": wood, "brick": brick, "plaster": plaster}[material](canvas, dice)


def _side(dice: Dice, house: House, length: float) -> Canvas:
    """Paint one wall: windows and a door, or the gates of a barn."""
    canvas = Canvas(length, house.eaves, DENSITY, house.walls)
    _clad(canvas, dice, house.material)
    trim = dice.pick(((234, 232, 226), (234, 232, 226), toned(house.walls, 140)))
    canvas.rect(0, 0, length, 0.35, (128, 124, 120))
    for x in (0.0, length - 0.16):
        canvas.rect(x, 0, 0.16, house.eaves, trim)
    storeys = max(int(house.eaves / 2.7), 1)
    tall = house.eaves / storeys
    if house.barn:
        middle, wide = length * dice.between(0.3, 0.7), min(length * 0.3, 3.4)
        canvas.rect(
            middle - wide / 2, 0.2, wide, min(house.eaves - 0.5, 3.2), tinted(dice, toned(house.walls, 180), 10)
        )
        canvas.frame(middle - wide / 2, 0.2, wide, min(house.eaves - 0.5, 3.2), 0.14, trim)
        canvas.line(middle - wide / 2, 0.3, middle + wide / 2, min(house.eaves - 0.5, 3.2), 0.12, trim)
        storeys = 0
    for storey in range(storeys):
        bays = max(int(length / dice.between(2.2, 3.2)), 1)
        door = dice.below(bays) if storey == 0 else -1
        for bay in range(bays):
            x, low = (bay + 0.5) * length / bays, storey * tall + tall * 0.36
            if bay == door:
                canvas.rect(x - 0.6, 0.3, 1.2, tall * 0.76, trim)
                canvas.rect(x - 0.48, 0.3, 0.96, tall * 0.72, tinted(dice, dice.pick(WOOD), 24))
            elif dice.chance(0.85):
                wide = dice.pick((1.0, 1.3, 1.9))
                canvas.rect(x - wide / 2 - 0.12, low - 0.12, wide + 0.24, tall * 0.45 + 0.24, trim)
                canvas.rect(x - wide / 2, low, wide, tall * 0.45, (58, 70, 82), 8 + dice.below(120))
                canvas.rect(x - wide / 2, low + tall * 0.24, wide, tall * 0.21, (112, 130, 144), 40)
                canvas.rect(x - 0.04, low, 0.08, tall * 0.45, trim)
    # The eaves shade the top of the wall.
    canvas.rect(0, house.eaves - 0.3, length, 0.3, toned(house.walls, 130))
    return canvas


def _roof(dice: Dice, house: House, length: float) -> Texture:
    dice = dice.branch()
    canvas = Canvas(length, house.rise, DENSITY, house.roof)
    blocks(canvas, dice, 0.3, 0.4, 22, 26)
    canvas.speckle(dice, 18, 1.2)
    if house.snow:
        rows, columns = canvas.ink.shape
        noise = np.asarray(dice.bytes(columns // 6 + 1)).repeat(6)[:columns].astype(np.int64)
        # It slides off the lower edge first.
        bare = int(rows * (1 - house.snow)) + noise * rows // 2400
        white = np.arange(rows)[:, None] < rows - bare[None]
        canvas.rgb[white] = (236, 240, 246)
        canvas.speckle(dice, 8, 0.8)
    canvas.rect(0, house.rise - 0.14, length, 0.14, toned(house.roof, 190) if not house.snow else (240, 243, 248))
    return canvas.bake(240)


def _gable(dice: Dice, house: House, span: float, colour: Colour) -> Texture:
    canvas = Canvas(span, house.rise, DENSITY, colour)
    _clad(canvas, dice, house.material)
    rows, columns = canvas.ink.shape
    if colour == house.walls:
        wide = min(span * 0.16, 1.2)
        canvas.rect(span / 2 - wide / 2 - 0.1, house.rise * 0.16, wide + 0.2, house.rise * 0.36, (232, 230, 224))
        canvas.rect(span / 2 - wide / 2, house.rise * 0.2, wide, house.rise * 0.28, (62, 74, 86), 60)
    up = rows - np.arange(rows)[:, None]
    edge = np.minimum(np.arange(columns), columns - 1 - np.arange(columns))[None]
    inside = edge * 2 * rows >= up * columns
    verge = inside & (edge * 2 * rows < (up + 5) * columns)
    canvas.rgb[verge] = (236, 240, 246) if house.snow > 0.5 else (214, 210, 202)
    canvas.ink[:] = np.where(inside, SURFACE, 0)
    return canvas.bake(226)


def _put_chimney(stage: Stage, dice: Dice, house: House, high: float) -> None:
    canvas = Canvas(0.7, 1.5, DENSITY, (128, 84, 70))
    brick(canvas, dice)
    if house.snow:
        canvas.rect(0, 1.3, 0.7, 0.2, (236, 240, 246))
    texture = canvas.bake(230)
    s = house.s if house.turned else house.s + dice.between(-0.3, 0.3) * house.length
    t = house.t + dice.between(-0.3, 0.3) * house.width if house.turned else house.t
    stage.box(s, t, 0.6, 0.6, high + 0.5, texture, texture, None, low=high - 0.6)
