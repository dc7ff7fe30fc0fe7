"""Agents: what answers queries in an environment, and how any method becomes one."""

from typing import Any, Protocol, runtime_checkable

import gymnasium
import numpy as np
from gymnasium.vector import VectorEnv
from numpy.typing import NDArray

from vpr_bench.envs.ranking import Action, Ranking
from vpr_bench.envs.single import VprEnv
from vpr_bench.envs.vector import VprVectorEnv
from vpr_bench.errors import UsageError, VprBenchError, blaming
from vpr_bench.method.build import build_method
from vpr_bench.method.faults import fault_in, shortfall_in
from vpr_bench.method.interfaces import Method

AnyEnv = gymnasium.Env[Any, Any] | VectorEnv[Any, Any, Any]

_WARM_UP = 3  # as many as in a run: a method that counts its calls answers the same in both


@runtime_checkable
class Agent(Protocol):
    """Learns the map of an environment, then answers what it is shown."""

    def fit(self, env: AnyEnv) -> None:
        """Learn ``env.unwrapped.references``. Fitting again forgets the former map."""
        ...

    def act(self, observation: NDArray[np.uint8], info: dict[str, Any]) -> Action:
        """Answer one observation; in a vector environment, a whole batch of them."""
        ...


def bare(env: AnyEnv) -> VprEnv | VprVectorEnv:
    """Return the environment inside all wrappers.

    Raises
    ------
    UsageError
        If it is none of ours.
    """
    inner = env.unwrapped
    if not isinstance(inner, VprEnv | VprVectorEnv):
        raise UsageError(
            f"This needs a VprEnv or a VprVectorEnv. Got {type(inner).__name__} instead; "
            "vector environments are made with vectorization_mode='vector_entry_point'."
        )
    return inner


class MethodAgent:
    """A method as an agent: it is shown each image as it is, and what it answers becomes the action.

    Parameters
    ----------
    method : Method or str
        Not fitted yet; a name is looked up as on the command line.
    k : int, optional
        Places that it is asked for; by default as many as the environment takes.
    """

    def __init__(self, method: Method | str, k: int | None = None) -> None:
        self.method: Method = build_method(method).method if isinstance(method, str) else method
        self.k = k

    def fit(self, env: AnyEnv) -> None:
        """Fit the method on the map, and warm it up on one of its images, as a run does.

        Raises
        ------
        UsageError
            If the environment is none of ours, or takes fewer than ``k`` places.
        VprBenchError
            If the method fails.
        """
        inner = bare(env)
        if self.k is not None and not 1 <= self.k <= inner.k:
            raise UsageError(f"The environment takes 1 to {inner.k} places per answer. Got k={self.k} instead.")
        self.k_ = self.k or inner.k
        self.space_: Ranking = getattr(inner, "single_action_space", inner.action_space)
        self.batched_ = isinstance(inner, VectorEnv)
        with blaming(f"{type(self.method).__name__} failed while fitting"):
            self.method.fit(inner.references)
        with blaming(f"{type(self.method).__name__} failed while warming up"):
            for _ in range(_WARM_UP):
                self.method.match(inner.references[0], self.k_)

    def act(self, observation: NDArray[np.uint8], info: dict[str, Any]) -> Action:
        """Answer one query, or each of a batch.

        Raises
        ------
        VprBenchError
            If the method fails, or answers nonsense.
        """
        if not self.batched_:
            return self._answer(observation, info["size"])
        indices = np.full((len(observation), self.space_.k), -1, dtype=np.int64)
        scores = np.full(indices.shape, -np.inf, dtype=np.float32)
        for row in np.flatnonzero(info["mask"]):
            answer = self._answer(observation[row], info["size"][row])
            indices[row], scores[row] = answer["indices"], answer["scores"]
        return {"indices": indices, "scores": scores}

    def _answer(self, image: NDArray[np.uint8], size: NDArray[np.int64]) -> Action:
        height, width = size.tolist()
        name, places = type(self.method).__name__, self.space_.n_references
        with blaming(f"{name} failed while answering"):
            match = self.method.match(np.ascontiguousarray(image[:height, :width]), self.k_)
        fault = fault_in(match, places, self.k_) or shortfall_in(match, self.method, places, self.k_)
        if fault:
            raise VprBenchError(f"{name} answered a query with {fault}.")
        return self.space_.of(match)
