"""The action: ranked places with scores, as a Gymnasium space."""

from typing import Any

import numpy as np
from gymnasium.error import InvalidAction
from gymnasium.spaces import Box, Dict, MultiDiscrete
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from vpr_bench.types.match import Match

Action = dict[str, Any]
"""Ranked places, best first, in two columns; those of a batch have one row per query.

``indices``, (k,) or (batch, k) int64
    References, each at most once; -1 where there are fewer than ``k``.
``scores``, (k,) or (batch, k) float32
    Finite and not increasing; what stands at a -1 is ignored.
"""


class Scores(Box):
    """Any scores: they are sampled between -1 and 1, as learners like it, but all finite numbers belong to it.

    Only their order matters to any metric, so that no bound would make sense. So does -inf, where nothing is answered.
    """

    def __init__(self, shape: tuple[int, ...], seed: int | np.random.Generator | None = None) -> None:
        super().__init__(-1.0, 1.0, shape, np.float32, seed)

    def contains(self, x: Any) -> bool:
        """Tell whether these are numbers of the right type and shape."""
        right = isinstance(x, np.ndarray) and x.shape == self.shape and np.can_cast(x.dtype, np.float32)
        return right and bool((x < np.inf).all())  # NaN is not less


class Ranking(Dict):
    """The space of valid answers: ``indices`` and ``scores``, as :data:`Action` says.

    Parameters
    ----------
    n_references : int
        Size of the map.
    k : int
        Places per answer.
    batch : int, optional
        For so many queries at once.
    seed : int or Generator, optional
        Of the samples.

    Examples
    --------
    >>> space = Ranking(n_references=200, k=3, seed=0)
    >>> space.sample() in space
    True
    >>> space.of(Match([7, 4], [0.9, 0.2]))["indices"].tolist()
    [7, 4, -1]
    """

    def __init__(
        self, n_references: int, k: int, batch: int | None = None, seed: int | np.random.Generator | None = None
    ) -> None:
        self.n_references, self.k, self.batch = n_references, k, batch
        shape = (k,) if batch is None else (batch, k)
        indices = MultiDiscrete(
            np.full(shape, n_references + 1, dtype=np.int64), start=np.full(shape, -1, dtype=np.int64)
        )
        super().__init__({"indices": indices, "scores": Scores(shape)}, seed=seed)

    def sample(self, mask: Any = None, probability: Any = None) -> dict[str, Any]:
        """Draw ``k`` different places in any order, with falling scores.

        Raises
        ------
        ValueError
            If a mask or probabilities are given: the parts of an answer cannot be drawn one by one.
        """
        if mask is not None or probability is not None:
            raise ValueError("a ranking is drawn as a whole: it takes neither mask nor probability")
        generator = self.spaces["indices"].np_random
        rows = [generator.choice(self.n_references, self.k, replace=False) for _ in range(self.batch or 1)]
        indices = np.stack(rows).astype(np.int64)
        scores = -np.sort(-self.spaces["scores"].sample(), axis=-1)
        return {"indices": indices[0] if self.batch is None else indices, "scores": scores}

    def contains(self, x: Any) -> bool:
        """Tell whether this is a valid answer."""
        if not super().contains(x):
            return False
        try:
            self.parse(x)
        except InvalidAction:
            return False
        return True

    def of(self, match: Match) -> Action:
        """Return what a method answered as an action, padded to ``k`` places; surplus ones are left out."""
        indices, scores = np.full(self.k, -1, dtype=np.int64), np.full(self.k, -np.inf, dtype=np.float32)
        kept = min(len(match), self.k)
        indices[:kept], scores[:kept] = match.indices[:kept], match.scores[:kept]
        return {"indices": indices, "scores": scores}

    def parse(
        self, action: Any, rows: NDArray[np.bool_] | None = None
    ) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
        """Check an action.

        Parameters
        ----------
        action : Action
            Anything that can be made arrays of will do.
        rows : (batch,) bool, optional
            Which rows are answers; what stands in the others does not matter.

        Returns
        -------
        indices : (n, k) int64
            A copy, one row per answer; padded with -1.
        scores : (n, k) float32
            Padded with -inf.

        Raises
        ------
        gymnasium.error.InvalidAction
            If it is not valid; says why.
        """
        indices, scores = self._arrays(action)
        chosen = slice(None) if rows is None else rows
        indices = indices.reshape(-1, self.k)[chosen].astype(np.int64)
        with np.errstate(over="ignore"):  # what float32 cannot hold becomes infinite, and is refused below
            scores = scores.reshape(-1, self.k)[chosen].astype(np.float32)
        answered = indices >= 0
        in_order = np.sort(indices, axis=1)
        faults = {
            f"reference indices must lie in [0, {self.n_references}), or be -1 for no answer": (
                (indices < -1) | (indices >= self.n_references)
            ),
            "a reference must be named only once": (in_order[:, 1:] == in_order[:, :-1]) & (in_order[:, 1:] >= 0),
            "after the first -1 there must be no further reference": answered[:, 1:] & ~answered[:, :-1],
            "scores must be finite": answered & ~np.isfinite(scores),
            "scores must not increase: best first": answered[:, 1:] & (scores[:, 1:] > scores[:, :-1]),
        }
        for fault, where in faults.items():
            if where.any():
                row = int(np.argmax(where.any(axis=1)))
                raise InvalidAction(f"{fault}. Got indices {indices[row]} with scores {scores[row]} instead.")
        scores[~answered] = -np.inf
        return indices, scores

    def _arrays(self, action: Any) -> tuple[NDArray[Any], NDArray[Any]]:
        """Take the two arrays out of an action and check their types and shapes."""
        try:
            indices, scores = np.asarray(action["indices"]), np.asarray(action["scores"])
        except (KeyError, TypeError, IndexError, ValueError):
            raise InvalidAction(
                f"An action is a dict of indices and scores. Got {type(action).__name__} instead."
            ) from None
        shape = self.spaces["indices"].shape
        if indices.shape != shape or scores.shape != shape:
            raise InvalidAction(
                f"indices and scores must both have shape {shape}; fewer answers are padded with -1. "
                f"Got {indices.shape} and {scores.shape} instead."
            )
        if indices.dtype.kind not in "iu" or scores.dtype.kind not in "iuf":
            raise InvalidAction(
                f"indices must be integers and scores numbers. Got {indices.dtype} and {scores.dtype} instead."
            )
        return indices, scores


@batch_space.register(Ranking)
def _batch_ranking(space: Ranking, n: int = 1) -> Ranking:
    """Serve Gymnasium's own vector environments; by default they would forget what makes an answer valid."""
    return Ranking(space.n_references, space.k, n, seed=int(space.np_random.integers(2**31)))
