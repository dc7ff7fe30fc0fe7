"""Folders of photographs whose headers (EXIF) say where they were taken."""

import math
from pathlib import Path

import numpy as np

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.layout import Layout, Recognised
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError
from vpr_bench.files.images import image_files, natural_key
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.compasses import joint_compass
from vpr_datasets.layouts.exif_header import Photograph, read_header
from vpr_datasets.layouts.faults import check_count, placed, refuse
from vpr_datasets.layouts.looking import folders_in, images_in
from vpr_datasets.layouts.metres import PositionError, zone_of
from vpr_datasets.layouts.positioned import Found, positioned

_ADVICE = "Move the photographs without a position away."
_LOOKS = 8
"""Photographs of a folder that are looked at to recognise it; half of them must have a position."""


def load(folder: Path, card: TraverseCard, zone: str) -> Recording:
    """Find the photographs of one traverse, and where each was taken. Only headers are read.

    Parameters
    ----------
    folder : Path
        Holds the photographs.
    card : TraverseCard
        May say how many there must be.
    zone : str
        UTM zone in which the positions are written, for example ``33U``.

    Returns
    -------
    Recording
        In the order in which they were taken, if all say when, else in natural order of their names. Labels are
        (n, 2) metres; the compass is there if all have a direction.

    Raises
    ------
    DataError
        If a photograph has no position, or one that is not near the zone.
    """
    images = sorted(image_files(folder), key=lambda file: natural_key(file.name))
    check_count(folder, card, len(images))
    headers, faults = [], []
    for image in images:
        try:
            headers.append(_with_fix(image))
        except DataError as error:
            faults.append(str(error))
    refuse(faults, _ADVICE)
    if all(header.taken for header in headers):
        order = sorted(range(len(images)), key=lambda index: headers[index].taken)  # equal ones stay as named
        images, headers = [images[index] for index in order], [headers[index] for index in order]
    labels = placed(
        [header.latitude for header in headers], [header.longitude for header in headers], zone, images, _ADVICE
    )
    compass = joint_compass(np.array([header.direction for header in headers]), folder)
    return Recording(Traverse(card.name, images), labels, compass)


def recognise(folder: Path) -> Recognised | None:
    """Look for folders of photographs with positions."""
    zone = ""
    traverses = []
    for one in folders_in(folder):
        images = images_in(one)
        zones = [_zone(image) for image in images[:: math.ceil(len(images) / _LOOKS) or 1]]
        known = [found for found in zones if found]
        if known and 2 * len(known) >= len(zones):
            zone = zone or known[0]
            traverses.append(Found(one.name, one.name, len(images)))
    return positioned("positions in their headers", traverses, {"zone": zone})


def _with_fix(image: Path) -> Photograph:
    header = read_header(image)
    if math.isnan(header.latitude):
        raise DataError(f"{image} has no position in its header")
    return header


def _zone(image: Path) -> str:
    """Return the UTM zone of a photograph, empty where it has none."""
    try:
        header = _with_fix(image)
        return zone_of(header.latitude, header.longitude)
    except (DataError, PositionError):
        return ""


LAYOUT = Layout(
    about="folders of photographs whose headers (EXIF) say where they were taken",
    load=load,
    recognise=recognise,
    rank=20,
)
