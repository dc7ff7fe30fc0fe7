"""The gate: whether methods still answer as they did when the baseline was recorded.

A baseline is a file that is committed: per method and protocol what was answered, query by query, and the rules that
say how far new answers may fall behind. Nothing here prints.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vpr_bench.gate.baseline import Baseline as Baseline
    from vpr_bench.gate.baseline import read_baseline as read_baseline
    from vpr_bench.gate.baseline import write_baseline as write_baseline
    from vpr_bench.gate.cell import Cell as Cell
    from vpr_bench.gate.judging import judge as judge
    from vpr_bench.gate.recording import record_cell as record_cell
    from vpr_bench.gate.rules import Overrides as Overrides
    from vpr_bench.gate.rules import Rule as Rule
    from vpr_bench.gate.rules import Rules as Rules
    from vpr_bench.gate.update import updated as updated
    from vpr_bench.gate.verdict import Judgement as Judgement
    from vpr_bench.gate.verdict import Verdict as Verdict

_LAZY = {
    "Baseline": "baseline",
    "Cell": "cell",
    "Judgement": "verdict",
    "Overrides": "rules",
    "Rule": "rules",
    "Rules": "rules",
    "Verdict": "verdict",
    "judge": "judging",
    "read_baseline": "baseline",
    "record_cell": "recording",
    "updated": "update",
    "write_baseline": "baseline",
}

__all__ = [
    "Baseline",
    "Cell",
    "Judgement",
    "Overrides",
    "Rule",
    "Rules",
    "Verdict",
    "judge",
    "read_baseline",
    "record_cell",
    "updated",
    "write_baseline",
]


def __getattr__(name: str) -> Any:
    """Import a public name when it is first used."""
    if name in _LAZY:
        return getattr(import_module(f"vpr_bench.gate.{_LAZY[name]}"), name)
    raise AttributeError(f"module 'vpr_bench.gate' has no attribute {name!r}")
