"""Positions as Mapillary gives them: a JSON file beside every image."""

import hashlib
import json
from base64 import urlsafe_b64encode
from pathlib import Path

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.poses import poses
from vpr_datasets.simulation.spec import SimulationSpec
from vpr_datasets.simulation.view import wander

ORIGINS = {"motorway": (52.49, 13.28), "street": (52.497, 13.286), "boulevard": (52.503, 13.32)}
"""Latitude and longitude, in degrees, of where the path of a scene begins."""

ELSEWHERE = (52.5, 13.3)

LATITUDE, LONGITUDE = 111276.8, 67910.2
"""Metres in a degree at 52.5 degrees north, on the ellipsoid of WGS 84."""

NARROWING = 1541.0
"""By how many metres a degree of longitude is shorter one degree further north."""

ERROR, TURN = 1.5, 4.0
"""Greatest error of a telephone's position in metres, along each axis, and of its compass in degrees."""


def write(spec: SimulationSpec, folder: Path, files: Files) -> None:
    """Write position, compass and keys of every image."""
    for traverse in spec.traverses:
        key = (spec.seed, traverse.seed, traverse.name, "receiver")
        for index, (east, north, compass) in enumerate(poses(spec, traverse.name).tolist()):
            # A receiver drifts, so that neighbouring images err in the same direction.
            drift = [ERROR * wander((*key, axis), index, 8) for axis in ("east", "north")]
            turn = TURN * Dice(*key, "compass", index).between(-1, 1)
            latitude, longitude = degrees(spec.scene, east + drift[0], north + drift[1])
            path = files.path(folder, traverse.name, index)
            content = {
                "ca": round((compass + turn) % 360.0, 2) % 360.0,
                "key": _image_key(path.name),
                "lat": latitude,
                "lon": longitude,
                "skey": path.name.partition("-640-")[0],
            }
            text = json.dumps(content, sort_keys=True) + "\n"
            path.with_name(f"{path.name}.json").write_text(text, encoding="ascii", newline="\n")


def degrees(scene: str, east: float, north: float) -> tuple[float, float]:
    """Return latitude and longitude, in degrees with seven decimals, of a place in metres from the origin.

    A plane that touches the earth there is good to centimetres within a kilometre.
    """
    origin = ORIGINS.get(scene, ELSEWHERE)
    latitude = origin[0] + north / LATITUDE
    width = LONGITUDE - NARROWING * (latitude - 52.5)
    return round(latitude, 7), round(origin[1] + east / width, 7)


def _image_key(name: str) -> str:
    """Return 22 characters that name one image."""
    return urlsafe_b64encode(hashlib.sha256(name.encode()).digest()[:16]).decode().rstrip("=")
