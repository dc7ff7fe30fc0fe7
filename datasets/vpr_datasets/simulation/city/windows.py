"""Windows of old and new houses, and what is around them."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.texture import Canvas, Colour

PANES: tuple[Colour, ...] = ((52, 62, 70), (62, 76, 84), (44, 50, 58), (74, 90, 98))
CURTAIN: Colour = (206, 202, 192)


def glaze(
    canvas: Canvas, dice: Dice, x: float, y: float, width: float, height: float, frame: Colour, *, lit: float = 0.3
) -> None:
    """Glaze an opening: behind some windows a light is on after dark, or curtains are drawn."""
    glow = 90 + dice.below(140) if dice.chance(lit) else 8
    pane = tinted(dice, dice.pick(PANES), 8)
    canvas.rect(x, y, width, height, pane, glow)
    # The upper part mirrors the sky.
    canvas.rect(x, y + height * 0.55, width, height * 0.45, toned(pane, 310 + dice.below(90)), glow)
    if dice.chance(0.35):
        side = width * dice.between(0.14, 0.3)
        canvas.rect(x, y, side, height, CURTAIN, max(glow * 3 // 4, 1))
        canvas.rect(x + width - side, y, side, height, CURTAIN, max(glow * 3 // 4, 1))
    elif dice.chance(0.2):
        drop = height * dice.between(0.2, 0.9)
        canvas.rect(x, y + height - drop, width, drop, tinted(dice, CURTAIN, 14), max(glow * 3 // 4, 1))
    canvas.frame(x, y, width, height, 0.07, frame)


def sash(
    canvas: Canvas, dice: Dice, x: float, y: float, width: float, height: float, frame: Colour, *, panes: int = 2
) -> None:
    """Put in an old window, its wings divided by glazing bars."""
    glaze(canvas, dice, x, y, width, height, frame)
    for number in range(1, panes):
        canvas.rect(x + width * number / panes - 0.035, y, 0.07, height, frame)
    canvas.rect(x, y + height * 0.66, width, 0.07, frame)


def surround(
    canvas: Canvas, x: float, y: float, width: float, height: float, trim: Colour, head: str, bar: float = 0.16
) -> None:
    """Set an opening in stucco: jambs, a sill, and a head ("none", "flat", "gable", "arch" or "stone")."""
    canvas.rect(x - bar, y - 0.1, width + 2 * bar, height + bar + 0.1, trim)
    canvas.rect(x - bar - 0.08, y - 0.2, width + 2 * bar + 0.16, 0.12, toned(trim, 275))
    canvas.rect(x - bar - 0.04, y - 0.27, width + 2 * bar + 0.08, 0.07, toned(trim, 150))
    top, middle, half = y + height + bar, x + width / 2, width / 2 + bar + 0.12
    if head == "none":
        return
    if head == "stone":
        canvas.polygon([(middle - 0.14, top - 0.15), (middle + 0.14, top - 0.15), (middle + 0.2, top + 0.25),
                        (middle - 0.2, top + 0.25)], toned(trim, 280))  # fmt: skip
        return
    canvas.rect(middle - half, top + 0.1, 2 * half, 0.1, toned(trim, 280))
    canvas.rect(middle - half, top + 0.04, 2 * half, 0.06, toned(trim, 150))
    if head == "gable":
        canvas.polygon([(middle - half, top + 0.2), (middle + half, top + 0.2), (middle, top + 0.62)], toned(trim, 280))
        canvas.polygon([(middle - half + 0.25, top + 0.24), (middle + half - 0.25, top + 0.24), (middle, top + 0.5)],
                       toned(trim, 200))  # fmt: skip
    elif head == "arch":
        points = [(middle + half * u, top + 0.2 + 0.4 * (1 - u * u)) for u in (-1.0, -0.75, -0.4, 0.0, 0.4, 0.75, 1.0)]
        canvas.polygon(points, toned(trim, 280))
        canvas.disc(middle, top + 0.32, 0.12, toned(trim, 190))
