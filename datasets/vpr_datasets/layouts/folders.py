"""Folders of images and nothing else: the same order, or the same name, is the same place."""

from pathlib import Path
from typing import get_args

import numpy as np

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.layout import Layout, Recognised
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError, closest
from vpr_bench.files.images import listed
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.alignment import Align, aligned, choose
from vpr_datasets.layouts.bayer import Bayer
from vpr_datasets.layouts.faults import check_count
from vpr_datasets.layouts.listing import folders_of_images
from vpr_datasets.layouts.roles import pairings

RADIUS = 2.0
"""Frames: what is taken for the same place unless somebody says something else."""

_ASSUMED = {
    ("order", "f"): "aligned by order: image i of every folder is the same place, its neighbours are 1 frame away",
    ("number", "f"): "aligned by the numbers in the names: the same number is the same place, the next is 1 frame away",
    ("number", "pair"): "aligned by the numbers in the names: the same number is the same place, and no other is",
    ("stem", "pair"): "aligned by name: images of the same name are the same place, and no others are",
}


def load(folder: Path, card: TraverseCard, align: Align = "order", bayer: str | None = None) -> Recording:
    """Find the images of one traverse.

    Parameters
    ----------
    folder : Path
        The traverse's folder.
    card : TraverseCard
        Says how many images there must be, if it is known.
    align : {"order", "number", "stem"}
        What a label is: the position in natural order (``img2`` before ``img10``), the last number in the file's
        name, or a number made of the whole name without its ending, for images that form pairs.
    bayer : {"RGGB", "BGGR", "GRBG", "GBRG"}, optional
        The images are mosaics of this pattern, to be made into colour images.

    Returns
    -------
    Recording
        In natural order or, with ``number``, in that of the numbers.

    Raises
    ------
    DataError
        If the folder is missing, there are more or fewer images than the card says, or two have the same label.
    """
    if align not in get_args(Align):
        raise DataError(f"There is no alignment by {align!r:.50}. {closest(str(align), get_args(Align))}")
    files = listed(folder)
    check_count(folder, card, len(files))
    files, labels = aligned(files, align)
    return Recording(Traverse(card.name, files, Bayer(bayer) if bayer else None), labels)


def recognise(folder: Path) -> Recognised | None:
    """Look for folders of images, and for what their names have in common."""
    found = {one.name: one for one in folders_of_images(folder)}
    pairs = pairings(list(found))
    if not pairs:
        return None
    map_ = pairs[0][0]
    chosen = choose([found[map_].files, *(found[name].files for _, name in pairs)])
    if chosen is None:
        return None
    align, unit = chosen
    labels = aligned(found[map_].files, align)[1]
    # On a map that is no larger, every answer would be right.
    radius = RADIUS if unit == "f" and np.ptp(labels) > RADIUS else 0.0
    some = ", ".join(str(one) for one in list(found.values())[:4]) + (", …" if len(found) > 4 else "")
    return Recognised(
        found=f"{len(found)} folders of images ({some}), {_ASSUMED[align, unit]}",
        unit=unit,
        options={"align": align},
        traverses=[one.card() for one in found.values()],
        protocols=[{"references": one, "queries": other, "radius": radius} for one, other in pairs],
    )


LAYOUT = Layout(
    about="folders of images that are the same places in the same order, or by the same names or numbers",
    load=load,
    recognise=recognise,
    rank=10,
)
