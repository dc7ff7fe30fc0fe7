"""A road in a big city: rows of tall houses with shops, trees, parked cars, traffic and junctions."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city import kit
from vpr_datasets.simulation.city.landmarks import plant_square, put_tower, put_viaduct
from vpr_datasets.simulation.city.roads import BOULEVARD, EDGE, STREET, Profile, pave
from vpr_datasets.simulation.city.roadside import Junctions, furnish
from vpr_datasets.simulation.city.terraces import put_house
from vpr_datasets.simulation.city.traffic import line_up, set_out, stand_about
from vpr_datasets.simulation.city.trees import street_tree
from vpr_datasets.simulation.city.words import SHOPS
from vpr_datasets.simulation.lots import wall_along
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Season, TraverseSpec
from vpr_datasets.simulation.stage import Mover, Stage
from vpr_datasets.simulation.texture import Texture

SIDE_STREET = 13.0
"""Width of a side street between its houses, in metres."""


class Street:
    """Roads with a cross-section; what else differs is drawn.

    Parameters
    ----------
    profile
        The cross-section.
    """

    SETTING = Setting(
        knot=70.0, beyond=240.0, density=9.0, margin=EDGE, reach=230.0, slab_reach=60.0, least=6.0, kerb=None
    )

    def __init__(self, profile: Profile) -> None:
        self.profile = profile

    def lay_out(self, seed: int, season: Season, course: Course, length: float) -> Stage:
        """Build the scene."""
        stage = Stage(course)
        stop = course.stop
        junctions = _cross(course)
        pave(stage, self.profile, -60.0, stop + 20, junctions)
        trees = [street_tree(Dice(seed, "square", number), season).bake() for number in range(5)]
        for side in (1, -1):
            dice = Dice(seed, "side", side + 1)
            edges = [-34.0, *[edge for junction in junctions for edge in junction], stop]
            for number in range(0, len(edges), 2):
                self._line(stage, dice, trees, side, edges[number], edges[number + 1], corner=number > 0)
            for first, last in junctions:
                self._close(stage, dice, side, first, last)
        self._cross_over(stage, Dice(seed, "bridges"), junctions, stop - 60)
        furnish(stage, Dice(seed, "furniture"), season, self.profile, junctions, length + 180)
        return stage

    def _line(
        self, stage: Stage, dice: Dice, trees: list[Texture], side: int, start: float, stop: float, *, corner: bool
    ) -> None:
        """Stand houses side by side."""
        s, front = start, self.profile.front(side)
        while s < stop - 1.0:
            width = dice.between(13.0, 24.0)
            if stop - s - width < 11.0:
                width = stop - s if stop - s < 27.0 else (stop - s) / 2
            kind = dice.below(12)
            if corner or kind > 2:
                back = dice.between(0.4, 2.0) if kind == 3 and not corner else 0.0
                put_house(stage, dice, side, s, width, front + back, SHOPS, corner=corner)
            elif kind == 2:
                put_tower(stage, dice, side, s, width, front + dice.between(2, 6))
            else:
                put_house(stage, dice, side, s, width, front + dice.between(10, 16), SHOPS)
                plant_square(stage, dice, trees, side, s, width, front)
            s, corner = s + width, False

    def _cross_over(self, stage: Stage, dice: Dice, junctions: Junctions, stop: float) -> None:
        """Lead railways over the road, in the middle between two junctions."""
        for (_, before), (after, _) in zip(junctions[1::3], junctions[2::3], strict=False):
            if after < stop:
                right, left = self.profile.fronts
                put_viaduct(stage, dice, (before + after) / 2, -right - 1.0, left + 1.0)

    def _close(self, stage: Stage, dice: Dice, side: int, first: float, last: float) -> None:
        """End the view into a side street, beyond two more houses."""
        scrap = Stage(stage.course)
        put_house(scrap, dice, side, first - 4, last - first + 8, EDGE - 2, SHOPS)
        stage.walls += scrap.walls
        stage.slabs += scrap.slabs
        texture = kit.poster(dice, 3.0, 2.0).bake()
        wall_along(stage, side, first + 2, first + 5, EDGE - 2.1, 1.0, 3.0, texture)

    def park(self, stage: Stage, dice: Dice, traverse: TraverseSpec, length: float) -> None:
        """Leave cars at the kerbs and people on the pavements."""
        line_up(stage, dice, traverse, self.profile, length + 120, _cross(stage.course))
        stand_about(stage, dice, traverse, self.profile, length + 60)

    def send_out(self, dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
        """Let cars, buses and bicycles drive on their lanes."""
        return set_out(dice, traverse, self.profile, frames)


def _cross(course: Course) -> Junctions:
    """Return from where to where side streets join a road: that belongs to its course."""
    dice = Dice(course.key, "junctions")
    junctions = []
    s = dice.between(20, 60)
    while s < course.stop - 60:
        junctions.append((s, s + SIDE_STREET))
        s += SIDE_STREET + dice.between(62, 118)
    return junctions


street, boulevard = Street(STREET), Street(BOULEVARD)
