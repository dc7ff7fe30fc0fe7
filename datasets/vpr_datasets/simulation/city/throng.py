"""Who and what is about in an old town: cars and bicycles today, carts and hats a hundred years ago."""

from vpr_datasets.simulation import props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city import kit
from vpr_datasets.simulation.city.cars import car, van
from vpr_datasets.simulation.city.cyclists import cyclist
from vpr_datasets.simulation.city.people import cart, old_car, townsman
from vpr_datasets.simulation.city.sections import Section
from vpr_datasets.simulation.city.vehicles import Vehicle
from vpr_datasets.simulation.lots import plain
from vpr_datasets.simulation.materials import tinted
from vpr_datasets.simulation.spec import TraverseSpec
from vpr_datasets.simulation.stage import Mover, Stage
from vpr_datasets.simulation.texture import Texture


class Throng:
    """What may be about at the time of a traverse, painted once.

    Parameters
    ----------
    dice
        Draws it.
    traverse
        Says the time, and how much is about.
    """

    def __init__(self, dice: Dice, traverse: TraverseSpec) -> None:
        self.dice, self.share, self.today = dice, traverse.traffic, traverse.epoch == "today"
        people = props.person if self.today else townsman
        self.people = [people(dice).bake() for _ in range(12)]
        self.cars: list[Vehicle] = (
            [*(car(dice) for _ in range(12)), *(van(dice) for _ in range(2))] if self.today else []
        )
        carts = [cart(dice) for _ in range(6)] + [old_car(dice) for _ in range(2)]
        self.carts = [] if self.today else [(canvas.width, canvas.height, canvas.bake()) for canvas in carts]
        self.bicycles = [props.bicycle(dice).bake() for _ in range(5)]
        self.signs = [kit.sign(dice).bake() for _ in range(8)]
        self.bollard = plain((96, 44, 38), dice, 0.3)

    def fill(self, stage: Stage, section: Section) -> None:
        """Fill a section."""
        if section.kind == "bridge":
            return
        dice, s = self.dice, section.start + 1.0
        own = section.front(-section.water)
        if section.kind == "quay":
            edge, side = section.quay[0] - 1.1, section.water
        else:
            edge, side = min(section.fronts) - 1.6, dice.pick((1, -1))
        while s < section.stop - 4:
            if self.today and section.kind != "street" and dice.chance(0.25 + self.share * 0.6):
                self._park(stage, s, side * edge)
            elif self.today and dice.chance(self.share):
                self._lean(stage, s, side * edge)
            elif not self.today and dice.chance(self.share * 0.4):
                self._leave_cart(stage, s + 2, side * (edge - 0.3))
            elif not self.today and dice.chance(self.share * 0.4):
                self._stack(stage, s + 1, side * (edge + 0.4))
            s += dice.between(5.2, 6.4)
        self._line_houses(stage, section, own)
        if section.kind == "square" and self.today:
            for _ in range(4):
                stage.cutout(dice.between(section.start + 3, section.stop - 3),
                             section.water * dice.between(6.0, section.front(section.water) - 4.0), 3.4, 2.8,
                             props.parasol(dice).bake())  # fmt: skip
        elif section.kind == "square":
            for _ in range(4):
                self._leave_cart(stage, dice.between(section.start + 4, section.stop - 4),
                                 section.water * dice.between(6.0, section.front(section.water) - 4.0))  # fmt: skip
        for _ in range(int((section.stop - section.start) * 0.16 * (0.4 + self.share) * (1.0 if self.today else 1.4))):
            place, t = dice.between(section.start, section.stop), dice.between(-min(own, 4.0), min(own, 4.0))
            if abs(t) > 1.4:
                stage.cutout(place, t, 0.9 * dice.pick((1, -1)), dice.between(1.6, 1.85), dice.pick(self.people))

    def _park(self, stage: Stage, s: float, t: float) -> None:
        one = self.dice.pick(self.cars)
        one.put(stage, s + 2.4, t, onward=self.dice.chance(0.6))
        stage.shade(s + 2.4, t, one.length - 0.6, one.width - 0.4, 0, one.height - 0.3)

    def _lean(self, stage: Stage, s: float, t: float) -> None:
        """Lean bicycles against each other."""
        for number in range(2 + self.dice.below(5)):
            place = s + number * 0.7
            stage.wall((place, t + 0.7), (place + 0.5, t - 0.7), 0, 1.1, self.dice.pick(self.bicycles), "both")

    def _leave_cart(self, stage: Stage, s: float, t: float) -> None:
        width, high, texture = self.dice.pick(self.carts)
        if self.dice.chance(0.6):
            stage.wall((s, t), (s + width, t), 0, high, texture, "both")
        else:
            stage.cutout(s, t, width * self.dice.pick((1, -1)), high, texture)

    def _stack(self, stage: Stage, s: float, t: float) -> None:
        """Stack barrels and crates."""
        dice = self.dice
        for number in range(1 + dice.below(4)):
            wood = plain(tinted(dice, (116, 92, 66), 20), dice, 0.6)
            size = dice.between(0.5, 0.8)
            stage.box(
                s + number * 0.85, t + dice.between(-0.2, 0.2), size, size, dice.between(0.5, 1.1), wood, wood, wood
            )

    def _line_houses(self, stage: Stage, section: Section, own: float) -> None:
        """Stand bollards, signs and bicycles before the houses."""
        dice, side = self.dice, -section.water
        s = section.start + 1.0
        while s < section.stop - 1:
            s += dice.between(1.8, 2.6)
            t = side * (own - 1.7)
            if self.today and section.kind != "street" and s % 30 < 18:
                stage.box(s, t, 0.16, 0.16, 0.9, self.bollard, self.bollard, self.bollard)
            if self.today and dice.chance(0.05):
                stage.cutout(s, t, 1.4, 2.8, dice.pick(self.signs))
            elif dice.chance((0.16 if self.today else 0.03) * (0.3 + self.share)):
                wall = side * (own - 0.45)
                stage.wall((s, wall), (s + 1.8, wall), 0, 1.1, dice.pick(self.bicycles), "both")


def send_people(dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
    """Let people walk by, on foot or on bicycles; each is seen in one picture only, as these are far apart."""
    textures: list[tuple[float, Texture]] = []
    for _ in range(8):
        if traverse.epoch == "today":
            textures += [(0.9, props.person(dice).bake()), (0.8, cyclist(dice).bake())]
        else:
            textures.append((0.9, townsman(dice).bake()))
    movers = []
    for index in range(frames):
        for _ in range(3):
            if dice.chance(traverse.traffic * 0.7):
                width, texture = dice.pick(textures)
                step = traverse.step or 12.0
                # Somebody so many metres ahead in this picture is out of sight in all others.
                ahead = dice.between(8.0, 26.0)
                pace = -6.0 * step
                movers.append(
                    Mover(
                        index + ahead / (step - pace),
                        pace,
                        dice.pick((1, -1)) * dice.between(1.5, 3.2),
                        width,
                        dice.between(1.6, 1.85),
                        texture,
                    )
                )
    return movers
