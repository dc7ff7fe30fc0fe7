"""What real datasets have beside their images: each kind of file is one module with a function ``write``.

A writer is called once, when all images are there, and imported only then: to know what an edition is called, nothing
needs to be drawn.
"""

from collections.abc import Callable
from importlib import import_module
from pathlib import Path

from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.spec import SimulationSpec

Writer = Callable[[SimulationSpec, Path, Files], None]

KINDS = ("fgps", "mapillary", "pairs", "tutorial_gt")
"""The names that a card gives them."""


def writer(kind: str) -> Writer:
    """Return the function that writes one kind of file."""
    write: Writer = import_module(f"{__name__}.{kind}").write
    return write
