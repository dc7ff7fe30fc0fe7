"""Laying out a campus along the path: lots on both sides, structures overhead, furniture, lamps."""

from dataclasses import dataclass

from vpr_datasets.simulation import plants, props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import ACCENTS, STOREY, WORDS, Style, draw_style, paint_street, paint_upper
from vpr_datasets.simulation.materials import CONCRETE, WALLS, WOOD, tinted, toned
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.stage import Floor, Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

PAVINGS = ("asphalt", "concrete", "slabs", "large slabs", "brick", "boards", "cobbles", "tiles")


@dataclass(frozen=True)
class Greenery:
    """Plants of a season, each in a few shapes that are used again and again."""

    trees: list[Texture]
    palms: list[Texture]
    shrubs: list[Texture]
    grasses: list[Texture]


def _grow(seed: int, season: Season) -> Greenery:
    def several(kind: str, count: int) -> list[Texture]:
        paint = {"tree": plants.tree, "palm": plants.palm, "shrub": plants.shrub, "grass": plants.grasses}[kind]
        return [paint(Dice(seed, kind, number), season).bake() for number in range(count)]

    return Greenery(several("tree", 7), several("palm", 4), several("shrub", 7), several("grass", 4))


def plain(colour: Colour, dice: Dice, size: float = 1.0) -> Texture:
    """Return a small speckled texture of one colour."""
    canvas = Canvas(size, size, 24.0, colour)
    canvas.speckle(dice, 12)
    return canvas.bake()


def lay_out(seed: int, season: Season, course: Course, length: float) -> Stage:
    """Build the scene from ``-20`` to ``length`` metres along the path."""
    stage = Stage(course)
    green = _grow(seed, season)
    dice = Dice(seed, "layout")
    _lay_floors(stage, dice, length)
    for side in (1, -1):
        _line_side(stage, Dice(seed, "side", side + 1), green, season, side, length)
    _span(stage, Dice(seed, "overhead"), length)
    _furnish(stage, Dice(seed, "furniture"), green, length)
    _close(stage, Dice(seed, "end"), length)
    return stage


def _half(stage: Stage, s: float) -> float:
    """Return half the width of the path at ``s``."""
    return next((floor.half for floor in stage.floors if floor.start <= s < floor.stop), 2.2)


def _lay_floors(stage: Stage, dice: Dice, length: float) -> None:
    s, last = -24.0, ""
    while s < length + 60:
        extent = dice.between(7, 19)
        middle = dice.pick([name for name in PAVINGS if name != last])
        left, right = (dice.pick(("grass", "mulch", "gravel", "slabs", "concrete", "brick", "grass")) for _ in "lr")
        stage.floors.append(Floor(s, s + extent, dice.between(1.9, 3.0), middle, left, right))
        s, last = s + extent, middle


def _line_side(
    stage: Stage, dice: Dice, green: Greenery, season: Season, side: int, length: float
) -> None:
    """Fill one side of the path with lots, no two of a kind in succession but buildings."""
    s = -20.0 + dice.between(0, 6)
    deck: list[str] = []
    while s < length + 50:
        if not deck:
            deck = dice.shuffled(
                ("building", "building", "building", "building", "garden", "plaza", "fence", "grove", "fence")
            )
        kind = deck.pop()
        if kind == "building":
            extent = dice.between(6, 15)
            _put_building(stage, dice, side, s, extent)
        elif kind == "garden":
            extent = dice.between(7, 13)
            _plant_garden(stage, dice, green, season, side, s, extent)
        elif kind == "grove":
            extent = dice.between(9, 15)
            _plant_grove(stage, dice, green, side, s, extent)
        elif kind == "plaza":
            extent = dice.between(10, 15)
            _set_plaza(stage, dice, green, side, s, extent)
        else:
            extent = dice.between(7, 12)
            _fence_in(stage, dice, green, season, side, s, extent)
        s += extent + (dice.between(0.2, 3.0) if dice.chance(0.6) else 0.0)


def _front(stage: Stage, side: int, s0: float, s1: float, t: float, low: float, high: float, texture: Texture) -> None:
    """Put up a wall along the path that is seen from the path."""
    ends = ((s0, side * t), (s1, side * t))
    stage.wall(*(ends if side > 0 else ends[::-1]), low, high, texture)


def _end(stage: Stage, s: float, t: float, width: float, low: float, high: float, texture: Texture, side: int) -> None:
    """Put up a wall across, from ``t`` metres beside the path outwards, that is seen by who comes along."""
    ends = ((s, t + width), (s, t)) if side > 0 else ((s, -t), (s, -t - width))
    stage.wall(*ends, low, high, texture)


