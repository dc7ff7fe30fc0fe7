"""Looks of Berlin's houses: stuccoed ones of about 1900 and those that filled the gaps after the war."""

from dataclasses import dataclass

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.materials import tinted, toned
from vpr_datasets.simulation.texture import Colour

STUCCO: tuple[Colour, ...] = (
    (222, 210, 182), (206, 186, 146), (196, 192, 184), (226, 222, 212), (204, 172, 150), (186, 190, 172),
    (212, 196, 120), (172, 160, 146), (190, 178, 166), (168, 176, 184), (214, 184, 168), (150, 140, 128),
)  # fmt: skip

RENDER: tuple[Colour, ...] = (
    (206, 204, 198), (190, 182, 164), (214, 208, 186), (170, 172, 172), (200, 186, 150), (156, 168, 172),
)  # fmt: skip

TILES: tuple[Colour, ...] = ((138, 80, 62), (120, 70, 58), (76, 78, 84), (96, 88, 84), (150, 94, 70))

ACCENTS: tuple[Colour, ...] = (
    (170, 60, 50),
    (52, 92, 140),
    (214, 160, 60),
    (80, 120, 90),
    (220, 218, 210),
    (70, 74, 80),
)

GROUND = 4.2
"""Height of the ground floor in metres."""

DENSITY = 20.0
"""Texels per metre of the upper storeys."""


@dataclass(frozen=True)
class House:
    """The looks of a house; lengths in metres."""

    kind: str
    colour: Colour
    trim: Colour
    frame: Colour
    accent: Colour
    roof: Colour
    storeys: int
    tall: float
    bays: int

    @property
    def eaves(self) -> float:
        """Height of the edge of the roof."""
        return GROUND + (self.storeys - 1) * self.tall


def draw_house(dice: Dice, width: float) -> House:
    """Draw the looks of a house that is ``width`` metres wide."""
    kind = dice.pick(("stucco", "stucco", "stucco", "stucco", "plain", "plain", "grid", "glass"))
    old = kind == "stucco"
    colour = tinted(dice, dice.pick(STUCCO if old else RENDER), 12)
    trim = dice.pick((toned(colour, 280), toned(colour, 230), (226, 222, 212))) if old else toned(colour, 280)
    frame = dice.pick(((232, 230, 224), (232, 230, 224), (96, 74, 56), (60, 66, 62))) if old else dice.pick(
        ((226, 226, 222), (70, 74, 78), (120, 122, 124)))  # fmt: skip
    return House(
        kind,
        colour,
        trim,
        frame,
        dice.pick(ACCENTS),
        dice.pick(TILES),
        dice.pick((4, 5, 5, 5, 6) if old else (4, 5, 6, 7)),
        dice.between(3.4, 3.9) if old else dice.between(2.8, 3.3),
        max(round(width / dice.between(2.4, 3.4)), 3),
    )
