"""A hidden Markov model of where one is: the forward filter."""

from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.sequence.wrapper import SequenceWrapper
from vpr_bench.timing import stage
from vpr_bench.types.match import Match

_LEAST = 1e-15  # a probability nearer to 0 or 1 than this is rounding


@dataclass
class ForwardFilter(SequenceWrapper):
    """A discrete Bayes filter over the references on the similarities of any method; it looks at the past only.

    The state is the reference that one stands at. From query to query it moves on by 0 to ``v_max`` references, each
    as likely, or now and then to anywhere (a gap in the recording, a wrong belief). The contrasted similarity c of a
    reference is evidence of likelihood exp(sharpness · c). The score is the log-odds of the posterior after the
    forward pass (Rabiner, Proc. IEEE 1989, section III A); no query after the one that is asked changes it. The
    defaults were chosen on the real Gardens Point day_left-day_right and the simulated day and night; real nights
    and Nordland were kept for testing.

    Parameters
    ----------
    v_max : int
        Fastest motion in references per query.
    sharpness : float
        How much a similarity that stands out is trusted.
    jump : float
        Probability that the motion was to anywhere on the map.
    """

    version: ClassVar[str] = "1"

    v_max: Annotated[int, Field(ge=1)] = 2
    sharpness: Annotated[float, Field(gt=0)] = 0.25
    jump: Annotated[float, Field(gt=0, le=1)] = 0.01

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

    def _predicted(self) -> NDArray[np.float64]:
        """Return the (N,) probabilities before the query is looked at; what drives off the map may be anywhere."""
        size = self.size_
        if self._belief is None:
            return np.full(size, 1 / size)
        moved = np.zeros(size)
        for step in range(min(self.v_max + 1, size)):
            moved[step:] += self._belief[: size - step]
        moved *= (1 - self.jump) / (self.v_max + 1)
        return np.asarray(moved + (1 - moved.sum()) / size)