def _put_building(stage: Stage, dice: Dice, side: int, s: float, extent: float) -> None:
    style = draw_style(dice)
    t = dice.between(3.4, 5.5) if dice.chance(0.6) else dice.between(6, 12)
    high = style.storeys * STOREY + 0.9
    depth = dice.between(9, 15)
    lit_side = 256 if side > 0 else 214
    _front(stage, side, s, s + extent, t, 0, STOREY, paint_street(dice, style, extent).bake(lit_side))
    _front(stage, side, s, s + extent, t, STOREY, high, paint_upper(dice, style, extent).bake(lit_side))
    _end(stage, s, t, depth, 0, STOREY, paint_street(dice, style, depth).bake(196), side)
    _end(stage, s, t, depth, STOREY, high, paint_upper(dice, style, depth).bake(196), side)
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
    _front(stage, side, start, start + long, t - reach, 2.75, 3.2, canvas.bake())
    cover = plain(toned(style.accent, 170), dice)
    _end(stage, start, t - reach, reach, 2.75, 3.2, cover, side)
    stage.slab(start, t - reach if side > 0 else -t, long, reach, 2.75, cover, roof=True)


def _set_portico(stage: Stage, dice: Dice, style: Style, side: int, s: float, extent: float, t: float) -> None:
    """Carry the first floor's edge on columns."""
    reach = min(dice.between(1.2, 2.2), t - 3.0)
    if reach < 0.6:
        return
    column = plain(tinted(dice, style.trim, 6), dice)
    fascia = Canvas(extent, 0.7, 30.0, style.trim)
    WALLS[style.material][0](fascia, dice)
    _front(stage, side, s, s + extent, t - reach, STOREY, STOREY + 0.7, fascia.bake())
    _end(stage, s, t - reach, reach, STOREY, STOREY + 0.7, column, side)
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
    _end(stage, s, t - width, width, low, low + high, canvas.bake(), side)


def _plant_garden(
    stage: Stage, dice: Dice, green: Greenery, season: Season, side: int, s: float, extent: float
) -> None:
    """Raise a bed behind a low wall, full of shrubs and grasses, with a few trees."""
    t, high = dice.between(2.7, 3.6), dice.between(0.3, 0.9)
    wall = props.planter_side(dice, extent, high)
    _front(stage, side, s, s + extent, t, 0, high, wall.bake(240))
    _end(stage, s, t, 7.0, 0, high, props.planter_side(dice, 7.0, high).bake(200), side)
    stage.slab(s, t if side > 0 else -t - 7.0, extent, 7.0, high, plain((92, 78, 58), dice, 4.0))
    for _ in range(int(extent * 2.2)):
        size = dice.between(0.6, 1.5)
        plant = dice.pick(green.shrubs if dice.chance(0.6) else green.grasses)
        stage.cutout(
            s + dice.between(0.3, extent - 0.3), side * (t + dice.between(0.5, 5.5)),
            2.2 * size * dice.pick((1, -1)), high + 1.5 * size, plant, low=high - 0.05,
        )  # fmt: skip
    for _ in range(int(extent / 4)):
        _put_tree(stage, dice, green, s + dice.between(0.5, extent - 0.5), side * (t + dice.between(1.5, 6)))


def _put_tree(stage: Stage, dice: Dice, green: Greenery, s: float, t: float) -> None:
    kind, wide = (green.trees, 6.0) if dice.chance(0.65) else (green.palms, 5.0)
    size = dice.between(0.65, 1.3)
    stage.cutout(s, t, wide * size * dice.pick((1, -1)), 8.0 * size, dice.pick(kind))
    stage.shade(s, t, 3.6 * size, 3.6 * size, 3.0 * size, 7.0 * size)


def _plant_grove(stage: Stage, dice: Dice, green: Greenery, side: int, s: float, extent: float) -> None:
    """Plant trees of a kind in a row, others behind, shrubs between."""
    for number in range(int(extent / 3.6)):
        _put_tree(stage, dice, green, s + 1.5 + number * 3.6, side * dice.between(3.6, 5.0))
    for _ in range(int(extent * 1.3)):
        size = dice.between(0.5, 1.3)
        stage.cutout(
            s + dice.between(0, extent), side * dice.between(3.2, 11), 2.4 * size, 1.6 * size, dice.pick(green.shrubs)
        )
    for _ in range(int(extent / 1.8)):
        _put_tree(stage, dice, green, s + dice.between(0, extent), side * dice.between(7, 18))


