"""``vpr-bench show`` and ``vpr-bench score``: what stored runs say, and what they would say otherwise."""

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.console import complain
from vpr_bench.cli.console import show as show_result
from vpr_bench.cli.options import (
    RUNS,
    BootstrapOption,
    Format,
    FormatOption,
    MetricOption,
    OutputOption,
    RadiusOption,
    UnmatchedOption,
    parse_radii,
)
from vpr_bench.cli.results import Scoring, check_metrics, print_rows
from vpr_bench.errors import DataError, UsageError, VprBenchError, blaming

if TYPE_CHECKING:
    from rich.console import RenderableType

    from vpr_bench.runner.record import RunRecord
    from vpr_bench.runner.store import StoredRun

SHOW_EXAMPLES = """[bold]Examples[/bold]

vpr-bench show

vpr-bench show 3f2a

vpr-bench show runs/gardens/day_left-night_right/hog/9bc4cf0169f3 --format json
"""
SCORE_EXAMPLES = """[bold]Examples[/bold]

vpr-bench score --radius 0,1,2,3,5,10

vpr-bench score 3f2a --metric pr_auc --metric recall@10 --bootstrap 2000
"""

RunArgument = Annotated[
    list[str] | None, typer.Argument(help="Run folder, or the first digits of its hash. Default: all runs.")
]


def show(run: RunArgument = None, output: OutputOption = RUNS, form: FormatOption = "table") -> None:
    """Show stored runs: a table of all, or everything about the named ones."""
    from vpr_bench.report.rows import HEADLINE

    runs = _select(run, output)
    scoring = Scoring(check_metrics(None, HEADLINE), None, None, 0)
    failed = _print(runs, scoring, form)
    if run and form == "table":
        for one in runs:
            show_result(_details(one))
    raise typer.Exit(failed)


def score(
    run: RunArgument = None,
    metric: MetricOption = None,
    radius: RadiusOption = None,
    unmatched: UnmatchedOption = None,
    bootstrap: BootstrapOption = 0,
    output: OutputOption = RUNS,
    form: FormatOption = "table",
) -> None:
    """Compute metrics again from stored runs: other radii, other metrics, other policy. No method is asked."""
    from vpr_bench.metrics.definitions import METRICS

    scoring = Scoring(check_metrics(metric, list(METRICS)), parse_radii(radius), unmatched, bootstrap)
    raise typer.Exit(_print(_select(run, output), scoring, form))


def _print(runs: list["StoredRun"], scoring: Scoring, form: Format) -> int:
    """Print the rows of all runs that can be scored; return the exit code that the others deserve."""
    rows, failed = [], 0
    for run in runs:
        try:
            with blaming(f"{run.folder} is damaged", DataError):
                rows += scoring.rows(run)
        except VprBenchError as error:
            complain(str(error))
            failed = max(failed, error.exit_code)
    print_rows(rows, form)
    return failed


def _select(names: list[str] | None, output: Path) -> list["StoredRun"]:
    from vpr_bench.runner.store import RunStore, StoredRun

    if not names:
        runs = RunStore(output).runs()
        if not runs:
            raise DataError(f"There are no runs under {output}. Make one with `vpr-bench run`, or give --output.")
        return runs
    selected = []
    for name in names:
        if (Path(name) / "run.json").exists():
            selected.append(StoredRun.open(Path(name)))
            continue
        if not re.fullmatch("[0-9a-f]+", name):
            raise UsageError(f"{name!r} is neither a run's folder nor the beginning of a run's hash.")
        found = sorted(output.glob(f"*/*/*/{name}*/run.json"))
        found = [record for record in found if "." not in record.parent.name]
        if len(found) != 1:
            problem = f"{len(found)} runs begin with" if found else "no run begins with"
            raise UsageError(f"Under {output} {problem} {name!r}. `vpr-bench show` lists them.")
        selected.append(StoredRun.open(found[0].parent))
    return selected


def _order(record: "RunRecord") -> str:
    """Say in which order the queries were asked, and what the method knew of those to come."""
    if record.order == "shuffled":
        return "shuffled by the seed"
    return f"in their order, {record.future} frames ahead" if record.future else "in their order"


def _details(run: "StoredRun") -> "RenderableType":
    from rich.table import Table
    from rich.text import Text

    record = run.record
    facts = {
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
        "processor": f"{record.machine.processor}, {record.machine.cores} cores, {record.machine.threads} threads",
        "system": f"{record.machine.system}, Python {record.machine.python}",
        "libraries": ", ".join(f"{name} {version}" for name, version in record.machine.libraries.items()),
    }
    table = Table(show_header=False, box=None, pad_edge=False)
    table.add_column(style="bold")
    table.add_column(overflow="fold")
    for name, value in facts.items():
        table.add_row(name, Text(value))
    return table
