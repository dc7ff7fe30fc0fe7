"""Positions that cannot be: a drive that jumps, a map and queries in different parts of the world."""

from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.lint.finding import Finding, counted, listed
from vpr_bench.dataset.load import Case
from vpr_bench.dataset.recording import Recording
from vpr_bench.types.traverse import Traverse

_TIMES = 20
"""A step this many times as long as the median step is a jump …"""

_METRES = 100.0
"""… if it is also longer than this: no car, train or lost satellite signal does it between two frames."""

_DRIVE = 0.05
"""Where more of the steps jump, the images are a collection, such as panoramas of a city, and not a drive."""


def find_jumps(recording: Recording) -> list[Finding]:
    """Find consecutive images that are too far apart, in metres."""
    labels, traverse = recording.labels, recording.traverse
    if labels is None or len(labels) < 3:
        return []
    steps = np.sqrt((np.diff(labels.reshape(len(labels), -1), axis=0) ** 2).sum(axis=1))
    steps[_new_folder(traverse)] = 0  # where another drive begins, nobody has driven
    moving = steps[steps > 0]  # a car that waits at the lights must not make all driving a jump
    if len(moving) == 0:
        return []
    jumps = np.flatnonzero(steps > max(_TIMES * float(np.median(moving)), _METRES))
    if len(jumps) == 0 or len(jumps) > max(_DRIVE * len(steps), 2):
        return []
    named = [f"{traverse.name_of(at)} to {traverse.name_of(at + 1)} ({steps[at]:,.0f} m)" for at in jumps.tolist()]
    message = f"{counted(len(jumps), 'jump')}, where the median step is {np.median(moving):.1f} m: {listed(named)}"
    return [Finding("position-jump", "warning", traverse.name, message)]


def find_far_apart(case: Case) -> list[Finding]:
    """Find a map and queries that nowhere come as near as the radius, by the boxes around their positions."""
    places, protocol = case.places, case.protocol
    if places.queries is None or places.references is None or not len(places.queries) or not len(places.references):
        return []
    queries, references = (labels.reshape(len(labels), -1) for labels in (places.queries, places.references))
    gap = np.maximum(references.min(axis=0) - queries.max(axis=0), queries.min(axis=0) - references.max(axis=0))
    reach = protocol.radius if protocol.unit == "m" else _METRES
    if gap.max() <= reach:
        return []
    distance = float(np.sqrt((np.maximum(gap, 0) ** 2).sum()))
    message = (
        f"the queries are at least {distance:,.0f} m from all references: "
        "a wrong sign, zone or order of the coordinates?"
    )
    return [Finding("far-apart", "error", str(protocol), message)]


def _new_folder(traverse: Traverse) -> NDArray[np.bool_]:
    """(n - 1,) bool: whether the next image lies in another folder."""
    folders = [source.parent if isinstance(source, Path) else None for source in traverse.sources]
    return np.array([one != other for one, other in pairwise(folders)])
