"""Everything about one run that is no metric."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vpr_bench.errors import one_line

if TYPE_CHECKING:
    from rich.console import RenderableType

    from vpr_bench.runner.record import RunRecord
    from vpr_bench.runner.store import StoredRun


def details(run: "StoredRun") -> "RenderableType":
    """Lay out what a run was made of: method, data, order, machine and versions."""
    record = run.record
    return facts_table(
        {
            "folder": str(run.folder),
            "method": f"{record.key.method}, version {record.key.version}",
            **{f"  {name}": str(value) for name, value in record.key.parameters.items()},
            "weights": record.key.weights or "none",
            "dataset": record.key.dataset_digest,
            "queries": _order(record),
            "seed, k, limit": f"{record.key.seed}, {record.key.k}, {record.key.limit or 'none'}",
            "fitting": f"{record.fit_seconds:.1f} s, {record.peak_memory['fit'] / 2**20:.0f} MiB at its peak",
            "matching": f"{record.peak_memory['match'] / 2**20:.0f} MiB at its peak",
            "continued": "yes, after an interruption" if record.resumed else "no",
            "created": record.created,
            "machine": str(record.machine),
            "system": f"{record.machine.system}, Python {record.machine.python}",
            "libraries": ", ".join(f"{name} {version}" for name, version in record.machine.libraries.items()),
        }
    )


def facts_table(facts: Mapping[str, str]) -> "RenderableType":
    """Lay out facts by name, one below the other; what a name or a fact holds may be anybody's."""
    from rich.table import Table
    from rich.text import Text

    table = Table(show_header=False, box=None, pad_edge=False)
    table.add_column(style="bold")
    table.add_column(overflow="fold")
    for name, value in facts.items():
        indent = "  " if name.startswith(" ") else ""
        table.add_row(Text(indent + one_line(name)), Text(one_line(value)))
    return table


def _order(record: "RunRecord") -> str:
    """Say in which order the queries were asked, and what the method knew of those to come."""
    if record.order == "shuffled":
        return "shuffled by the seed"
    return f"in their order, {record.future} frames ahead" if record.future else "in their order"
