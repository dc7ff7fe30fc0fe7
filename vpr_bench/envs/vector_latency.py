"""How long an agent thinks about a batch of queries."""

import time
from typing import Any, TypeAlias

import numpy as np
from gymnasium.vector import VectorEnv, VectorWrapper
from numpy.typing import NDArray

from vpr_bench.envs.ranking import Action
from vpr_bench.metrics.latency import percentiles

Images: TypeAlias = NDArray[np.uint8]
Column: TypeAlias = NDArray[Any]


class RecordVectorLatency(VectorWrapper[Images, Action, Images, Action, Column]):
    """Measures the time between each batch of observations and its actions.

    As :class:`~vpr_bench.envs.latency.RecordLatency` does for single queries. How long one query takes cannot be seen
    in a batch: its share is the time of the batch, divided by the queries in it. The last batch, which is filled up,
    counts as the few queries that it has.

    Parameters
    ----------
    env : gymnasium.vector.VectorEnv
        The outermost wrapper of it should be this one.

    Attributes
    ----------
    seconds : list of float
        Of every batch of the episode so far.
    queries : list of int
        How many there were in each.

    Examples
    --------
    >>> envs = RecordVectorLatency(gymnasium.make_vec("vpr_bench/Gardens-v0", num_envs=32))  # doctest: +SKIP
    >>> evaluate(envs, agent), envs.summary()["latency_query_p95"]  # doctest: +SKIP
    """

    def __init__(self, env: VectorEnv[Images, Action, Column]) -> None:
        super().__init__(env)
        self._begin()

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Images, dict[str, Any]]:
        """Begin an episode; what was measured before is forgotten."""
        self._begin()
        observations, info = self.env.reset(seed=seed, options=options)
        self._show(info)
        return observations, info

    def step(
        self, actions: Action
    ) -> tuple[Images, NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], dict[str, Any]]:
        """Stop the clock, answer, and start it again."""
        taken, asked = time.perf_counter() - self._shown, self._asked
        answer = self.env.step(actions)
        if asked:
            self.seconds.append(taken)
            self.queries.append(asked)
        else:  # the step after the last one begins the next episode
            self._begin()
        self._show(answer[4])
        return answer

    def summary(self) -> dict[str, float]:
        """Return percentiles of the episode so far, in milliseconds.

        Returns
        -------
        dict
            ``latency_batch_p50``, ``_p95`` and ``_p99`` over the batches, and ``latency_query_p50`` and so on over
            the queries, each with its share of its batch. NaN before the first batch.
        """
        batches = np.array(self.seconds)
        queries = np.repeat(batches / np.array(self.queries), self.queries)
        return percentiles("batch", batches) | percentiles("query", queries)

    def _begin(self) -> None:
        self.seconds: list[float] = []
        self.queries: list[int] = []
        self._asked = 0

    def _show(self, info: dict[str, Any]) -> None:
        self._asked = int(np.sum(info.get("mask", self.num_envs)))
        self._shown = time.perf_counter()
