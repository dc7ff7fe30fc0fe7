"""What stands beside the path: buildings, gardens, groves, squares and fences."""

from dataclasses import dataclass

from vpr_datasets.simulation import plants, props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import ACCENTS, STOREY, WORDS, Style, draw_style, paint_street, paint_upper
from vpr_datasets.simulation.materials import WALLS, tinted, toned
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture


@dataclass(frozen=True)
class Greenery:
    """Plants of a season, each in a few shapes that are used again and again."""

    season: Season
    trees: list[Texture]
    palms: list[Texture]
    shrubs: list[Texture]
    grasses: list[Texture]


def grow(seed: int, season: Season) -> Greenery:
    """Paint the plants of a season."""

    def several(kind: str, count: int) -> list[Texture]:
        paint = {"tree": plants.tree, "palm": plants.palm, "shrub": plants.shrub, "grass": plants.grasses}[kind]
        return [paint(Dice(seed, kind, number), season).bake() for number in range(count)]

    return Greenery(season, several("tree", 7), several("palm", 4), several("shrub", 7), several("grass", 4))


def plain(colour: Colour, dice: Dice, size: float = 1.0) -> Texture:
    """Return a small speckled texture of one colour."""
    canvas = Canvas(size, size, 24.0, colour)
    canvas.speckle(dice, 12)
    return canvas.bake()


def wall_along(
    stage: Stage, side: int, s0: float, s1: float, t: float, low: float, high: float, texture: Texture
) -> None:
    """Put up a wall along the path that is seen from the path."""
    ends = ((s0, side * t), (s1, side * t))
    stage.wall(*(ends if side > 0 else ends[::-1]), low, high, texture)


def wall_across(
    stage: Stage, s: float, t: float, width: float, low: float, high: float, texture: Texture, side: int
) -> None:
    """Put up a wall across, from ``t`` metres beside the path outwards, that is seen by who comes along."""
    ends = ((s, t + width), (s, t)) if side > 0 else ((s, -t), (s, -t - width))
    stage.wall(*ends, low, high, texture)


def put_building(stage: Stage, dice: Dice, side: int, s: float, extent: float) -> None:
    """Put up a building, low or high, near or set back, with what hangs on its walls."""
    style = draw_style(dice)
    t = dice.between(3.4, 5.5) if dice.chance(0.6) else dice.between(6, 12)
    high = style.storeys * STOREY + 0.9
    depth = dice.between(9, 15)
    lit_side = 256 if side > 0 else 214
    wall_along(stage, side, s, s + extent, t, 0, STOREY, paint_street(dice, style, extent).bake(lit_side))
    wall_along(stage, side, s, s + extent, t, STOREY, high, paint_upper(dice, style, extent).bake(lit_side))
    wall_across(stage, s, t, depth, 0, STOREY, paint_street(dice, style, depth).bake(196), side)
    wall_across(stage, s, t, depth, STOREY, high, paint_upper(dice, style, depth).bake(196), side)
    stage.shade(s + extent / 2, side * (t + depth / 2), extent - 1.5, depth - 1.5, 0, high)
    for spot in range(int(extent / 7)):
        stage.lamp(s + 3.5 + spot * 7, side * (t - 1.2), 2.6, dice.between(0.05, 0.5))
    if dice.chance(0.5):
        _hang_awning(stage, dice, style, side, s, extent, t)
    if dice.chance(0.4):
        _set_portico(stage, dice, style, side, s, extent, t)
    for _ in range(int(extent / 6)):
        if dice.chance(0.6):
            _hang_sign(stage, dice, side, s + dice.between(0.5, extent - 0.5), t)


