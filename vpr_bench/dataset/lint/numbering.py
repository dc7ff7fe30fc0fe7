"""Frame numbers in file names that contradict the places that images have by their order."""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.lint.finding import Finding, share
from vpr_bench.dataset.recording import Recording
from vpr_bench.types.traverse import Traverse

_REGULAR = 0.9
"""Numbers count frames if this many of their steps are alike; times of day and the like do not."""

_LAST_NUMBER = re.compile(r"(.*?)([0-9]+)([^0-9]*)")
_DIGITS = 15  # longer ones are no frame numbers, and no int64


def frame_numbers(traverse: Traverse) -> NDArray[np.int64] | None:
    """Return the number in each file name, None where there is none or the paths differ in anything else.

    Examples
    --------
    >>> from pathlib import Path
    >>> frame_numbers(Traverse("walk", [Path("frame-0007.png"), Path("frame-0009.png")])).tolist()
    [7, 9]
    """
    patterns, numbers = set(), []
    for source in traverse.sources:
        if not isinstance(source, Path):
            return None
        found = _LAST_NUMBER.fullmatch(source.stem)
        if found is None or len(found[2]) > _DIGITS:
            return None
        patterns.add((source.parent, found[1], found[3]))  # numbers that start anew in the next folder count nothing
        numbers.append(int(found[2]))
    return np.array(numbers, dtype=np.int64) if len(patterns) == 1 else None


def find_misordered(recording: Recording) -> list[Finding]:
    """Find numbers that go down while the labels go up, as those without leading zeros do when sorted by spelling."""
    frames = _Frames.of(recording)
    if frames is None or (np.diff(frames.labels) <= 0).any() or (frames.steps > 0).all():
        return []
    at = int(np.flatnonzero(frames.steps <= 0)[0])
    name_of = recording.traverse.name_of
    message = f"{name_of(at + 1)} comes right after {name_of(at)}: the images are not in the order of their numbers"
    return [Finding("misaligned-names", "warning", recording.traverse.name, message)]


def find_misaligned(references: Recording, queries: Recording) -> list[Finding]:
    """Find two traverses whose images have the same label and different numbers in their names.

    One has lost some of its frames, say, and the others moved up: from there on the same label is another place.
    """
    map_, asked = _Frames.of(references), _Frames.of(queries)
    if map_ is None or asked is None:
        return []
    _, in_map, in_asked = np.intersect1d(map_.labels, asked.labels, return_indices=True)
    shift = asked.numbers[in_asked] - map_.numbers[in_map]
    if not shift.any():
        return []
    where = f"{references.traverse.name}-{queries.traverse.name}"
    constant = bool((shift == shift[0]).all())  # one was counted from 0, the other from 1; or lost its first frame
    first = int(np.flatnonzero(shift)[0])
    pair = f"{references.traverse.name_of(in_map[first])} and {queries.traverse.name_of(in_asked[first])}"
    if constant:
        message = f"the numbers of all images are {abs(shift[0])} apart from those of the same place: {pair}"
        return [Finding("misaligned-names", "note", where, message)]
    if not (map_.regular or asked.regular):
        return []
    differing = share(int(np.count_nonzero(shift)), len(shift), "label")
    message = (
        f"images of one label with different numbers: {differing}, such as {pair}; "
        f"gaps in the numbers: {references.traverse.name} {map_.gaps}, {queries.traverse.name} {asked.gaps}"
    )
    return [Finding("misaligned-names", "warning", where, message)]


@dataclass(frozen=True, eq=False)
class _Frames:
    """The labels of a traverse's images beside the numbers in their names."""

    labels: NDArray[np.float64]
    numbers: NDArray[np.int64]

    @classmethod
    def of(cls, recording: Recording) -> "_Frames | None":
        """Return None where there is at most one image, or one of the two is not there."""
        labels, numbers = recording.labels, frame_numbers(recording.traverse)
        if labels is None or labels.ndim != 1 or len(labels) < 2 or numbers is None:
            return None
        return cls(labels, numbers)

    @property
    def steps(self) -> NDArray[np.int64]:
        """What is added from one number to the next."""
        return np.diff(self.numbers)

    @property
    def gaps(self) -> int:
        """How many steps are not the usual one."""
        return len(self.steps) - int(np.unique(self.steps, return_counts=True)[1].max())

    @property
    def regular(self) -> bool:
        """Whether nearly all steps are alike."""
        return self.gaps <= (1 - _REGULAR) * len(self.steps)
