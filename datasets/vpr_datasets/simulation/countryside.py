"""The land beside a railway: woods, meadows, farms, villages and lakes, closed by wooded hills."""

from dataclasses import dataclass

import numpy as np

from vpr_datasets.simulation import plants, woods
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.floors import MEADOW, WOODLAND
from vpr_datasets.simulation.houses import House, put_house
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

BACKS = {
    "wood": 17.0, "birches": 15.0, "heath": 30.0, "heights": 17.0, "yard": 26.0, "lake": 120.0, "village": 46.0,
    "meadow": 54.0, "farm": 54.0,
}  # fmt: skip
"""How far from the track the view is closed by trees, in metres, on every kind of land."""

PAINTS: tuple[Colour, ...] = (
    (152, 50, 42),
    (152, 50, 42),
    (228, 226, 218),
    (206, 166, 88),
    (118, 132, 120),
    (222, 208, 170),
)
ROOFS: tuple[Colour, ...] = ((84, 80, 82), (132, 74, 58), (70, 72, 76), (108, 92, 84))


@dataclass(frozen=True)
class Country:
    """What grows there in one season, each in a few shapes that are used again and again."""

    season: Season
    snow: float
    spruces: list[Texture]
    birches: list[Texture]
    shrubs: list[Texture]
    tufts: list[Texture]
    edges: list[Texture]
    leafy: list[Texture]
    hills: list[Texture]

    def plant(
        self, stage: Stage, dice: Dice, s: float, t: float, level: float, size: float, birches: float = 0.35
    ) -> None:
        """Plant a spruce or a birch at a height of ``level`` metres."""
        leafy = dice.chance(birches)
        size *= dice.between(0.75, 1.25)
        wide, high, kinds = (5.0, 9.0, self.birches) if leafy else (4.4, 11.0, self.spruces)
        stage.cutout(s, t, wide * size * dice.pick((1, -1)), level + high * size, dice.pick(kinds), low=level)
        if abs(t) < 20:
            stage.shade(s, t, 2.6 * size, 2.6 * size, level + 1.0, level + high * size * 0.8)

    def scrub(self, stage: Stage, dice: Dice, s: float, t: float) -> None:
        """Let a bush or a tuft of grass grow."""
        size, side, bush = dice.between(0.5, 1.3), dice.pick((1, -1)), dice.chance(0.45)
        shrub, tuft = dice.pick(self.shrubs), dice.pick(self.tufts)
        if bush:
            stage.cutout(s, t, 2.4 * size * side, 1.5 * size, shrub)
        elif self.snow < 0.5:
            # Snow lies deeper than the grass is high.
            stage.cutout(s, t, 2.0 * size * side, 1.1 * size, tuft)


def grow(seed: int, season: Season, snow: float) -> Country:
    """Paint what grows in a season."""
    white = max(snow - 0.4, 0.0) * 1.5
    return Country(
        season,
        snow,
        [woods.spruce(Dice(seed, "spruce", number), season, white).bake() for number in range(8)],
        [woods.birch(Dice(seed, "birch", number), season, white).bake() for number in range(8)],
        [_dusted(plants.shrub(Dice(seed, "bush", number), season), white).bake() for number in range(6)],
        [plants.grasses(Dice(seed, "tuft", number), season).bake() for number in range(4)],
        [woods.edge(Dice(seed, "edge", number), season, white, 24.0, 12.0, 0.2).bake() for number in range(5)],
        [woods.edge(Dice(seed, "leafy", number), season, white, 24.0, 9.0, 0.8).bake() for number in range(3)],
        [_hill(Dice(seed, "hill", number), season, snow).bake() for number in range(6)],
    )


def _dusted(canvas: Canvas, snow: float) -> Canvas:
    """Lay snow on the upper side of what is painted."""
    if snow:
        solid = canvas.ink > 0
        top = solid.copy()
        depth = int(0.22 * canvas.density)
        top[depth:] &= ~solid[:-depth]
        canvas.rgb[top] = woods.SNOW
    return canvas


