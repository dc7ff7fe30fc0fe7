"""The conformance suite: whether a plug-in keeps what the harness relies on.

Methods, datasets and environments are each looked at by a list of small checks, whose ids never change.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vpr_bench.check.examination import Examination as Examination
    from vpr_bench.check.outcome import Failed as Failed
    from vpr_bench.check.outcome import Outcome as Outcome
    from vpr_bench.check.parametrize import parametrize_with_checks as parametrize_with_checks

_LAZY = {
    "Examination": "examination",
    "Failed": "outcome",
    "Outcome": "outcome",
    "parametrize_with_checks": "parametrize",
}

__all__ = ["Examination", "Failed", "Outcome", "parametrize_with_checks"]


def __getattr__(name: str) -> Any:
    """Import a public name when it is first used."""
    if name in _LAZY:
        return getattr(import_module(f"vpr_bench.check.{_LAZY[name]}"), name)
    raise AttributeError(f"module 'vpr_bench.check' has no attribute {name!r}")
