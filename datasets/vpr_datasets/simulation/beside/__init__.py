"""What real datasets have beside their images: each kind of file is one module.

A writer is called once, when all images are there.
"""

from collections.abc import Callable
from pathlib import Path

from vpr_datasets.simulation.beside import fgps, mapillary, pairs, tutorial_gt
from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.spec import SimulationSpec

Writer = Callable[[SimulationSpec, Path, Files], None]

WRITERS: dict[str, Writer] = {
    "fgps": fgps.write,
    "mapillary": mapillary.write,
    "pairs": pairs.write,
    "tutorial_gt": tutorial_gt.write,
}
"""By the name that a card gives them."""