def _hang_awning(stage: Stage, dice: Dice, style: Style, side: int, s: float, extent: float, t: float) -> None:
    """Hang a canopy out over the doors."""
    start, long = s + dice.between(0, extent * 0.4), dice.between(3, extent * 0.55)
    reach = dice.between(0.9, 1.8)
    canvas = Canvas(long, 0.5, 40.0, style.accent)
    for number in range(int(long / 0.8)):
        canvas.rect(number * 0.8, 0, 0.4, 0.5, toned(style.accent, 320 if dice.chance(0.9) else 200))
    canvas.text(0.4, 0.1, 0.3, dice.pick(WORDS), (245, 243, 238))
    wall_along(stage, side, start, start + long, t - reach, 2.75, 3.2, canvas.bake())
    cover = plain(toned(style.accent, 170), dice)
    wall_across(stage, start, t - reach, reach, 2.75, 3.2, cover, side)
    stage.slab(start, t - reach if side > 0 else -t, long, reach, 2.75, cover, roof=True)


def _set_portico(stage: Stage, dice: Dice, style: Style, side: int, s: float, extent: float, t: float) -> None:
    """Carry the first floor's edge on columns."""
    reach = min(dice.between(1.2, 2.2), t - 3.0)
    if reach < 0.6:
        return
    column = plain(tinted(dice, style.trim, 6), dice)
    fascia = Canvas(extent, 0.7, 30.0, style.trim)
    WALLS[style.material][0](fascia, dice)
    wall_along(stage, side, s, s + extent, t - reach, STOREY, STOREY + 0.7, fascia.bake())
    wall_across(stage, s, t - reach, reach, STOREY, STOREY + 0.7, column, side)
    stage.slab(s, t - reach if side > 0 else -t, extent, reach, STOREY, column, roof=True)
    width = dice.between(0.3, 0.6)
    for number in range(int(extent / 3.4) + 1):
        stage.box(s + 0.4 + number * 3.4, side * (t - reach + width / 2), width, width, STOREY, column, column, None)


def _hang_sign(stage: Stage, dice: Dice, side: int, s: float, t: float) -> None:
    """Let a sign or banner stick out of a wall, to be read by who comes along."""
    width, high, low = dice.between(0.6, 1.1), dice.between(0.6, 2.4), dice.between(2.4, 3.4)
    colour = dice.pick(ACCENTS)
    canvas = Canvas(width, high, 50.0, colour)
    canvas.frame(0, 0, width, high, 0.05, toned(colour, 170))
    canvas.disc(width / 2, high * 0.6, width * 0.28, tinted(dice, (230, 228, 220), 20))
    canvas.text(0.08, 0.12, 0.22, dice.pick(WORDS)[:4], (245, 243, 238))
    canvas.ink[:] = 110
    wall_across(stage, s, t - width, width, low, low + high, canvas.bake(), side)


def plant_garden(stage: Stage, dice: Dice, green: Greenery, side: int, s: float, extent: float) -> None:
    """Raise a bed behind a low wall, full of shrubs and grasses, with a few trees."""
    t, high = dice.between(2.7, 3.6), dice.between(0.3, 0.9)
    wall = props.planter_side(dice, extent, high)
    wall_along(stage, side, s, s + extent, t, 0, high, wall.bake(240))
    wall_across(stage, s, t, 7.0, 0, high, props.planter_side(dice, 7.0, high).bake(200), side)
    stage.slab(s, t if side > 0 else -t - 7.0, extent, 7.0, high, plain((92, 78, 58), dice, 4.0))
    for _ in range(int(extent * 2.2)):
        size = dice.between(0.6, 1.5)
        plant = dice.pick(green.shrubs if dice.chance(0.6) else green.grasses)
        stage.cutout(
            s + dice.between(0.3, extent - 0.3), side * (t + dice.between(0.5, 5.5)),
            2.2 * size * dice.pick((1, -1)), high + 1.5 * size, plant, low=high - 0.05,
        )  # fmt: skip
    for _ in range(int(extent / 4)):
        put_tree(stage, dice, green, s + dice.between(0.5, extent - 0.5), side * (t + dice.between(1.5, 6)))


