"""What spans the path: underpasses, bridges, pergolas, canopies and gates."""

from vpr_datasets.simulation import props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.facades import ACCENTS, WORDS, draw_style, paint_street, paint_upper
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import CONCRETE, WOOD, tinted, toned
from vpr_datasets.simulation.stage import Floor, Stage
from vpr_datasets.simulation.texture import Canvas


def span(stage: Stage, dice: Dice, length: float) -> list[tuple[float, float]]:
    """Build over the path every few dozen metres: underpasses, bridges, pergolas, canopies, gates.

    Returns from where to where, in metres along the path, it leads through a building.
    """
    tunnels: list[tuple[float, float]] = []
    s = dice.between(10, 20)
    deck: list[str] = []
    while s < length + 20:
        if not deck:
            deck = dice.shuffled(("underpass", "bridge", "pergola", "canopy", "gate"))
        kind = deck.pop()
        if kind == "underpass":
            extent = _put_underpass(stage, dice, s)
            tunnels.append((s, s + extent))
            s += extent
        elif kind == "bridge":
            s += _put_bridge(stage, dice, s)
        elif kind == "pergola":
            s += _put_pergola(stage, dice, s)
        elif kind == "canopy":
            s += _put_canopy(stage, dice, s)
        else:
            s += _put_gate(stage, dice, s)
        s += dice.between(9, 22)
    return tunnels


def _put_underpass(stage: Stage, dice: Dice, s: float) -> float:
    """Lead the path through a building."""
    extent, half = dice.between(9, 14), max(stage.half_width(s), 2.6) + 0.5
    style, high = draw_style(dice), dice.between(2.9, 3.5)
    for side in (1, -1):
        wall_along(stage, side, s, s + extent, half, 0, high, paint_street(dice, style, extent).bake(230))
        wall_across(stage, s, half, 4.0, 0, high, paint_street(dice, style, 4.0).bake(200), side)
    wide = half + 4.0
    upper = paint_upper(dice, style, 2 * wide)
    stage.wall((s, wide), (s, -wide), high, high + upper.height, upper.bake(196))
    # A lintel, and a ceiling wider than the passage, hide that the path bends under a straight roof.
    lintel = plain(style.trim, dice, 4.0)
    for place in (s, s + extent):
        stage.wall((place, wide), (place, -wide), high - 0.45, high, lintel, "both")
    ceiling = Canvas(extent + 0.6, 2 * half + 1.6, 24.0, toned(style.trim, 220))
    ceiling.speckle(dice, 18, 1.0)
    for number in range(int(extent / 2.5)):
        ceiling.rect(1.0 + number * 2.5, half + 0.2, 0.3, 1.2, (246, 244, 232), 254)
        stage.lamp(s + 1.2 + number * 2.5, 0.0, high, 0.5)
    stage.slab(s, -half - 0.8, ceiling.width, ceiling.height, high, ceiling.bake(), roof=True)
    stage.shade(s + extent / 2, 0, extent - 1, 2 * wide - 1, high, high + upper.height)
    # The first floor that covers a place counts.
    paving = dice.pick(("tiles", "asphalt", "large slabs"))
    stage.floors.insert(0, Floor(s, s + extent, half, paving, "concrete", "concrete"))
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
        stage.box(s + extent / 2, t * (stage.half_width(s) + 0.9), 0.6, 0.6, level, pillar, pillar, None)
    return extent


def _put_pergola(stage: Stage, dice: Dice, s: float) -> float:
    """Set posts on both sides with beams across."""
    count, gap = 4 + dice.below(4), dice.between(1.2, 2.2)
    half, high = max(stage.half_width(s), 2.2) + 0.4, dice.between(2.7, 3.3)
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
    level, half = dice.between(2.8, 3.6), stage.half_width(s)
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
    half, high = stage.half_width(s) + 0.6, dice.between(2.7, 3.4)
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
