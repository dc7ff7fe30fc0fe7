"""One episode of an agent in an environment, and the numbers of it."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.envs.agent import Agent, AnyEnv, bare
from vpr_bench.envs.task import Order
from vpr_bench.metrics.definitions import evaluate as evaluate_matches
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Protocol


@dataclass(frozen=True, eq=False)
class Evaluation:
    """What an agent answered in one episode, sorted by query.

    Attributes
    ----------
    protocol : Protocol
        What it was asked.
    order : {"shuffled", "sequential"}
        How queries followed each other.
    queries : (n,) int64
        Ascending.
    indices : (n, k) int64
        Ranked references, padded with -1.
    scores : (n, k) float32
        Padded with -inf.
    rewards : (n,) float64
        Of each query.
    ground_truth : GroundTruth
        Of these queries.
    """

    protocol: Protocol
    order: Order
    queries: NDArray[np.int64]
    indices: NDArray[np.int64]
    scores: NDArray[np.float32]
    rewards: NDArray[np.float64]
    ground_truth: GroundTruth

    def match_arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return the answers as a run stores them."""
        return {"queries": self.queries, "indices": self.indices, "scores": self.scores}

    def metrics(self, names: Iterable[str]) -> dict[str, float]:
        """Compute metrics by their ids.

        Raises
        ------
        UsageError
            If a name is unknown.
        """
        return evaluate_matches(names, self.indices, self.scores, self.ground_truth, self.protocol.unmatched)


def evaluate(env: AnyEnv, agent: Agent, seed: int = 0) -> Evaluation:
    """Ask a fitted agent every query once.

    Parameters
    ----------
    env : VprEnv or VprVectorEnv
        May be wrapped. If a wrapper ends the episode early, only the queries asked until then are counted.
    agent : Agent
        Fitted.
    seed : int
        Of the order of the queries; that of a run of the same seed is the same.

    Raises
    ------
    gymnasium.error.InvalidAction
        If an answer is not valid.
    """
    inner = bare(env)
    rows: list[tuple[NDArray[Any], ...]] = []
    observation, info = env.reset(seed=seed)
    over = False
    while not over:
        action = agent.act(observation, info)
        observation, reward, terminated, truncated, info = env.step(action)
        over = bool(np.all(terminated) or np.all(truncated))
        asked = np.atleast_1d(info.get("_query", True))
        answers = inner.action_space.parse(action, asked)
        rows.append((np.atleast_1d(info["query"])[asked], *answers, np.atleast_1d(np.asarray(reward))[asked]))
    queries, indices, scores, rewards = (np.concatenate(column) for column in zip(*rows, strict=True))
    by_query = np.argsort(queries)
    queries = queries[by_query]
    return Evaluation(
        inner.protocol,
        inner.task.order,
        queries,
        indices[by_query],
        scores[by_query],
        rewards[by_query].astype(np.float64),
        inner.case.ground_truth.take(queries),
    )