def put_tree(stage: Stage, dice: Dice, green: Greenery, s: float, t: float) -> None:
    """Plant a tree or a palm."""
    kind, wide = (green.trees, 6.0) if dice.chance(0.65) else (green.palms, 5.0)
    size = dice.between(0.65, 1.3)
    stage.cutout(s, t, wide * size * dice.pick((1, -1)), 8.0 * size, dice.pick(kind))
    stage.shade(s, t, 3.6 * size, 3.6 * size, 3.0 * size, 7.0 * size)


def plant_grove(stage: Stage, dice: Dice, green: Greenery, side: int, s: float, extent: float) -> None:
    """Plant trees of a kind in a row, others behind, shrubs between."""
    for number in range(int(extent / 3.6)):
        put_tree(stage, dice, green, s + 1.5 + number * 3.6, side * dice.between(3.6, 5.0))
    for _ in range(int(extent * 1.3)):
        size = dice.between(0.5, 1.3)
        stage.cutout(
            s + dice.between(0, extent), side * dice.between(3.2, 11), 2.4 * size, 1.6 * size, dice.pick(green.shrubs)
        )
    for _ in range(int(extent / 1.8)):
        put_tree(stage, dice, green, s + dice.between(0, extent), side * dice.between(7, 18))


def set_plaza(stage: Stage, dice: Dice, green: Greenery, side: int, s: float, extent: float) -> None:
    """Open a square with parasols, steps and a building at its back."""
    back = dice.between(11, 15)
    style = draw_style(dice)
    wall_along(stage, side, s, s + extent, back, 0, STOREY, paint_street(dice, style, extent).bake(236))
    wall_along(stage, side, s, s + extent, back, STOREY, style.storeys * STOREY + 0.9,
           paint_upper(dice, style, extent).bake(236))  # fmt: skip
    stage.shade(s + extent / 2, side * (back + 4), extent - 1.5, 6.5, 0, style.storeys * STOREY)
    for _ in range(int(extent / 4)):
        stage.cutout(
            s + dice.between(1, extent - 1), side * dice.between(4.5, 8.5), 4.0, 3.0, props.parasol(dice).bake()
        )
    if dice.chance(0.6):
        width = extent * 0.5
        start = s + dice.between(0, extent - width)
        for step in range(3):
            tread = plain(tinted(dice, (176, 172, 164), 10), dice, 3.0)
            stage.box(start + width / 2, side * (back - 1.2 + step * 0.4), width, 2.0 - step * 0.4,
                      0.17 * (step + 1), tread, tread, tread)  # fmt: skip
    for _ in range(3):
        put_tree(stage, dice, green, s + dice.between(0, extent), side * dice.between(6, 10))
    stage.lamp(s + extent / 2, side * (back - 2), 3.0, 0.8)


def fence_in(stage: Stage, dice: Dice, green: Greenery, side: int, s: float, extent: float) -> None:
    """Run a railing, an overgrown fence or a hedge along the path, trees behind it."""
    t = dice.between(2.7, 3.4)
    kind = dice.below(3)
    if kind == 0:
        high = dice.between(1.9, 2.8)
        texture = plants.vines(dice, green.season, extent, high).bake()
    elif kind == 1:
        high = dice.between(1.0, 1.3)
        texture = props.railing(dice, extent, high).bake()
    else:
        high = dice.between(1.0, 2.2)
        texture = plants.hedge(dice, green.season, extent, high).bake()
    ends = ((s, side * t), (s + extent, side * t))
    stage.wall(*(ends if side > 0 else ends[::-1]), 0, high, texture, "both")
    for _ in range(int(extent / 1.6)):
        put_tree(stage, dice, green, s + dice.between(0, extent), side * (t + dice.between(1.5, 12)))
    for _ in range(int(extent * 0.7)):
        size = dice.between(0.6, 1.4)
        stage.cutout(s + dice.between(0, extent), side * (t + dice.between(0.8, 5)), 2.4 * size, 1.6 * size,
                     dice.pick(green.shrubs))  # fmt: skip
