"""The evaluation benchmark harness for Visual Place Recognition.

A method is fitted on a reference traverse, is shown query images one at a time, answers with ranked places and
a score, and the harness turns those answers into numbers that can be compared, trusted and repeated.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from vpr_bench.envs.hook import make_ids_known

if TYPE_CHECKING:
    __version__: str
    from vpr_bench.dataset.load import load_case as load_case
    from vpr_bench.maps.map import load_map as load_map
    from vpr_bench.runner.run import run as run
    from vpr_bench.timing import stage as stage
    from vpr_bench.types.ground_truth import GroundTruth as GroundTruth
    from vpr_bench.types.match import Match as Match
    from vpr_bench.types.protocol import Protocol as Protocol
    from vpr_bench.types.traverse import Traverse as Traverse

_LAZY = {
    "GroundTruth": "vpr_bench.types.ground_truth",
    "Match": "vpr_bench.types.match",
    "Protocol": "vpr_bench.types.protocol",
    "Traverse": "vpr_bench.types.traverse",
    "load_case": "vpr_bench.dataset.load",
    "load_map": "vpr_bench.maps.map",
    "run": "vpr_bench.runner.run",
    "stage": "vpr_bench.timing",
}

__all__ = ["GroundTruth", "Match", "Protocol", "Traverse", "__version__", "load_case", "load_map", "run", "stage"]

make_ids_known()


def __getattr__(name: str) -> Any:
    """Import public names when they are first used, so that start-up stays light."""
    if name == "__version__":
        from importlib.metadata import version

        return version("vpr-bench")
    if name in _LAZY:
        return getattr(import_module(_LAZY[name]), name)
    raise AttributeError(f"module 'vpr_bench' has no attribute {name!r}")
