"""What a layout reads of one traverse: its images, and where each of them was taken."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from vpr_bench.types.traverse import Traverse


@dataclass(frozen=True, eq=False)
class Recording:
    """A traverse with what is known about the place of each image.

    Attributes
    ----------
    traverse : Traverse
        The images.
    labels : (n,) or (n, d) float64, optional
        Place labels: frame numbers, pair ids or positions in metres; None where a file of the dataset lists which
        images show the same place.
    compass : (n,) float64, optional
        Where the camera looked, in degrees clockwise from north, in [0, 360).
    """

    traverse: Traverse
    labels: NDArray[np.float64] | None = None
    compass: NDArray[np.float64] | None = None

    def __post_init__(self) -> None:
        """Check that there is one value per image, and that it is one.

        Raises
        ------
        ValueError
            If a column is shorter or longer than the traverse, or holds something that is not finite.
        """
        for name in ("labels", "compass"):
            column = getattr(self, name)
            if column is None:
                continue
            column = np.asarray(column, dtype=np.float64)
            if len(column) != len(self.traverse) or not np.isfinite(column).all():
                raise ValueError(f"{name} must be {len(self.traverse)} finite numbers, one per image of the traverse")
            object.__setattr__(self, name, column)

    def __len__(self) -> int:
        """Return the number of images."""
        return len(self.traverse)

    def subset(self, indices: ArrayLike) -> "Recording":
        """Take the images at ``indices``, in that order."""
        chosen = np.asarray(indices, dtype=np.int64)
        return replace(
            self,
            traverse=self.traverse.subset(chosen),
            labels=None if self.labels is None else self.labels[chosen],
            compass=None if self.compass is None else self.compass[chosen],
        )

    @classmethod
    def join(cls, recordings: "Sequence[Recording]") -> "Recording":
        """Put recordings one behind the other; :meth:`split` takes them apart again.

        Raises
        ------
        ValueError
            If there is none, or only some of them have labels or a compass, or their images differ in kind.
        """
        traverse = Traverse.join([recording.traverse for recording in recordings])
        columns = {}
        for name in ("labels", "compass"):
            parts = [getattr(recording, name) for recording in recordings]
            if any(part is None for part in parts) and any(part is not None for part in parts):
                raise ValueError(f"only some of {traverse.name} have {name}")
            columns[name] = None if parts[0] is None else np.concatenate(parts)
        return cls(traverse, **columns)

    def split(self) -> "list[Recording]":
        """Return the recordings that were joined; one that was not is returned alone."""
        parts, start = [], 0
        for traverse in self.traverse.split():
            rows = slice(start, start + len(traverse))
            columns = [None if column is None else column[rows] for column in (self.labels, self.compass)]
            parts.append(Recording(traverse, *columns))
            start = rows.stop
        return parts
