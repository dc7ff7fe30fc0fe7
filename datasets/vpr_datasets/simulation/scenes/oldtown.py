"""An old town of canals and narrow houses, today and as it was in the days of its archive photographs."""

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.amsterdam import draw_house, put_across, put_house
from vpr_datasets.simulation.city.churches import put_church, tower
from vpr_datasets.simulation.city.people import lantern
from vpr_datasets.simulation.city.quays import flood, moor, put_bridge, railing
from vpr_datasets.simulation.city.sections import EDGE, Section, divide, pave
from vpr_datasets.simulation.city.stoops import paint_ground_floor, put_stoop
from vpr_datasets.simulation.city.throng import Throng, send_people
from vpr_datasets.simulation.city.trees import TALL, WIDE, street_tree
from vpr_datasets.simulation.lots import plain
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Epoch, Season, TraverseSpec
from vpr_datasets.simulation.stage import Mover, Stage
from vpr_datasets.simulation.texture import Canvas, Texture

REBUILT = 0.22
"""Share of the houses that were replaced between the two epochs."""

HOMES = 0.5
"""Share of the ground floors that were never shops."""


class OldTown:
    """The town at one time.

    Parameters
    ----------
    epoch
        When it is seen.
    """

    SETTING = Setting(
        knot=60.0, beyond=170.0, density=7.0, margin=34.0, reach=150.0, slab_reach=70.0, least=5.0, kerb=None
    )

    def __init__(self, epoch: Epoch) -> None:
        self.epoch = epoch

    def lay_out(self, seed: int, season: Season, course: Course, length: float) -> Stage:
        """Build the scene."""
        stage = Stage(course)
        trees = [street_tree(Dice(seed, "elm", number), season).bake() for number in range(7)]
        sections = divide(course)
        for number, section in enumerate(sections):
            dice = Dice(seed, "section", number)
            stage.floors.append(pave(section, dice.branch()))
            for side in (1, -1):
                self._line(stage, seed, number, section, sections[max(number - 1, 0)], side)
            if section.kind == "quay":
                self._put_canal(stage, seed, dice, section, trees)
            elif section.kind == "bridge":
                _cross_canal(stage, seed, dice, section)
            elif section.kind == "square":
                self._plant(stage, dice, section, trees, section.front(section.water) - 3.0, 9.0)
            _light(stage, dice.branch(), section)
            if dice.chance(0.4):
                texture, high = tower(dice).bake(), dice.between(44, 58)
                stage.cutout(section.start, dice.pick((1, -1)) * dice.between(34, 48), 11.0, high, texture)
        return stage

    def _line(self, stage: Stage, seed: int, number: int, section: Section, before: Section, side: int) -> None:
        """Stand houses side by side; each plot has a number, and keeps it through time."""
        if section.kind == "bridge":
            return
        dice, front, s = Dice(seed, "plots", number, side + 1), section.front(side), section.start
        plots = (number * 2 + (side > 0)) * 64
        if before.front(side) > front + 3.0:
            # A lane leads along the end of the canal or square, and the corner shows its houses.
            s += 4.0
            self._turn(stage, seed, plots + 40, side, s, front, before.front(side) + 6.0)
        if section.kind == "square" and side == section.water and dice.chance(0.5):
            put_church(stage, dice.branch(), side, s + 2, min(section.stop - s - 3, 30.0), front)
            s += min(section.stop - s - 3, 30.0) + 4.0
        plot = 0
        while s < section.stop - 3.0:
            width = round(min(dice.between(4.8, 8.6), section.stop - s), 2)
            if section.stop - s - width < 4.0:
                width = round(section.stop - s, 2)
            self._build(stage, seed, plots + plot, side, s, width, front, far=front > 14)
            s, plot = s + width, plot + 1
        end = Dice(seed, "end", number, side + 1)
        if end.chance(0.5):
            # Houses of the side street, end on.
            self._build(stage, seed, plots + 63, side, section.stop - 7.5, 7.0, front + 11.0, far=True)

    def _turn(self, stage: Stage, seed: int, number: int, side: int, s: float, t: float, stop: float) -> None:
        """Stand houses side by side from the path outwards, to be seen by who comes along."""
        dice = Dice(seed, "corner", number)
        while t < min(stop, EDGE):
            width = round(dice.between(5.0, 8.5), 2)
            style, use = self._fate(seed, number)
            ground = paint_ground_floor(seed, number, use, draw_house(seed, number, style, width), 212)
            put_across(stage, seed, number, style, side, s, width, t, ground)
            t, number = t + width, number + 1

    def _build(
        self, stage: Stage, seed: int, number: int, side: int, s: float, width: float, front: float, *, far: bool
    ) -> None:
        """Build one house: that of the other epoch, on some plots."""
        style, use = self._fate(seed, number)
        house = draw_house(seed, number, style, width)
        ground = paint_ground_floor(seed, number, use, house, 256 if side > 0 else 228)
        put_house(stage, seed, number, style, side, s, width, front, ground)
        if not far:
            put_stoop(stage, Dice(seed, "stoop", number, use), house, use, self.epoch, side, s, front)

    def _fate(self, seed: int, number: int) -> tuple[str, str]:
        """Return the styles of the house on a plot and of its ground floor."""
        luck = Dice(seed, "fate", number)
        rebuilt, home = luck.chance(REBUILT), luck.chance(HOMES)
        return self.epoch if rebuilt else "old", "home" if home and not rebuilt else self.epoch

    def _put_canal(self, stage: Stage, seed: int, dice: Dice, section: Section, trees: list[Texture]) -> None:
        """Dig a canal, with trees and boats along it and a bridge now and then."""
        near, far = (section.water * edge for edge in section.quay)
        flood(stage, seed, section.start, section.stop - section.start, min(near, far), max(near, far))
        if dice.chance(0.6):
            put_bridge(stage, dice.branch(), dice.between(section.start + 16, section.stop - 12), near, far)
        self._plant(stage, dice, section, trees, section.quay[0] + 0.1, 11.0, back=-0.6)
        self._plant(stage, dice, section, trees, section.quay[1] + 1.0, 13.0)
        boats = Dice(seed, "boats", int(section.start) + 100, self.epoch)
        s = section.start + 6.0
        while s < section.stop - 8:
            for edge, way in ((near, section.water), (far, -section.water)):
                if boats.chance(0.5):
                    moor(stage, boats, self.epoch, s, edge, way)
            s += boats.between(9, 18)

    def _plant(
        self, stage: Stage, dice: Dice, section: Section, trees: list[Texture], t: float, gap: float, back: float = 0.0
    ) -> None:
        """Plant a row of trees; old ones have since been felled, and young ones have grown."""
        s = section.start + dice.between(2, 6)
        while s < section.stop - 3:
            tree, mirrored, size = dice.pick(trees), dice.pick((1, -1)), dice.between(0.9, 1.35)
            luck = dice.between(0, 1)
            if self.epoch == "archive":
                size *= 0.62 + 0.3 * luck
            if (luck > 0.2) if self.epoch == "today" else (luck < 0.8):
                place = section.water * (t + back)
                stage.cutout(s, place, WIDE * size * mirrored, TALL * size, tree)
                stage.shade(s, place, 3.0 * size, 3.0 * size, 3.6 * size, 7.6 * size)
            s += gap * dice.between(0.8, 1.4)

    def park(self, stage: Stage, dice: Dice, traverse: TraverseSpec, length: float) -> None:
        """Fill the streets with what belongs to the time: cars and bicycles, or carts."""
        throng = Throng(dice, traverse)
        for section in divide(stage.course):
            throng.fill(stage, section)

    def send_out(self, dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
        """Let people walk by."""
        return send_people(dice, traverse, frames)


def _light(stage: Stage, dice: Dice, section: Section) -> None:
    """Stand lanterns along a section."""
    texture = lantern(dice).bake()
    if section.kind == "quay":
        t = section.water * (section.quay[0] - 0.35)
    elif section.kind == "bridge":
        t = section.water * 3.9
    else:
        t = section.water * (min(section.fronts) - 0.6)
    s = section.start + dice.between(3, 9)
    while s < section.stop - 1:
        stage.cutout(s, t, 0.9, 3.8, texture)
        stage.lamp(s, t, 3.3, 0.9)
        s += 17.0


def _cross_canal(stage: Stage, seed: int, dice: Dice, section: Section) -> None:
    """Lead the path over a canal between railings; houses stand along it on both banks."""
    length = section.stop - section.start
    flood(stage, seed, section.start, length, -EDGE + 1, EDGE - 1)
    rail = railing(dice, length, (150, 140, 128) if dice.chance(0.3) else None)
    for t in (4.0, -4.0):
        stage.wall((section.start, t), (section.stop, t), 0, 1.1, rail, "both")
    if dice.chance(0.5):
        _hang_drawbridge(stage, dice, section.start + length / 2)


def _hang_drawbridge(stage: Stage, dice: Dice, s: float) -> None:
    """Put up the white beams by which a drawbridge is lifted."""
    frame = Canvas(8.4, 7.0, 24.0)
    paint = dice.pick(((232, 230, 222), (70, 96, 80), (196, 196, 190)))
    for x in (0.0, 7.9):
        frame.rect(x, 0, 0.5, 6.4, paint)
    frame.rect(0, 5.6, 8.4, 0.5, paint)
    for x in (0.4, 8.0):
        frame.line(x, 4.6, 4.2 + (x - 4.2) * 0.7, 5.6, 0.2, paint)
    stage.wall((s, 4.2), (s, -4.2), 0, 7.0, frame.bake(), "both")
    beam = plain(paint, dice)
    for t in (3.9, -3.9):
        stage.wall((s - 5.5, t), (s + 6.5, t), 6.2, 6.7, beam, "both")
        stage.wall((s + 6.2, t), (s + 6.3, t), 0.4, 6.3, beam, "both")


today, archive = OldTown("today"), OldTown("archive")
