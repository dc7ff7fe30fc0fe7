"""SeqSLAM's search: the place whose last few frames fit best, along straight lines through the similarities."""

from collections import deque
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.sequence.wrapper import SequenceWrapper
from vpr_bench.timing import stage
from vpr_bench.types.match import Match

_STEP = 0.1  # between two velocities
_Count = Annotated[int, Field(ge=0, le=10_000)]
_Velocity = Annotated[float, Field(ge=0, le=1000)]  # a line for every tenth: more would take for ever


@dataclass
class SeqSlam(SequenceWrapper):
    """SeqSLAM (Milford and Wyeth, ICRA 2012) on the similarities of any method, query by query.

    A reference's score is the mean contrasted similarity along the straight line that ends there, at the velocity
    that fits best. The published search knows frames before and after; ours is causal unless ``future`` is set.
    ``contrast`` was chosen on the real Gardens Point day_left-day_right and the simulated day and night (real nights
    and Nordland had no vote), the velocities are the paper's.

    Parameters
    ----------
    past : int
        How many frames before the query are looked at; fewer at the start of the sequence.
    future : int
        How many frames after the query are looked at. It has to wait for them.
    v_min, v_max : float
        Slowest and fastest motion in references per query; a tenth apart in between.
    """

    version: ClassVar[str] = "1"

    past: _Count = 10
    future: _Count = 0
    v_min: _Velocity = 0.8
    v_max: _Velocity = 1.2

    def __post_init__(self) -> None:
        """Check the velocities.

        Raises
        ------
        ValueError
            If the slowest is faster than the fastest.
        """
        if self.v_min > self.v_max:
            raise ValueError(f"v_min must not exceed v_max. Got {self.v_min} and {self.v_max} instead.")
        super().__post_init__()

    def reset(self) -> None:
        """Forget the queries so far."""
        self._rows: deque[NDArray[np.float32]] = deque()
        self._answered = 0

    def foresee(self, image: NDArray[np.uint8]) -> None:
        """Take in the next (H, W, 3) uint8 RGB frame."""
        self._rows.append(self.row(image))

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer the oldest frame that was not answered, ``image`` if none was foreseen, with at most ``k`` places."""
        if self._answered == len(self._rows):
            self.foresee(image)
        with stage("sequence"):
            answer = Match.from_scores(self._along_lines(self._answered), k)
        self._answered += 1
        while self._answered > self.past:
            self._rows.popleft()
            self._answered -= 1
        return answer

    @cached_property
    def _lines(self) -> list[tuple[int, ...]]:
        """Where each line is, in references before its end, from ``past`` frames before the query to ``future`` after.

        Different velocities can be the same line over a short window; each is there once.
        """
        velocities = np.linspace(self.v_min, self.v_max, round((self.v_max - self.v_min) / _STEP) + 1)
        frames = np.arange(self.past, -self.future - 1, -1)
        return list(dict.fromkeys(tuple(np.rint(velocity * frames).astype(int).tolist()) for velocity in velocities))

    def _along_lines(self, query: int) -> NDArray[np.float32]:
        """Return (N,) float32: per reference, the best mean along a line; outside the map nothing stands out."""
        rows = list(self._rows)[: query + self.future + 1]
        first = self.past - query  # the window's frames before the sequence began
        best = np.full(self.size_, -np.inf, dtype=np.float32)
        for line in self._lines:
            total = np.zeros(self.size_, dtype=np.float32)
            for row, back in zip(rows, line[first:], strict=False):
                if 0 <= back < self.size_:
                    total[back:] += row[: self.size_ - back]
                elif -self.size_ < back < 0:
                    total[:back] += row[-back:]
            np.maximum(best, total, out=best)
        return np.asarray(best / np.float32(len(rows)))
