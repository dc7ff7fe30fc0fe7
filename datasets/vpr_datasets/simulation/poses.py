"""Where the camera was in every frame: what a satellite receiver and a compass would have told."""

from math import floor, sqrt

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.scene import course_of
from vpr_datasets.simulation.spec import SimulationSpec
from vpr_datasets.simulation.view import view_at

DEGREES = 57.29577951308232
"""In a radian."""


def poses(spec: SimulationSpec, name: str) -> NDArray[np.float64]:
    """Return the true pose of the camera in every frame of the traverse called ``name``.

    Returns
    -------
    (frames, 3) float64
        Metres to the east and to the north of where the path begins, and the compass heading: degrees
        clockwise from north, in [0, 360).

    Examples
    --------
    >>> spec = SimulationSpec.model_validate({"seed": 1, "frames": 5, "traverses": [{"name": "day"}]})
    >>> poses(spec, "day").shape
    (5, 3)
    """
    traverse, course = spec.traverse(name), course_of(spec)
    views = [view_at(spec, traverse, course, index) for index in range(spec.frames_of(traverse))]
    return np.array([(view.x, view.y, heading(*view.forward)) for view in views], dtype=np.float64)


def heading(east: float, north: float) -> float:
    """Return the compass heading of a direction, in degrees.

    The C library's arc tangents differ in the last bit between machines; this one does not.

    Examples
    --------
    >>> [round(heading(*way), 9) for way in ((0, 1), (1, 0), (0, -1), (-1, 0), (1, 1))]
    [0.0, 90.0, 180.0, 270.0, 45.0]
    """
    size = sqrt(east * east + north * north)
    # The tangent of half the angle has no poles but at due south.
    if north < 0 and abs(east) < 1e-12 * size:
        return 180.0
    degrees = 2.0 * _arctan(east / (size + north)) * DEGREES
    return degrees - 360.0 * floor(degrees / 360.0)


def _arctan(tangent: float) -> float:
    """Return the arc tangent in radians: halve the angle until a few terms of the series are enough."""
    for _ in range(4):
        tangent = tangent / (1.0 + sqrt(1.0 + tangent * tangent))
    square, power, total = tangent * tangent, tangent, 0.0
    for term in range(12):
        total += (-power if term % 2 else power) / (2 * term + 1)
        power *= square
    return 16.0 * total
