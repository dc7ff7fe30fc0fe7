"""People on bicycles."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.vehicles import PAINTS, RUBBER
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.texture import Canvas, Colour


def cyclist(dice: Dice, colours: tuple[Colour, ...] = PAINTS) -> Canvas:
    """Paint somebody on a bicycle, as seen from behind or in front; 0.8 m wide and 1.8 m tall."""
    canvas = Canvas(0.8, 1.8, 60.0)
    shirt = tinted(dice, dice.pick((*colours, (190, 60, 50), (60, 120, 170), (220, 180, 60))), 14)
    skin = dice.pick(((226, 186, 160), (188, 142, 112), (130, 92, 72)))
    canvas.rect(0.375, 0.0, 0.05, 0.7, RUBBER)
    canvas.rect(0.36, 0.62, 0.08, 0.3, (70, 72, 76))
    canvas.rect(0.14, 0.98, 0.52, 0.04, (60, 62, 64))
    trousers = dice.pick(((40, 46, 66), (52, 52, 54), (110, 96, 80)))
    canvas.polygon([(0.26, 0.9), (0.4, 0.9), (0.36, 0.25), (0.26, 0.25)], trousers)
    canvas.polygon([(0.4, 0.9), (0.54, 0.9), (0.54, 0.45), (0.44, 0.45)], toned(trousers, 220))
    canvas.polygon([(0.25, 0.85), (0.55, 0.85), (0.6, 1.4), (0.2, 1.4)], shirt)
    for x0, x1 in ((0.22, 0.17), (0.58, 0.63)):
        canvas.line(x0, 1.35, x1, 1.02, 0.09, toned(shirt, 210))
    canvas.disc(0.4, 1.56, 0.12, skin)
    canvas.disc(0.4, 1.61, 0.12, dice.pick(((40, 32, 28), (110, 80, 50), (200, 200, 196), (180, 40, 40))))
    canvas.rect(0.36, 0.7, 0.08, 0.06, (200, 30, 30), 160)
    return canvas
