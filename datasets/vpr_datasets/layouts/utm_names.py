"""Images that carry their position in their name: ``@UTM_east@UTM_north@….jpg``."""

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.layout import Layout, Recognised
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.compasses import joint_compass
from vpr_datasets.layouts.faults import check_count, refuse
from vpr_datasets.layouts.looking import folders_in, some_images, walk_images
from vpr_datasets.layouts.positioned import Found, positioned
from vpr_datasets.layouts.utm_name import parse_name

_ADVICE = "Rename the images, or move them away."
_USUAL = ("images/test", "test", "images/val", "val")
"""Where the folders ``database`` and ``queries`` lie in a dataset that is cut into train, val and test."""

_LOOKS = 16
"""Images of a folder whose names are looked at to recognise it."""


def load(folder: Path, card: TraverseCard, zone: str = "") -> Recording:
    """Find the images of one traverse, however deep they lie.

    Parameters
    ----------
    folder : Path
        The traverse's folder; links to other folders in it are not followed.
    card : TraverseCard
        May say how many images there must be.
    zone : str
        UTM zone's number and hemisphere, ``33N``, that the names must agree with if they have one.

    Returns
    -------
    Recording
        Sorted by path. Labels are (n, 2) metres; the compass is there if all names have a heading.

    Raises
    ------
    DataError
        If a name holds no position, or positions are in different zones: their metres cannot be compared.
    """
    if not folder.is_dir():
        raise DataError(f"The folder {folder} is missing. Restore it, or fetch the dataset again.")
    images = sorted(walk_images(folder), key=lambda file: file.relative_to(folder).as_posix())
    check_count(folder, card, len(images))
    names, faults = [], []
    for image in images:
        try:
            names.append(parse_name(image.name))
        except ValueError as error:
            faults.append(f"{image}: {error}")
    refuse(faults, _ADVICE)
    _common_zone(folder, {zone, *(name.zone for name in names)})
    labels = np.array([(name.east, name.north) for name in names], dtype=np.float64)
    compass = joint_compass(np.array([name.heading for name in names]), folder)
    return Recording(Traverse(card.name, images), labels, compass)


def recognise(folder: Path) -> Recognised | None:
    """Look for folders of images with such names; ``database`` and ``queries`` may lie in ``images/test``."""
    usual = [folder / place for place in _USUAL]
    roots = [
        root
        for root in usual
        if (root / "queries").is_dir() and any((root / name).is_dir() for name in ("database", "gallery"))
    ]
    root = next(iter(roots), folder)
    found = [one for one in folders_in(root) if _are_named(some_images(one, _LOOKS))]
    if len(found) < 2:
        return None
    traverses: list[Found] = []
    zones: set[str] = set()
    for one in found:
        names = [image.name for image in walk_images(one)]
        zones |= _zones(names)
        traverses.append(Found(one.name, one.relative_to(folder).as_posix(), len(names)))
    zone = _common_zone(folder, zones)
    return positioned("positions in their names", traverses, {"zone": zone} if zone else None)


def _are_named(images: Sequence[Path]) -> bool:
    """Say whether at least half of some images have such names: strays are for loading to tell."""
    named = [image for image in images if _is_named(image.name)]
    return bool(named) and 2 * len(named) >= len(images)


def _zones(names: Iterable[str]) -> set[str]:
    return {parse_name(name).zone for name in names if _is_named(name)}


def _is_named(name: str) -> bool:
    try:
        parse_name(name)
    except ValueError:
        return False
    return True


def _common_zone(folder: Path, zones: set[str]) -> str:
    known = sorted(zones - {""})
    if len(known) > 1:
        raise DataError(
            f"The images in {folder} have positions in different UTM zones, {known[0]} and {known[1]}: their metres "
            "cannot be compared. Write all of them in one zone."
        )
    return next(iter(known), "")


LAYOUT = Layout(
    about="folders of images with their UTM position in the name, as @easting@northing@….jpg",
    load=load,
    recognise=recognise,
    rank=60,
)
