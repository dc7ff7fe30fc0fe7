"""What a method answers for one query."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, eq=False, init=False)
class Match:
    """Ranked references with scores, best first; higher is better, always.

    Parameters
    ----------
    indices : (k,) integers
        Reference indices, unique and not negative; none is an answer too.
    scores : (k,) floats
        Finite and non-increasing.

    Raises
    ------
    ValueError
        If the shapes differ, an index is repeated or negative, or the scores are not finite or increase.

    Examples
    --------
    >>> Match([4, 2], [0.9, 0.5])
    Match(indices=array([4, 2]), scores=array([0.9, 0.5], dtype=float32))
    """

    indices: NDArray[np.int64]
    scores: NDArray[np.float32]

    def __init__(self, indices: ArrayLike, scores: ArrayLike) -> None:
        given = np.asarray(indices)
        if given.size and not np.issubdtype(given.dtype, np.integer):
            raise ValueError(f"the indices of a match must be integers. Got dtype {given.dtype} instead.")
        object.__setattr__(self, "indices", given.astype(np.int64))
        object.__setattr__(self, "scores", np.array(scores, dtype=np.float32))
        self._check()

    def _check(self) -> None:
        if self.indices.ndim != 1 or self.indices.shape != self.scores.shape:
            raise ValueError(
                "indices and scores of a match must both have shape (k,). "
                f"Got {self.indices.shape} and {self.scores.shape} instead."
            )
        if np.any(self.indices < 0) or len(np.unique(self.indices)) != len(self.indices):
            raise ValueError(f"the indices of a match must be unique and not negative. Got {self.indices}.")
        if not np.isfinite(self.scores).all():
            raise ValueError(f"the scores of a match must be finite. Got {self.scores}.")
        if np.any(np.diff(self.scores) > 0):
            raise ValueError(f"the scores of a match must not increase: best first. Got {self.scores}.")

    def __len__(self) -> int:
        """Return the number of references answered."""
        return len(self.indices)

    @classmethod
    def from_scores(cls, scores: ArrayLike, k: int, candidates: ArrayLike | None = None) -> "Match":
        """Rank by score and keep the best ``k``; equal scores keep the order they came in.

        Parameters
        ----------
        scores : (n,) floats
            One per reference, or one per candidate where ``candidates`` is given.
        k : int
            How many to keep; more than ``n`` keeps all.
        candidates : (n,) integers, optional
            The reference that each score belongs to; by default 0 to n - 1.

        Raises
        ------
        ValueError
            If ``k`` is less than 1, a score is NaN or one of the best ``k`` is not finite.

        Examples
        --------
        >>> Match.from_scores([0.1, 0.7, 0.4], k=2).indices
        array([1, 2])
        """
        values = np.asarray(scores, dtype=np.float32)
        if k < 1:
            raise ValueError(f"k must be at least 1. Got {k}.")
        unknown = np.flatnonzero(np.isnan(values))
        if len(unknown):
            raise ValueError(f"the scores must be numbers. Got NaN for {len(unknown)} of {len(values)}.")
        best = _best(values, k)
        names = best if candidates is None else np.asarray(candidates)[best]
        return cls(names, values[best])


def _best(values: NDArray[np.float32], k: int) -> NDArray[np.int64]:
    """Return the positions of the ``k`` largest values, largest first, ties in the order they came in."""
    if 4 * k < len(values):  # sorting all of a long map for its few best would take longer than finding them
        worst = np.partition(values, len(values) - k)[len(values) - k]
        above, ties = np.flatnonzero(values > worst), np.flatnonzero(values == worst)
        kept = np.sort(np.concatenate([above, ties[: k - len(above)]]))
        return np.asarray(kept[np.argsort(-values[kept], kind="stable")])
    return np.argsort(-values, kind="stable")[:k]
