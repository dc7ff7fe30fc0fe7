"""Rows of houses: one front beside the other, and the bare or windowed walls at their ends."""

from dataclasses import replace

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.berlin import GROUND, House, draw_house
from vpr_datasets.simulation.city.relief import put_cornice, put_relief, put_roof
from vpr_datasets.simulation.city.shops import paint_ground_floor, put_fronts
from vpr_datasets.simulation.city.storeys import glass, grid, rendered, stucco
from vpr_datasets.simulation.lots import wall_across, wall_along
from vpr_datasets.simulation.materials import plaster, tinted
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Texture


def put_house(
    stage: Stage,
    dice: Dice,
    side: int,
    s: float,
    width: float,
    t: float,
    words: tuple[str, ...],
    *,
    corner: bool = False,
) -> None:
    """Put up a house whose front is ``t`` metres beside the path; one at a corner has another front at its near end."""
    house = draw_house(dice, width)
    depth, lit = 13.0, 256 if side > 0 else 226
    ground = paint_ground_floor(dice, house.kind == "stucco", house.colour, house.trim, width, GROUND, words)
    wall_along(stage, side, s, s + width, t, 0, GROUND, ground.bake(lit))
    paint = {"stucco": stucco, "plain": rendered, "grid": grid, "glass": glass}[house.kind]
    wall_along(stage, side, s, s + width, t, GROUND, house.eaves, paint(dice, house, width).bake(lit))
    if corner:
        deep = 24.0
        flank = paint_ground_floor(dice, house.kind == "stucco", house.colour, house.trim, deep, GROUND, words)
        wall_across(stage, s, t, deep, 0, GROUND, flank.bake(206), side)
        longer = replace(house, bays=max(round(house.bays * deep / width), 3))
        wall_across(stage, s, t, deep, GROUND, house.eaves, paint(dice, longer, deep).bake(206), side)
    else:
        wall_across(stage, s + 0.02, t, depth, 0, house.eaves, _fire_wall(dice, house, depth, words), side)
    stage.shade(s + width / 2, side * (t + depth / 2), width - 1.0, depth - 1.0, 0, house.eaves)
    put_fronts(stage, dice, side, s, width, t, words)
    if house.kind == "stucco":
        put_cornice(stage, dice, house, side, s, width, t)
        put_relief(stage, dice, house, side, s, width, t)
    put_roof(stage, dice, house, side, s, width, t)


def _fire_wall(dice: Dice, house: House, depth: float, words: tuple[str, ...]) -> Texture:
    """Paint the bare wall to which no neighbour has been built, on some with an old advertisement."""
    canvas = Canvas(depth, house.eaves, 10.0, tinted(dice, (168, 158, 146), 14))
    plaster(canvas, dice)
    canvas.speckle(dice, 20, 3.0)
    if dice.chance(0.2):
        canvas.rect(2.0, 6.0, 8.0, min(7.0, house.eaves - 7.0), tinted(dice, house.accent, 20))
        canvas.disc(6.0, 9.0, 1.6, (232, 228, 216))
        canvas.text(2.6, 6.6, 1.1, dice.pick(words)[:9], (244, 242, 236))
    return canvas.bake(200)
