"""A hidden Markov model of where one is: the forward filter."""

from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import Field
from scipy.optimize import brentq

from vpr_baselines.sequence.wrapper import SequenceWrapper
from vpr_bench.timing import stage
from vpr_bench.types.match import Match

_STEEPEST = 700.0  # logarithm of the largest ratio of neighbouring probabilities that a float64 holds
_LEAST = 1e-15  # a probability nearer to 0 or 1 than this is rounding


def paced(fastest: int, mean: float) -> NDArray[np.float64]:
    """Return the distribution of largest entropy over 0 to ``fastest`` that has this mean, 0 < mean < fastest.

    It is a geometric one, cut off: each step is as many times as likely as the one before.

    Returns
    -------
    (fastest + 1,) float64

    Examples
    --------
    >>> paced(2, 1.0).round(3), paced(3, 1.0).round(3)
    (array([0.333, 0.333, 0.333]), array([0.421, 0.277, 0.182, 0.12 ]))
    """
    steps = np.arange(fastest + 1)

    def distribution(rate: float) -> NDArray[np.float64]:
        logs = rate * steps
        weights = np.exp(logs - logs.max())
        return np.asarray(weights / weights.sum())

    rate = brentq(lambda rate: float(distribution(rate) @ steps) - mean, -_STEEPEST, _STEEPEST)
    return distribution(rate)


@dataclass
class ForwardFilter(SequenceWrapper):
    """A discrete Bayes filter over the references on the similarities of any method; it looks at the past only.

    The state is the reference that one stands at. From query to query it moves on by 0 to ``v_max`` references, by
    ``pace`` on average and with no further assumption (the distribution of largest entropy; the default makes 0, 1
    and 2 equally likely), or now and then to anywhere: a gap in the recording, a wrong belief. The contrasted
    similarity c of a reference is evidence of likelihood exp(sharpness · c). The score is the log-odds of the
    posterior after the forward pass (Rabiner, Proc. IEEE 1989, section III A); no query after the one that is asked
    changes it. The defaults were chosen on the real Gardens Point day_left-day_right and the simulated day and night;
    real nights and Nordland had no vote.

    Parameters
    ----------
    v_max : int
        Fastest motion in references per query.
    pace : float
        Average motion in references per query: 1 where both were recorded alike. Below ``v_max``.
    sharpness : float
        How much a similarity that stands out is trusted.
    jump : float
        Probability that the motion was to anywhere on the map, at least 1e-9: no belief is beyond correction.
    """

    version: ClassVar[str] = "1"

    v_max: Annotated[int, Field(ge=1, le=100_000)] = 2
    pace: Annotated[float, Field(gt=0)] = 1.0
    sharpness: Annotated[float, Field(gt=0)] = 0.25
    jump: Annotated[float, Field(ge=1e-9, le=1)] = 0.01

    def __post_init__(self) -> None:
        """Check the motion.

        Raises
        ------
        ValueError
            If the average is as fast as the fastest.
        """
        if self.pace >= self.v_max:
            raise ValueError(f"pace must be below v_max. Got {self.pace} and {self.v_max} instead.")
        super().__post_init__()

    def reset(self) -> None:
        """Know nothing of where one is."""
        self._belief: NDArray[np.float64] | None = None

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Move on by one (H, W, 3) uint8 RGB query and answer with the ``k`` most probable places."""
        row = self.row(image)
        with stage("sequence"):
            logs = self.sharpness * row.astype(np.float64)
            belief = self._predicted() * np.exp(logs - logs.max())
            self._belief = belief / belief.sum()
            inside = np.clip(self._belief, _LEAST, 1 - _LEAST)
            return Match.from_scores(np.log(inside) - np.log1p(-inside), k)

    @cached_property
    def _motion(self) -> NDArray[np.float64]:
        """(v_max + 1,) float64: how likely it is to move on by so many references."""
        return paced(self.v_max, self.pace)

    def _predicted(self) -> NDArray[np.float64]:
        """Return the (N,) probabilities before the query is looked at; what drives off the map may be anywhere."""
        size = self.size_
        if self._belief is None:
            return np.full(size, 1 / size)
        moved = np.zeros(size)
        for step, probability in enumerate(self._motion[:size]):
            moved[step:] += (1 - self.jump) * probability * self._belief[: size - step]
        return np.asarray(moved + (1 - moved.sum()) / size)
