"""A picture of the changed copies of references that a method learns from."""

from pathlib import Path

import numpy as np

from vpr_bench.errors import DataError, VprBenchError, blaming
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.interfaces import Augmenting
from vpr_bench.report.ink import BLUE, GREY
from vpr_bench.report.panel import Panel
from vpr_bench.report.panel_sheet import draw_panel_sheet
from vpr_bench.types.traverse import Traverse

SHOWN, ACROSS = 6, 12
"""How many references, and how many copies of each, are drawn at most."""


def draw_augmentations(
    built: BuiltMethod,
    augmenting: Augmenting,
    references: Traverse,
    called: str,
    file: Path,
    *,
    simulated: bool = False,
) -> Path:
    """Draw evenly spaced references, each beside its copies.

    Parameters
    ----------
    built : BuiltMethod
        For its label.
    augmenting : Augmenting
        The same method.
    references : Traverse
        At least one image; only those that are shown are decoded.
    called : str
        What to call the references.
    file : Path
        Where to write, as PNG.
    simulated : bool
        Say that they are.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    DataError
        If there is nothing to see, an image cannot be decoded, or the file cannot be written.
    VprBenchError
        If the method fails, or returns something else than images.
    """
    if not len(references):
        raise DataError(f"{called} has no images to look at.")
    count = min(SHOWN, len(references))
    rows = []
    for index in ((2 * np.arange(count) + 1) * len(references) // (2 * count)).tolist():
        image, name = references[index], references.name_of(index)
        with blaming(f"The method {built.id!r} failed while changing {name}"):
            copies = dict(augmenting.augmented(image.copy(), index))
        panels = [Panel(f"Reference {index}", BLUE, image, "", (name, ""))]
        for what, copy in list(copies.items())[:ACROSS]:
            if not isinstance(copy, np.ndarray) or copy.dtype != np.uint8 or copy.ndim != 3 or copy.shape[2] != 3:
                raise VprBenchError(f"The method {built.id!r} made of {name} by {what!r} something that is no image.")
            panels.append(Panel(str(what), GREY, copy))
        rows.append(panels)
    said = f"{count} of {len(references):,} references of {called}, and what is made of them for learning"
    return draw_panel_sheet(file, built.label, said, rows, warning="SIMULATED" if simulated else "")
