"""How long an agent thinks."""

import time
from typing import Any, SupportsFloat

import gymnasium
import numpy as np
from gymnasium.utils import RecordConstructorArgs
from numpy.typing import NDArray

from vpr_bench.envs.ranking import Action
from vpr_bench.metrics.latency import TOTAL, latency


class RecordLatency(gymnasium.Wrapper[NDArray[np.uint8], Action, NDArray[np.uint8], Action], RecordConstructorArgs):
    """Measures the time between each observation and its action.

    That is the agent's time alone: images are decoded before the clock starts. Nothing is written into infos, which
    therefore stay the same from one time to the next. It should be the outermost wrapper.

    Parameters
    ----------
    env : gymnasium.Env
        With one query per step; a batch has no latency per query.

    Attributes
    ----------
    seconds : list of float
        Of every step of the episode so far.

    Examples
    --------
    >>> env = RecordLatency(gymnasium.make("vpr_bench/Gardens-v0", edition="simulated"))  # doctest: +SKIP
    >>> evaluate(env, agent), env.summary()["latency_total_p95"]  # doctest: +SKIP
    """

    def __init__(self, env: gymnasium.Env[NDArray[np.uint8], Action]) -> None:
        RecordConstructorArgs.__init__(self)
        gymnasium.Wrapper.__init__(self, env)
        self.seconds: list[float] = []
        self._shown = 0.0

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.uint8], dict[str, Any]]:
        """Begin an episode; what was measured before is forgotten."""
        self.seconds = []
        answer = self.env.reset(seed=seed, options=options)
        self._shown = time.perf_counter()
        return answer

    def step(self, action: Action) -> tuple[NDArray[np.uint8], SupportsFloat, bool, bool, dict[str, Any]]:
        """Stop the clock, answer, and start it again."""
        taken = time.perf_counter() - self._shown
        answer = self.env.step(action)
        self.seconds.append(taken)
        self._shown = time.perf_counter()
        return answer

    def summary(self) -> dict[str, float]:
        """Return ``latency_total_p50``, ``_p95`` and ``_p99`` of the episode so far, in milliseconds."""
        return latency({TOTAL: np.array(self.seconds)})
