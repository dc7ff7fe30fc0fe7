"""How far two runs of the same key answered the same."""

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import UsageError
from vpr_bench.files.atomic import read_arrays
from vpr_bench.runner.store import LABELS, MATCHES, SHORTLISTS, StoredRun


@dataclass(frozen=True)
class Agreement:
    """What two runs have in common.

    Attributes
    ----------
    same_file : bool
        ``matches.npz`` is the same, bit by bit.
    queries : int
        How many both were asked.
    unpaired : int
        How many only one of them was asked.
    best, ranking, scores : int
        For how many queries the best match, any of the ranked matches, or any score differs.
    largest : float
        Largest difference between the scores at one rank of one query; 0 if there is none.
    labels : bool
        The places are the same.
    shortlists : bool or None
        What was left after each step is the same; None if neither run noted it.
    """

    same_file: bool
    queries: int
    unpaired: int
    best: int
    ranking: int
    scores: int
    largest: float
    labels: bool
    shortlists: bool | None

    @property
    def identical(self) -> bool:
        """Whether every answer, every place and every shortlist is the same, to the last bit."""
        differing = (self.unpaired, self.best, self.ranking, self.scores)
        return not any(differing) and self.labels and self.shortlists is not False

    def as_dict(self) -> dict[str, Any]:
        """Return everything, JSON-able."""
        return {"identical": self.identical, **asdict(self)}


def agreement(first: StoredRun, second: StoredRun) -> Agreement:
    """Compare what two runs answered; times are left out.

    Raises
    ------
    UsageError
        If they are not of the same key, so that different answers say nothing.
    DataError
        If one of them cannot be read.
    """
    if first.record.key != second.record.key:
        raise UsageError(f"{first.folder} and {second.folder} are not the same run: their keys differ.")
    shared, left, right = np.intersect1d(first.queries, second.queries, assume_unique=True, return_indices=True)
    moved = first.indices[left] != second.indices[right]
    rescored = first.scores[left] != second.scores[right]
    return Agreement(
        same_file=first.record.files[MATCHES] == second.record.files[MATCHES],
        queries=len(shared),
        unpaired=len(first.queries) + len(second.queries) - 2 * len(shared),
        best=int(moved[:, :1].sum()),
        ranking=int(moved.any(axis=1).sum()),
        scores=int(rescored.any(axis=1).sum()),
        largest=_largest(first.scores[left], second.scores[right]),
        labels=_same_arrays(first.folder / LABELS, second.folder / LABELS),
        shortlists=_same_shortlists(first, second),
    )


def _largest(first: NDArray[np.float32], second: NDArray[np.float32]) -> float:
    """Return the largest difference where both are answers, and not places that stayed empty."""
    both = np.isfinite(first) & np.isfinite(second)
    return float(np.max(np.abs(first[both].astype(np.float64) - second[both]), initial=0.0))


def _same_shortlists(first: StoredRun, second: StoredRun) -> bool | None:
    noted = [SHORTLISTS in run.record.files for run in (first, second)]
    if not any(noted):
        return None
    return all(noted) and _same_arrays(first.folder / SHORTLISTS, second.folder / SHORTLISTS)


def _same_arrays(first: Path, second: Path) -> bool:
    """Say whether two files hold the same arrays, to the last bit; how they are packed does not matter."""
    mine, others = read_arrays(first), read_arrays(second)
    return mine.keys() == others.keys() and all(
        (mine[name].dtype, mine[name].shape) == (others[name].dtype, others[name].shape)
        and mine[name].tobytes() == others[name].tobytes()
        for name in mine
    )
