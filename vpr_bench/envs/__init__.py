"""The harness as Gymnasium environments: one episode asks every query of a protocol once.

``import vpr_bench`` makes the ids known, ``vpr_bench/Gardens-v0`` and so on, without importing Gymnasium; the names
below are imported when they are first used.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vpr_bench.envs.agent import Agent as Agent
    from vpr_bench.envs.agent import MethodAgent as MethodAgent
    from vpr_bench.envs.evaluation import Evaluation as Evaluation
    from vpr_bench.envs.evaluation import evaluate as evaluate
    from vpr_bench.envs.ids import env_id as env_id
    from vpr_bench.envs.latency import RecordLatency as RecordLatency
    from vpr_bench.envs.ranking import Ranking as Ranking
    from vpr_bench.envs.single import VprEnv as VprEnv
    from vpr_bench.envs.vector import VprVectorEnv as VprVectorEnv
    from vpr_bench.envs.vector_latency import RecordVectorLatency as RecordVectorLatency

_LAZY = {
    "Agent": "agent",
    "Evaluation": "evaluation",
    "MethodAgent": "agent",
    "Ranking": "ranking",
    "RecordLatency": "latency",
    "RecordVectorLatency": "vector_latency",
    "VprEnv": "single",
    "VprVectorEnv": "vector",
    "env_id": "ids",
    "evaluate": "evaluation",
}

__all__ = [
    "Agent",
    "Evaluation",
    "MethodAgent",
    "Ranking",
    "RecordLatency",
    "RecordVectorLatency",
    "VprEnv",
    "VprVectorEnv",
    "env_id",
    "evaluate",
]


def __getattr__(name: str) -> Any:
    """Import a public name when it is first used."""
    if name in _LAZY:
        return getattr(import_module(f"vpr_bench.envs.{_LAZY[name]}"), name)
    raise AttributeError(f"module 'vpr_bench.envs' has no attribute {name!r}")
