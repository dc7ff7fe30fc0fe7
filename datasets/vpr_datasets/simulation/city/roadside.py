"""What stands at the edge of a road all year: trees, lamps, lights, signs, shelters, columns, café tables."""

from vpr_datasets.simulation import plants, props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city import kit
from vpr_datasets.simulation.city.roads import Profile
from vpr_datasets.simulation.city.trees import TALL, WIDE, street_tree
from vpr_datasets.simulation.lots import plain
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Texture

Junctions = list[tuple[float, float]]


def furnish(stage: Stage, dice: Dice, season: Season, profile: Profile, junctions: Junctions, length: float) -> None:
    """Furnish the road from some way before its first place to ``length`` metres along it."""
    trees = [street_tree(dice.branch(), season).bake() for _ in range(9)]
    for t in profile.trees:
        _plant(stage, dice, trees, t, junctions, length)
    _light(stage, dice, profile, length)
    for junction in junctions:
        _guard(stage, dice, profile, junction)
    makers = [kit.sign(dice).bake() for _ in range(14)]
    for side in (1, -1):
        s = -20.0
        while s < length:
            s += dice.between(3.5, 10.0)
            if not near(s, junctions, 4.0):
                _put_piece(stage, dice, profile, makers, side, s)


def near(s: float, junctions: Junctions, margin: float) -> bool:
    """Say whether a place lies on a junction, or nearer to one than ``margin`` metres."""
    return any(first - margin < s < last + margin for first, last in junctions)


def _plant(stage: Stage, dice: Dice, trees: list[Texture], t: float, junctions: Junctions, length: float) -> None:
    """Plant a row of trees, with gaps where some have gone."""
    pit = plain((112, 96, 76), dice, 1.6)
    s = -26.0 + dice.between(0, 8)
    while s < length:
        s += dice.between(12.0, 19.0)
        if near(s, junctions, 5.0) or dice.chance(0.15):
            continue
        size = dice.between(0.95, 1.35)
        place = t + dice.between(-0.2, 0.2)
        stage.cutout(s, place, WIDE * size * dice.pick((1, -1)), TALL * size, dice.pick(trees))
        stage.slab(s - 0.8, place - 0.8, 1.6, 1.6, 0.012, pit)
        stage.shade(s, place, 3.4 * size, 3.4 * size, 3.6 * size, 7.6 * size)


def _light(stage: Stage, dice: Dice, profile: Profile, length: float) -> None:
    """Stand lamp posts at regular distances."""
    right, left = -profile.verge(-1), profile.verge(1)
    tall = dice.between(6.5, 8.5)
    posts = [kit.lamp(dice, tall).bake() for _ in range(2)]
    s = -15.0
    while s < length:
        for t, way in ((right - 0.6, -1), (left + 0.6, 1)):
            stage.cutout(s, t, 4.4 * way, tall, dice.pick(posts))
            stage.lamp(s, t - way * 1.5, tall - 0.3, 1.6)
        s += 31.0


def _guard(stage: Stage, dice: Dice, profile: Profile, junction: tuple[float, float]) -> None:
    """Put lights and names at a junction."""
    right, left = -profile.verge(-1), profile.verge(1)
    first, last = junction
    light, mast = kit.traffic_light(dice).bake(), kit.mast_light().bake()
    ahead = ((first - 4.4, right - 0.5), (last + 3.6, right - 0.5), (first - 4.4, left + 0.5), (last + 3.6, left + 0.5))
    for s, t in ahead:
        stage.cutout(s, t, 1.2, 3.6, light)
    stage.wall((last + 4.6, right + 4.3), (last + 4.6, right - 0.7), 0, 6.0, mast, "both")
    for low, high in profile.islands:
        stage.cutout(first - 4.4, (low + high) / 2, 1.2, 3.6, light)
    for s, t in ((first - 1.4, right - 1.6), (last + 1.2, left + 1.6)):
        stage.cutout(s, t, 2.2, 3.0, kit.name_sign(dice).bake())