def _set_plaza(stage: Stage, dice: Dice, green: Greenery, side: int, s: float, extent: float) -> None:
    """Open a square with parasols, steps and a building at its back."""
    back = dice.between(11, 15)
    style = draw_style(dice)
    _front(stage, side, s, s + extent, back, 0, STOREY, paint_street(dice, style, extent).bake(236))
    _front(stage, side, s, s + extent, back, STOREY, style.storeys * STOREY + 0.9,
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
        _put_tree(stage, dice, green, s + dice.between(0, extent), side * dice.between(6, 10))
    stage.lamp(s + extent / 2, side * (back - 2), 3.0, 0.8)


def _fence_in(
    stage: Stage, dice: Dice, green: Greenery, season: Season, side: int, s: float, extent: float
) -> None:
    """Run a railing, an overgrown fence or a hedge along the path, trees behind it."""
    t = dice.between(2.7, 3.4)
    kind = dice.below(3)
    if kind == 0:
        high = dice.between(1.9, 2.8)
        texture = plants.vines(dice, season, extent, high).bake()
    elif kind == 1:
        high = dice.between(1.0, 1.3)
        texture = props.railing(dice, extent, high).bake()
    else:
        high = dice.between(1.0, 2.2)
        texture = plants.hedge(dice, season, extent, high).bake()
    ends = ((s, side * t), (s + extent, side * t))
    stage.wall(*(ends if side > 0 else ends[::-1]), 0, high, texture, "both")
    for _ in range(int(extent / 1.6)):
        _put_tree(stage, dice, green, s + dice.between(0, extent), side * (t + dice.between(1.5, 12)))
    for _ in range(int(extent * 0.7)):
        size = dice.between(0.6, 1.4)
        stage.cutout(s + dice.between(0, extent), side * (t + dice.between(0.8, 5)), 2.4 * size, 1.6 * size,
                     dice.pick(green.shrubs))  # fmt: skip


def _span(stage: Stage, dice: Dice, length: float) -> None:
    """Build over the path every few dozen metres: underpasses, bridges, pergolas, canopies, gates."""
    s = dice.between(10, 20)
    deck: list[str] = []
    while s < length + 20:
        if not deck:
            deck = dice.shuffled(("underpass", "bridge", "pergola", "canopy", "gate"))
        kind = deck.pop()
        if kind == "underpass":
            s += _put_underpass(stage, dice, s)
        elif kind == "bridge":
            s += _put_bridge(stage, dice, s)
        elif kind == "pergola":
            s += _put_pergola(stage, dice, s)
        elif kind == "canopy":
            s += _put_canopy(stage, dice, s)
        else:
            s += _put_gate(stage, dice, s)
        s += dice.between(9, 22)


def _put_underpass(stage: Stage, dice: Dice, s: float) -> float:
    """Lead the path through a building."""
    extent, half = dice.between(9, 14), max(_half(stage, s), 2.6) + 0.5
    style, high = draw_style(dice), dice.between(2.9, 3.5)
    for side in (1, -1):
        _front(stage, side, s, s + extent, half, 0, high, paint_street(dice, style, extent).bake(230))
        _end(stage, s, half, 4.0, 0, high, paint_street(dice, style, 4.0).bake(200), side)
    wide = half + 4.0
    upper = paint_upper(dice, style, 2 * wide)
    stage.wall((s, wide), (s, -wide), high, high + upper.height, upper.bake(196))
    ceiling = Canvas(extent, 2 * half, 24.0, toned(style.trim, 220))
    ceiling.speckle(dice, 18, 1.0)
    for number in range(int(extent / 2.5)):
        ceiling.rect(1.0 + number * 2.5, half - 0.6, 0.3, 1.2, (246, 244, 232), 254)
        stage.lamp(s + 1.2 + number * 2.5, 0.0, high, 0.5)
    stage.slab(s, -half, extent, 2 * half, high, ceiling.bake(), roof=True)
    stage.shade(s + extent / 2, 0, extent - 1, 2 * wide - 1, high, high + upper.height)
    stage.floors.insert(0, Floor(s, s + extent, half, dice.pick(("tiles", "asphalt", "large slabs")), "concrete", "concrete"))
    return extent


def _put_bridge(stage: Stage, dice: Dice, s: float) -> float:
    """Lead a footbridge over the path."""
    level, extent, wide = dice.between(3.6, 4.6), dice.between(2.2, 3.5), 9.0
    colour = tinted(dice, dice.pick((*CONCRETE, *ACCENTS)), 10)
    beam = Canvas(2 * wide, 0.7, 30.0, colour)
    beam.speckle(dice, 20, 0.8)
    beam.text(wide - 2.5, 0.18, 0.36, dice.pick(WORDS), (244, 242, 236))
    deck = plain(toned(colour, 150), dice, 3.0)
    rail = props.railing(dice, 2 * wide, 1.15).bake()
    for place in (s, s + extent):
        stage.wall((place, wide), (place, -wide), level, level + 0.7, beam.bake(210), "both")
        stage.wall((place, wide), (place, -wide), level + 0.7, level + 1.85, rail, "both")
    stage.slab(s, -wide, extent, 2 * wide, level, deck, roof=True)
    pillar = plain(toned(colour, 220), dice)
    for t in (-1, 1):
        stage.box(s + extent / 2, t * (_half(stage, s) + 0.9), 0.6, 0.6, level, pillar, pillar, None)
    return extent


def _put_pergola(stage: Stage, dice: Dice, s: float) -> float:
    """Set posts on both sides with beams across."""
    count, gap = 4 + dice.below(4), dice.between(1.2, 2.2)
    half, high = max(_half(stage, s), 2.2) + 0.4, dice.between(2.7, 3.3)
    texture = plain(tinted(dice, dice.pick((*WOOD, *ACCENTS)), 12), dice)
    for number in range(count):
        place = s + number * gap
        for t in (half, -half):
            stage.box(place, t, 0.16, 0.16, high, texture, texture, None)
        stage.wall((place, half + 0.4), (place, -half - 0.4), high, high + 0.24, texture, "both")
    for t in (half, -half):
        stage.wall((s - 0.4, t), (s + (count - 1) * gap + 0.4, t), high - 0.2, high, texture, "both")
    return count * gap


def _put_canopy(stage: Stage, dice: Dice, s: float) -> float:
    """Put a flat roof on slanting posts over half of the path."""
    extent, side = dice.between(5, 9), dice.pick((1, -1))
    level, half = dice.between(2.8, 3.6), _half(stage, s)
    colour = dice.pick(ACCENTS)
    roof = plain(toned(colour, 200), dice, 4.0)
    start = -half - 0.8 if side < 0 else -0.4
    stage.slab(s, start, extent, half + 1.2, level, roof, roof=True)
    edge = Canvas(half + 1.2, 0.35, 40.0, colour)
    stage.wall((s, start + half + 1.2), (s, start), level, level + 0.35, edge.bake(230), "both")
    rim = Canvas(extent, 0.35, 40.0, colour)
    rim.text(0.5, 0.06, 0.22, dice.pick(WORDS), (244, 242, 236))
    for t in (start, start + half + 1.2):
        ends = ((s + extent, t), (s, t)) if t <= 0 else ((s, t), (s + extent, t))
        stage.wall(*ends, level, level + 0.35, rim.bake(), "both")
    post = plain((190, 190, 186), dice)
    for number in range(int(extent / 2.5) + 1):
        stage.box(s + 0.3 + number * 2.4, side * (half + 0.5), 0.18, 0.18, level, post, post, None)
    stage.lamp(s + extent / 2, side * half, level, 0.6)
    return extent


def _put_gate(stage: Stage, dice: Dice, s: float) -> float:
    """Put a gate with a sign across the path."""
    half, high = _half(stage, s) + 0.6, dice.between(2.7, 3.4)
    colour = dice.pick(ACCENTS)
    post = plain(tinted(dice, dice.pick((*CONCRETE, colour)), 8), dice)
    width = dice.between(0.3, 1.0)
    for t in (half, -half):
        stage.box(s, t, 0.5, width, high + 0.3, post, post, None)
    sign = Canvas(2 * half, 0.9, 40.0, colour)
    words = dice.pick(WORDS)
    sign.text(half - len(words) * 0.21, 0.22, 0.5, words, (244, 242, 236))
    sign.ink[:] = 90
    stage.wall((s, half), (s, -half), high, high + 0.9, sign.bake(220), "both")
    return 1.0


def _furnish(stage: Stage, dice: Dice, green: Greenery, length: float) -> None:
    """Stand something beside the path every few steps, and lamps at regular distances."""
    posts = [props.lamp_post(Dice(dice.below(1 << 30), "post")).bake() for _ in range(3)]
    s, side = -6.0, 1
    while s < length + 30:
        t = side * (_half(stage, s) + 0.35)
        stage.cutout(s, t, 1.6, 4.6, dice.pick(posts))
        stage.lamp(s, t, 4.1, 1.0)
        s += dice.between(11, 21)
        side = -side if dice.chance(0.7) else side
    s = -8.0
    while s < length + 30:
        s += dice.between(0.9, 2.4)
        side = dice.pick((1, -1))
        _put_piece(stage, dice, green, s, side, _half(stage, s))


def _put_piece(stage: Stage, dice: Dice, green: Greenery, s: float, side: int, half: float) -> None:
    """Put down one piece of furniture beside the path."""
    t = side * (half + dice.between(0.3, 0.8))
    kind = dice.below(11)
    if kind <= 1:
        colour = dice.pick(ACCENTS)
        texture, lid = props.bin_side(dice, colour).bake(), plain(toned(colour, 150), dice)
        for number in range(1 + dice.below(3)):
            stage.box(s + number * 0.8, t, 0.7, 0.7, 1.2, texture, texture, lid)
    elif kind == 2:
        stage.cutout(s, t, 1.2, dice.between(2.2, 2.9), props.sign_post(dice).bake())
    elif kind == 3:
        width = dice.between(1.2, 2.0)
        ends = ((s, t + width / 2), (s, t - width / 2)) if dice.chance(0.5) else ((s, t), (s + width, t))
        stage.wall(*ends, 0, 2.2, props.board(dice, width).bake(), "both")
    elif kind == 4:
        high = dice.between(1.5, 2.0)
        body = plain(tinted(dice, dice.pick(ACCENTS), 10), dice)
        front = props.machine(dice, 1.0, high).bake()
        stage.box(s, t + side * 0.3, 1.0, 0.8, high, front, body, body)
    elif kind <= 6:
        long, high = dice.between(1.2, 3.0), dice.between(0.4, 0.9)
        box = props.planter_side(dice, long, high).bake()
        stage.box(s, t + side * 0.3, long, 0.8, high, box, box, plain((92, 78, 58), dice))
        for number in range(int(long / 0.6)):
            size = dice.between(0.3, 0.8)
            plant = dice.pick(green.shrubs if dice.chance(0.6) else green.grasses)
            stage.cutout(s - long / 2 + 0.3 + number * 0.6, t + side * 0.3, 2.2 * size * dice.pick((1, -1)),
                         high + 1.5 * size, plant, low=high - 0.05)  # fmt: skip
    elif kind == 7:
        ends = ((s - 0.9, t), (s + 0.9, t))
        stage.wall(*(ends if side > 0 else ends[::-1]), 0, 0.95, props.bench(dice).bake(), "both")
    elif kind == 8:
        post = plain(dice.pick(((60, 62, 66), (200, 160, 40), (190, 188, 180))), dice)
        for number in range(3):
            stage.box(s + number * 0.9, side * (half + 0.15), 0.16, 0.16, 0.95, post, post, post)
    elif kind == 9:
        _put_tree(stage, dice, green, s, side * (half + 0.9))
    else:
        size = dice.between(0.7, 1.2)
        stage.cutout(s, t + side * 0.5, 2.4 * size, 1.6 * size, dice.pick(green.shrubs))
    if dice.chance(0.35):
        patch = Canvas(dice.between(0.6, 2.2), dice.between(0.5, 1.6), 40.0)
        colour = tinted(dice, dice.pick(((70, 70, 72), (150, 64, 54), (206, 200, 186), (196, 160, 60))), 12)
        if dice.chance(0.5):
            patch.disc(patch.width / 2, patch.height / 2, min(patch.width, patch.height) * 0.46, colour)
        else:
            patch.rect(0, 0, patch.width, patch.height, colour)
            patch.frame(0, 0, patch.width, patch.height, 0.05, toned(colour, 150))
        patch.speckle(dice, 30)
        stage.slab(s, dice.between(-half + 0.2, half - 1.6), patch.width, patch.height, 0.01, patch.bake())


def _close(stage: Stage, dice: Dice, length: float) -> None:
    """End the view with a building across the path."""
    style, wide, s = draw_style(dice), 26.0, length + 55
    stage.wall((s, wide), (s, -wide), 0, STOREY, paint_street(dice, style, 2 * wide).bake(210))
    upper = paint_upper(dice, style, 2 * wide)
    stage.wall((s, wide), (s, -wide), STOREY, STOREY + upper.height, upper.bake(210))
