"""The kinds of scene: each is one module, and they differ only in what stands and moves where."""

from typing import Protocol

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.scenes import campus, motorway, oldtown, railway, street, suburb
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Epoch, Season, TraverseSpec
from vpr_datasets.simulation.stage import Mover, Stage


class Landscape(Protocol):
    """What a module in this package offers."""

    SETTING: Setting

    def lay_out(self, seed: int, season: Season, course: Course, length: float) -> Stage:
        """Build what is always there, from -20 to ``length`` metres along the path and some way beyond."""
        ...

    def park(self, stage: Stage, dice: Dice, traverse: TraverseSpec, length: float) -> None:
        """Add what stands about on one traverse only."""
        ...

    def send_out(self, dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
        """Return who is on the way on one traverse of so many frames."""
        ...


SCENES: dict[str, Landscape] = {
    "campus": campus,
    "railway": railway,
    "suburb": suburb,
    "street": street.street,
    "boulevard": street.boulevard,
    "motorway": motorway,
    "oldtown": oldtown.today,
}
"""By the name that a specification gives its scene."""

EARLIER: dict[str, Landscape] = {"oldtown": oldtown.archive}
"""How scenes looked when archive photographs were taken, where that differs."""


def landscape(scene: str, epoch: Epoch) -> Landscape:
    """Return the scene as it is, or was, in an epoch."""
    return EARLIER.get(scene, SCENES[scene]) if epoch == "archive" else SCENES[scene]