def _put_piece(stage: Stage, dice: Dice, profile: Profile, signs: list[Texture], side: int, s: float) -> None:
    """Put one thing on the pavement: most of them at the kerb, some before the houses."""
    edge = profile.verge(side) + dice.between(0.4, 0.8)
    front = profile.front(side)
    kind = dice.below(17)
    if kind <= 3:
        stage.cutout(s, side * edge, 1.4, 3.0 * dice.between(0.9, 1.05), dice.pick(signs))
    elif kind == 4:
        stage.cutout(s, side * (edge + 0.3), 1.5, 3.7, kit.column(dice).bake())
    elif kind == 5:
        _put_shelter(stage, dice, side, s, edge)
    elif kind <= 7:
        orange = dice.pick(((222, 110, 30), (222, 110, 30), (70, 74, 76)))
        stage.cutout(s, side * edge, 0.55, 1.25, props.bin_side(dice, orange).bake())
    elif kind == 8:
        width, high = dice.between(0.6, 1.4), dice.between(0.9, 1.4)
        box, top = kit.switch_box(dice, width, high).bake(), plain((140, 140, 134), dice)
        stage.box(s, side * (edge + 0.2), width, 0.45, high, box, box, top)
    elif kind == 9:
        bicycles = [props.bicycle(dice).bake() for _ in range(3)]
        for number in range(3 + dice.below(4)):
            place = s + number * 0.8
            stage.wall(
                (place, side * (edge + 1.5)), (place + 0.4, side * (edge + 0.2)), 0, 1.1, dice.pick(bicycles), "both"
            )
    elif kind == 10:
        post = plain(dice.pick(((60, 62, 66), (120, 40, 36), (190, 188, 180))), dice)
        for number in range(4):
            stage.box(s + number * 1.3, side * edge, 0.14, 0.14, 0.95, post, post, post)
    elif kind <= 12:
        for number in range(1 + dice.below(3)):
            stage.cutout(
                s + number * 3.2, side * (front - dice.between(1.6, 2.6)), 3.2, 2.6, props.parasol(dice).bake()
            )
    elif kind == 13:
        wide = 1.9
        board, post = kit.poster(dice, wide, 2.4).bake(), plain((84, 86, 88), dice)
        stage.wall((s, side * edge + wide / 2), (s, side * edge - wide / 2), 0.7, 3.1, board, "both")
        stage.box(s, side * edge, 0.2, 0.3, 0.7, post, post, None)
    elif kind == 14:
        long, high = dice.between(1.2, 2.2), 0.6
        box = props.planter_side(dice, long, high).bake()
        stage.box(s, side * (front - 1.0), long, 0.6, high, box, box, plain((92, 78, 58), dice))
        for number in range(int(long / 0.5)):
            stage.cutout(s - long / 2 + 0.3 + number * 0.5, side * (front - 1.0), 1.2, high + 0.9,
                         plants.shrub(dice, "summer").bake(), low=high - 0.05)  # fmt: skip
    elif kind == 15:
        middle = front - 3.4
        stage.cutout(s, side * (middle - 1.2), 1.0, 3.6, kit.underground(dice).bake())
        rail = props.railing(dice, 5.0, 1.1).bake()
        for t in (middle - 1.1, middle + 1.1):
            stage.wall((s + 0.5, side * t), (s + 5.5, side * t), 0, 1.1, rail, "both")
        stage.slab(s + 0.6, side * middle - 1.0, 4.8, 2.0, 0.02, plain((36, 36, 38), dice))
    else:
        bench = props.bench(dice).bake()
        ends = ((s - 0.9, side * (edge + 0.4)), (s + 0.9, side * (edge + 0.4)))
        stage.wall(*(ends if side > 0 else ends[::-1]), 0, 0.95, bench, "both")


def _put_shelter(stage: Stage, dice: Dice, side: int, s: float, edge: float) -> None:
    """Put up a bus stop: a glass shelter with a lit poster, and the H."""
    stage.cutout(s - 3.2, side * edge, 0.9, 3.0, kit.stop_post().bake())
    inner, outer = side * (edge + 0.3), side * (edge + 1.6)
    glass = props.railing(dice, 4.0, 2.3)
    glass.frame(0, 0, 4.0, 2.3, 0.07, (90, 94, 96))
    board = kit.poster(dice, 1.2, 1.8).bake()
    stage.wall((s - 2, outer), (s + 2, outer), 0.1, 2.4, glass.bake(), "both")
    stage.wall((s + 2, inner), (s + 2, outer), 0.4, 2.2, board, "both")
    roof = plain((110, 114, 118), dice)
    stage.slab(s - 2.1, min(inner, outer) - 0.1, 4.2, 1.5, 2.45, roof, roof=True)
    rim = plain((60, 64, 68), dice)
    stage.wall((s - 2.1, inner), (s + 2.1, inner), 2.38, 2.55, rim, "both")
    stage.wall((s - 2.1, max(inner, outer)), (s - 2.1, min(inner, outer)), 2.38, 2.55, rim, "both")
    bench = props.bench(dice).bake()
    stage.wall((s - 1.6, outer - side * 0.3), (s + 1.0, outer - side * 0.3), 0, 0.6, bench, "both")