def _hill(dice: Dice, season: Season, snow: float) -> Canvas:
    """Paint a wooded hill with clearings, 90 m wide and 26 m tall."""
    canvas = Canvas(90.0, 26.0, 5.0, toned(WOODLAND[season], 220))
    rows, columns = canvas.ink.shape
    clearing = value_noise(dice, rows, columns, 60, 2) > 150
    canvas.rgb[clearing] = MEADOW[season] if snow < 0.5 else woods.SNOW
    for _ in range(900):
        x, y = dice.between(-1, 91), dice.between(0, 25)
        if clearing[min(int((26 - y) * 5), rows - 1), min(max(int(x * 5), 0), columns - 1)]:
            continue
        tall = dice.between(2.0, 4.2)
        if dice.chance(0.7):
            colour = toned(tinted(dice, dice.pick(woods.NEEDLES), 10), 220 + dice.below(50))
            canvas.polygon([(x - 1.0, y), (x + 1.0, y), (x, y + tall)], colour)
            if snow > 0.5:
                canvas.line(x - 0.8, y + 0.3, x, y + tall, 0.4, (214, 220, 226))
        else:
            canvas.disc(
                x, y + 1.2, dice.between(0.7, 1.3), toned(tinted(dice, dice.pick(woods.BIRCH[season]), 10), 230)
            )
    profile = value_noise(dice, 1, columns, 150, 5)[0].astype(np.int64)
    aside = np.abs(np.arange(columns) * 2 - columns) * 70 // columns
    canvas.ink[np.arange(rows)[:, None] < ((profile + aside) * rows // 300)[None]] = 0
    canvas.speckle(dice, 20, 1.5)
    return canvas


def fill(stage: Stage, dice: Dice, country: Country, kind: str, side: int, start: float, stop: float) -> None:
    """Fill one side of the track from ``start`` to ``stop`` metres."""
    extent = stop - start
    back = BACKS[kind]
    _close(stage, dice, country, kind, side, start, stop, back)
    if kind in ("wood", "birches"):
        share = 0.2 if kind == "wood" else 0.85
        for _ in range(int(extent * 0.55)):
            t = side * dice.between(6.0, back - 1)
            country.plant(stage, dice, start + dice.between(0, extent), t, 0.0, dice.between(0.5, 1.2), share)
    elif kind in ("farm", "village"):
        _settle(stage, dice, country, side, start, extent, village=kind == "village")
    elif kind == "lake":
        for _ in range(int(extent * 0.25)):
            country.scrub(stage, dice, start + dice.between(0, extent), side * dice.between(4.0, 5.2))
    elif kind in ("meadow", "heath"):
        for _ in range(int(extent * (0.06 if kind == "meadow" else 0.3))):
            t = side * dice.between(7.0, back - 2)
            country.plant(stage, dice, start + dice.between(0, extent), t, 0.0, dice.between(0.3, 0.8), 0.6)
    if kind in ("meadow", "farm"):
        _fence(stage, dice, side, start, stop)
    if kind not in ("lake", "heights", "yard"):
        for _ in range(int(extent * 0.7)):
            country.scrub(stage, dice, start + dice.between(0, extent), side * dice.between(2.9, 9.0))


def _close(
    stage: Stage, dice: Dice, country: Country, kind: str, side: int, start: float, stop: float, back: float
) -> None:
    """Close the view with the edge of a wood, and hills behind it."""
    s = start
    textures = country.leafy if kind == "birches" else country.edges
    if kind in ("wood", "birches"):
        wall_across(stage, start, 7.0, back - 7.0 + 8.0, 0, dice.between(7, 11), dice.pick(textures), side)
    while s < stop:
        step = min(24.0, stop - s + 1.0)
        texture = dice.pick(textures if dice.chance(0.8) else country.leafy)
        wall_along(stage, side, s, s + step, back + dice.between(-1.5, 1.5), 0, dice.between(9, 13), texture)
        s += step
    s = start
    while s < stop:
        far = max(back + 25, 70.0) + dice.between(0, 45)
        wall_along(stage, side, s - 25, s + 65, far, 0, dice.between(14, 34), dice.pick(country.hills))
        s += dice.between(30, 55)


def _settle(
    stage: Stage, dice: Dice, country: Country, side: int, start: float, extent: float, *, village: bool
) -> None:
    """Put up the houses of a village or a farm, with trees between."""
    s = start + dice.between(3, 9)
    while s < start + extent - 6:
        barn = not village and dice.chance(0.45)
        long, wide = (dice.between(12, 18), dice.between(8, 10)) if barn else (dice.between(7, 12), dice.between(6, 8))
        t = dice.between(13, 24) if village else dice.between(18, 34)
        put_house(stage, dice, House(
            s + long / 2, side * t, long, wide, dice.pick((3.2, 5.4)), dice.between(2.2, 3.6),
            tinted(dice, PAINTS[0] if barn else dice.pick(PAINTS), 12), tinted(dice, dice.pick(ROOFS), 10),
            turned=dice.chance(0.4), barn=barn, snow=country.snow if country.snow > 0.5 else 0.0,
        ))  # fmt: skip
        for _ in range(3):
            country.plant(stage, dice, s + dice.between(-4, long + 5), side * (t + dice.between(6, 14)), 0.0,
                          dice.between(0.5, 1.0), 0.75)  # fmt: skip
        country.plant(stage, dice, s + long + dice.between(0.5, 4), side * dice.between(9, t), 0.0, 0.6, 0.9)
        s += long + (dice.between(4, 12) if village else dice.between(8, 26))


def _fence(stage: Stage, dice: Dice, side: int, start: float, stop: float) -> None:
    """Run a fence of posts and rails or wire along the track."""
    canvas = Canvas(20.0, 1.1, 30.0)
    colour = tinted(dice, dice.pick(((124, 110, 96), (150, 144, 134), (96, 84, 74))), 10)
    rails = dice.chance(0.5)
    for y in (0.3, 0.6, 0.9):
        canvas.rect(0, y, 20.0, 0.1 if rails else 0.035, colour)
    for number in range(8):
        canvas.rect(number * 2.5, 0, 0.14, 1.1, toned(colour, 220))
    texture, t = canvas.bake(), dice.between(6.0, 10.0)
    s = start
    while s < stop - 4:
        step = min(20.0, stop - s)
        ends = ((s, side * t), (s + step, side * t))
        stage.wall(*(ends if side > 0 else ends[::-1]), 0, 1.1, texture, "both")
        s += step
    if dice.chance(0.4):
        bale = plain((190, 170, 110), dice)
        for _ in range(5):
            stage.box(
                start + dice.between(2, stop - start - 2),
                side * dice.between(t + 3, t + 22),
                1.3,
                1.3,
                1.2,
                bale,
                bale,
                bale,
            )
