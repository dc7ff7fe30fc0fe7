"""Images from Mapillary, each with a JSON file beside it: ``<image>.jpg`` and ``<image>.jpg.json``."""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.layout import Layout, Recognised
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError, one_line
from vpr_bench.files.images import image_files, natural_key
from vpr_bench.types.image import SUFFIXES
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.compasses import joint_compass
from vpr_datasets.layouts.faults import check_count, placed, refuse
from vpr_datasets.layouts.looking import folders_in, images_in
from vpr_datasets.layouts.metres import PositionError, zone_of
from vpr_datasets.layouts.positioned import Found, positioned
from vpr_datasets.layouts.texts import quoted, read_text

_ADVICE = "Restore the files, or move the image and its JSON away."


def load(folder: Path, card: TraverseCard, zone: str) -> Recording:
    """Find the images of one traverse, and where each was taken.

    Parameters
    ----------
    folder : Path
        Holds images and their JSON files; what else lies there is passed by.
    card : TraverseCard
        May say how many images there must be.
    zone : str
        UTM zone in which the positions are written, for example ``33U``.

    Returns
    -------
    Recording
        In natural order of the file names, which are the sequence's key with a frame number. Labels are (n, 2) metres;
        the compass is there if all images have one.

    Raises
    ------
    DataError
        If an image or its JSON file is missing, damaged or without a fix.
    """
    images = sorted(image_files(folder), key=lambda file: natural_key(file.name))
    _check_pairs(folder, images)
    check_count(folder, card, len(images))
    fixes, faults = [], []
    for image in images:
        try:
            fixes.append(_read_fix(_beside(image)))
        except DataError as error:
            faults.append(f"{_beside(image)}: {error}")
    refuse(faults, _ADVICE)
    latitude, longitude, compass = np.array(fixes, dtype=np.float64).T
    labels = placed(latitude, longitude, zone, [_beside(image) for image in images], _ADVICE)
    return Recording(Traverse(card.name, images), labels, joint_compass(compass, folder))


def recognise(folder: Path) -> Recognised | None:
    """Look for folders of images with JSON files beside them, in the folder or one level below."""
    outer = folders_in(folder)
    found = []
    for one in outer + [inner for place in outer for inner in folders_in(place)]:
        images = images_in(one)
        described = next((file for file in map(_beside, images) if file.is_file()), None)
        if described is not None and _may_hold_fix(described):
            area = "" if one.parent == folder else one.parent.name
            found.append((Found(one.name, one.relative_to(folder).as_posix(), len(images), area), described))
    if len(found) < 2:
        return None
    first = found[0][1]
    try:
        latitude, longitude, _ = _read_fix(first)
        zone = zone_of(latitude, longitude)
    except (DataError, PositionError) as error:
        raise DataError(f"{first}: {error}. {_ADVICE}") from None
    return positioned("positions in JSON files beside them", [one for one, _ in found], {"zone": zone})


def _may_hold_fix(file: Path) -> bool:
    """Say whether a JSON file is Mapillary's, or too damaged to tell: then the user must know."""
    try:
        content = _read_json(file)
    except DataError:
        return True
    return isinstance(content, dict) and {"lat", "lon"} <= set(content)


def _beside(image: Path) -> Path:
    return image.with_name(f"{image.name}.json")


def _check_pairs(folder: Path, images: list[Path]) -> None:
    names = {image.name for image in images}
    described = {
        file.stem
        for file in folder.glob("*.json")
        if Path(file.stem).suffix.lower() in SUFFIXES and not file.name.startswith(".")
    }
    alone = [f"{folder / name} has no {name}.json beside it" for name in sorted(names - described)]
    alone += [f"{folder / name}.json has no image beside it" for name in sorted(described - names)]
    refuse(alone, _ADVICE)


def _read_json(file: Path) -> object:
    try:
        return json.loads(read_text(file))
    except (ValueError, RecursionError) as error:
        raise DataError(f"it is not JSON: {one_line(error)}") from None


def _read_fix(file: Path) -> tuple[float, float, float]:
    """Return latitude, longitude and compass in degrees; the compass is NaN where there is none."""
    content = _read_json(file)
    if not isinstance(content, dict):
        raise DataError("it is not a JSON object")
    compass = math.nan if content.get("ca") is None else _number(content, "ca")
    return _number(content, "lat"), _number(content, "lon"), compass


def _number(content: dict[str, Any], name: str) -> float:
    value = content.get(name)
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < 1e6:  # NaN is not either
        raise DataError(f"{name!r} must be a number of degrees, found {quoted(value)}")
    return float(value)


LAYOUT = Layout(
    about="folders of images from Mapillary, each with a JSON file of its position beside it",
    load=load,
    recognise=recognise,
    rank=50,
)
