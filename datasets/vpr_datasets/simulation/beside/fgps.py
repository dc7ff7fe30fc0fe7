"""Positions as St Lucia has them: one ``fGPS.txt`` in the folder of every traverse, a line for each frame."""

from pathlib import Path

from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.poses import poses
from vpr_datasets.simulation.spec import SimulationSpec

LATITUDE, LONGITUDE = 27.53, 152.99
"""Degrees of the origin. The latitude should be negative: the real files lack the sign, and so do these."""

METRES = 111320.0
"""In a degree of latitude."""

SHRINKAGE = 0.88676
"""Cosine of the latitude: by how much degrees of longitude are shorter there than at the equator."""


def write(spec: SimulationSpec, folder: Path, files: Files) -> None:
    """Write latitude and longitude of every frame, in degrees with seven decimals (a centimetre)."""
    for traverse in spec.traverses:
        lines = []
        for x, y, _ in poses(spec, traverse.name).tolist():
            # Without its sign, a latitude falls towards the north.
            latitude, longitude = LATITUDE - y / METRES, LONGITUDE + x / (METRES * SHRINKAGE)
            lines.append(f"{latitude:.7f} {longitude:.7f}\n")
        target = files.path(folder, traverse.name, 0).with_name("fGPS.txt")
        target.write_text("".join(lines), encoding="ascii", newline="\n")
