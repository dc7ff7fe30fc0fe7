"""What stands at the edge of the path: lamps, bins, signs, benches, planters, and marks on the ground."""

from vpr_datasets.simulation import props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import ACCENTS
from vpr_datasets.simulation.lots import Greenery, plain, put_tree
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas


def furnish(stage: Stage, dice: Dice, green: Greenery, length: float) -> None:
    """Stand something beside the path every few steps, and lamps at regular distances."""
    posts = [props.lamp_post(Dice(dice.below(1 << 30), "post")).bake() for _ in range(3)]
    s, side = -6.0, 1
    while s < length + 30:
        t = side * (stage.half_width(s) + 0.35)
        stage.cutout(s, t, 1.6, 4.6, dice.pick(posts))
        stage.lamp(s, t, 4.1, 1.0)
        s += dice.between(11, 21)
        side = -side if dice.chance(0.7) else side
    s = -8.0
    while s < length + 30:
        s += dice.between(0.9, 2.4)
        side = dice.pick((1, -1))
        _put_piece(stage, dice, green, s, side, stage.half_width(s))


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
        put_tree(stage, dice, green, s, side * (half + 0.9))
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
