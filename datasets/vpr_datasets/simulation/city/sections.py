"""The stretches of which a walk through an old town is made: quays, streets, squares and bridges."""

from dataclasses import dataclass

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.stage import Band, Floor

EDGE = 40.0
"""How far bands reach to either side, in metres."""


@dataclass(frozen=True)
class Section:
    """A stretch of the path; lengths in metres.

    Attributes
    ----------
    kind
        "quay" has a canal on the side ``water``, "bridge" crosses one, "square" opens on the side ``water``, and
        "street" is narrow.
    start, stop
        From where to where it goes along the path.
    fronts
        Distance of the fronts of houses to the right and to the left; those on the far side of a canal included.
    quay
        Distance of the near edge of the canal, and of its far edge.
    """

    kind: str
    start: float
    stop: float
    water: int
    fronts: tuple[float, float]
    quay: tuple[float, float]

    def front(self, side: int) -> float:
        """Return the distance of the fronts on one side."""
        return self.fronts[0] if side < 0 else self.fronts[1]


def divide(course: Course) -> list[Section]:
    """Divide the path into sections; between different kinds lies a side street."""
    dice = Dice(course.key, "sections")
    sections: list[Section] = []
    s, deck, water = -28.0, list[str](), 1
    while s < course.stop - 95:
        deck = deck or dice.shuffled(("quay", "bridge", "street", "quay", "square", "street", "quay", "bridge"))
        kind = deck.pop()
        water = -water if dice.chance(0.6) else water
        near, far = dice.between(3.4, 4.2), dice.between(17.0, 24.0)
        own, other = dice.between(5.0, 6.4), far + dice.between(4.5, 6.0)
        if kind == "quay":
            length, fronts = dice.between(48, 90), (own, other) if water > 0 else (other, own)
        elif kind == "bridge":
            length, fronts = dice.between(13, 18), (EDGE, EDGE)
        elif kind == "square":
            deep = dice.between(15.0, 22.0)
            length, fronts = dice.between(34, 52), (own, deep) if water > 0 else (deep, own)
        else:
            length, fronts = dice.between(36, 70), (dice.between(3.6, 5.4), dice.between(3.6, 5.4))
        sections.append(Section(kind, s, s + length, water, fronts, (near, far)))
        s += length
    return sections


def pave(section: Section, dice: Dice) -> Floor:
    """Return the ground of a section."""
    base = (
        dice.pick(("clinker", "clinker", "setts"))
        if section.kind != "street"
        else dice.pick(("setts", "clinker", "mosaic"))
    )
    right, left = section.fronts
    bands = [Band(-EDGE, EDGE, base)]
    if section.kind == "bridge":
        bands += [Band(-EDGE, EDGE, "void"), Band(-4.2, 4.2, "quay"), Band(-3.8, 3.8, "setts")]
        return Floor(section.start, section.stop, 2.0, base, base, base, tuple(bands))
    walk = 1.5 if section.kind != "street" else 0.9
    bands += [
        Band(-right, -right + walk, "plates"),
        Band(left - walk, left, "plates"),
        Band(-right + walk, -right + walk + 0.15, "kerbstone"),
        Band(left - walk - 0.15, left - walk, "kerbstone"),
    ]
    if section.kind == "quay":
        near, far = section.quay
        canal = sorted((section.water * near, section.water * far))
        bands += [Band(canal[0] - 0.5, canal[1] + 0.5, "quay"), Band(canal[0], canal[1], "void")]
    if section.kind == "square":
        inner, outer = sorted((section.water * 4.2, section.water * (section.front(section.water) - 2.2)))
        bands += [Band(inner, outer, dice.pick(("setts", "plates", "mosaic", "cobbles")))]
    return Floor(section.start, section.stop, 2.0, base, base, base, tuple(bands))
