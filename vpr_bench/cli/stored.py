"""``vpr-bench show`` and ``vpr-bench score``: what stored runs say, and what they would say otherwise."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.console import complain, say, write
from vpr_bench.cli.console import show as show_result
from vpr_bench.cli.details import details
from vpr_bench.cli.options import (
    RUNS,
    BootstrapOption,
    Format,
    FormatOption,
    MetricOption,
    OutputOption,
    PlotStepsOption,
    RadiusOption,
    UnmatchedOption,
    parse_radii,
)
from vpr_bench.cli.results import Scoring, check_metrics, print_rows, print_sweep
from vpr_bench.errors import DataError, UsageError, VprBenchError, blaming

if TYPE_CHECKING:
    from vpr_bench.report.rows import Row
    from vpr_bench.runner.store import StoredRun

SHOW_EXAMPLES = """[bold]Examples[/bold]

vpr-bench show

vpr-bench show 3f2a --plot-stages lost.png

vpr-bench show 3f2a --provenance

vpr-bench show runs/gardens/day_left-night_right/hog/9bc4cf0169f3 --format json
"""
SCORE_EXAMPLES = """[bold]Examples[/bold]

vpr-bench score --radius 0..10 --metric recall@1 --metric pr_auc --metric pr_auc_matched --plot radius.png

vpr-bench score 3f2a --metric pr_auc --metric recall@10 --bootstrap 2000
"""

_DRAWN = ("recall@1", "pr_auc", "pr_auc_matched")

RunArgument = Annotated[
    list[str] | None, typer.Argument(help="Run folder, or the first digits of its hash. Default: all runs.")
]


def show(
    run: RunArgument = None,
    provenance: Annotated[
        bool, typer.Option("--provenance", help="Say how each run came about: command, code, versions, machine.")
    ] = False,
    plot_stages: PlotStepsOption = None,
    output: OutputOption = RUNS,
    form: FormatOption = "table",
) -> None:
    """Show stored runs: a table of all, or everything about the named ones."""
    from vpr_bench.report.losses import losses_grid
    from vpr_bench.report.rows import HEADLINE
    from vpr_bench.runner.select import select_runs

    if provenance:
        if plot_stages is not None:
            raise UsageError("--provenance draws nothing: leave out --plot-stages.")
        _show_provenance(select_runs(run, output), form)
        return
    _check_pictures(plot_stages)
    runs = select_runs(run, output)
    rows, failed = _score(runs, Scoring(check_metrics(None, HEADLINE), None, None, 0))
    print_rows(rows, form)
    if run and form == "table":
        for row in rows:
            if row.steps:
                show_result(losses_grid(row).rich())
        for one in runs:
            show_result(details(one))
    _draw_stages(rows, plot_stages)
    raise typer.Exit(failed)


def score(
    run: RunArgument = None,
    metric: MetricOption = None,
    radius: RadiusOption = None,
    unmatched: UnmatchedOption = None,
    bootstrap: BootstrapOption = 0,
    plot: Annotated[
        Path | None,
        typer.Option(
            help=f"Draw metrics against the radius: those of --metric, else {', '.join(_DRAWN)}.", metavar="FILE.png"
        ),
    ] = None,
    plot_stages: PlotStepsOption = None,
    output: OutputOption = RUNS,
    form: FormatOption = "table",
) -> None:
    """Compute metrics again from stored runs: other radii, other metrics, other policy. No method is asked.

    Several radii make tables of each metric against the radius.
    """
    from vpr_bench.metrics.definitions import METRICS
    from vpr_bench.runner.select import select_runs

    _check_pictures(plot, plot_stages)
    radii = parse_radii(radius)
    swept = radii is not None and len(radii) > 1
    if plot is not None and not swept:
        raise UsageError("--plot draws metrics against the radius: give several, such as --radius 0..10.")
    drawn = check_metrics(metric, _DRAWN)
    scoring = Scoring(check_metrics(metric, list(METRICS)), radii, unmatched, bootstrap)
    rows, failed = _score(select_runs(run, output), scoring)
    (print_sweep if swept else print_rows)(rows, form)
    if plot is not None and rows:
        from vpr_bench.report.radius_curve import draw_radius_curve

        say(f"drawn: {draw_radius_curve(rows, drawn, plot)}")
    _draw_stages(rows, plot_stages)
    raise typer.Exit(failed)


def _show_provenance(runs: list["StoredRun"], form: Format) -> None:
    from vpr_bench.cli.provenance import provenance_block, provenance_content

    if form not in ("table", "json"):
        raise UsageError(f"--provenance is written as table or json. Got {form!r} instead.")
    if form == "json":
        write(json.dumps([provenance_content(run) for run in runs], indent=2, ensure_ascii=False))
        return
    for number, run in enumerate(runs):
        if number:
            show_result("")
        show_result(provenance_block(run))


def _check_pictures(*files: Path | None) -> None:
    """Refuse a picture that cannot be drawn before anything is computed."""
    from vpr_bench.report.figure import check_picture

    for file in files:
        if file is not None:
            check_picture(file)


def _draw_stages(rows: list["Row"], file: Path | None) -> None:
    if file is not None and rows:
        from vpr_bench.report.waterfall import draw_waterfall

        say(f"drawn: {draw_waterfall(rows, file)}")


def _score(runs: list["StoredRun"], scoring: Scoring) -> tuple[list["Row"], int]:
    """Score all runs that can be; return their rows, and the exit code that the others deserve."""
    rows: list[Row] = []
    failed = 0
    for run in runs:
        try:
            with blaming(f"{run.folder} is damaged", DataError):
                rows += scoring.rows(run)
        except VprBenchError as error:
            complain(str(error))
            failed = max(failed, error.exit_code)
    return rows, failed
