"""Trees of streets and canals: limes, planes and elms with high trunks and dense crowns."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import tinted
from vpr_datasets.simulation.plants import BARK, LEAVES, crown, roughen
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.texture import Canvas

WIDE, TALL = 7.0, 9.0
"""Size of the painting in metres."""


def street_tree(dice: Dice, season: Season) -> Canvas:
    """Paint a tree whose lower boughs have been cut; a bare one in winter."""
    canvas = Canvas(WIDE, TALL, 34.0)
    leaf, bark = tinted(dice, dice.pick(LEAVES[season]), 8), tinted(dice, dice.pick(BARK), 10)
    middle, bottom = WIDE / 2, dice.between(2.8, 3.6)
    lean = dice.between(-0.25, 0.25)
    for number in range(60 if season == "winter" else 14):
        reach = dice.between(0.4, 2.6) * (1 if number % 2 else -1)
        knee = middle + reach * 0.4, dice.between(bottom, bottom + 1.6)
        canvas.line(middle, dice.between(2.2, bottom + 0.4), *knee, 0.12, bark)
        canvas.line(*knee, middle + reach, dice.between(knee[1] + 0.4, TALL - 0.7), 0.06, bark)
    if season != "winter":
        width = dice.between(4.6, 6.2)
        for _ in range(3):
            # Several rounded masses, not one ball.
            left, low = middle - width / 2 + dice.between(-0.3, 0.5), bottom + dice.between(-0.3, 1.2)
            crown(canvas, dice, leaf, (left, low, width * dice.between(0.7, 1.0), TALL - 0.6 - low), 110, 0.36)
        roughen(canvas, dice, 0.3, 172)
        canvas.speckle(dice, 70, 0.14)
    foot = dice.between(0.17, 0.28)
    canvas.polygon([(middle - foot + lean, 0), (middle + foot + lean, 0), (middle + foot * 0.6, bottom + 0.8),
                    (middle - foot * 0.6, bottom + 0.8)], bark)  # fmt: skip
    canvas.speckle(dice, 22)
    return canvas
