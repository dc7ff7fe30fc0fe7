"""``vpr-bench gate``: whether stored runs are as good as the baseline says."""

import json
import sys
from contextlib import redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import complain, say, show, write
from vpr_bench.cli.options import RUNS
from vpr_bench.cli.parameters import find_here
from vpr_bench.errors import DataError, UsageError

if TYPE_CHECKING:
    from vpr_bench.gate.evidence import Evidence
    from vpr_bench.gate.rules import Overrides
    from vpr_bench.gate.verdict import Judgement

GATE_EXAMPLES = """[bold]Examples[/bold]

vpr-bench gate --baseline leaderboards/baseline.json --run

vpr-bench gate --baseline leaderboards/baseline.json --update

vpr-bench gate --method hog --dataset gardens --tolerance recall@1=0.01 --significance 0.05

vpr-bench gate --run --exact --junit gate.xml --format markdown >> "$GITHUB_STEP_SUMMARY"
"""

GateFormat = Literal["table", "json", "junit", "markdown"]


def gate(
    baseline: Annotated[
        Path, typer.Option(help="The file that answers are compared with.", metavar="FILE", dir_okay=False)
    ] = Path("baseline.json"),
    runs: Annotated[
        Path, typer.Option("--runs", "--output", "-o", help="Folder that holds the runs.", file_okay=False)
    ] = RUNS,
    run: Annotated[
        bool, typer.Option("--run", help="Run what the baseline lists and is not stored, as it was recorded.")
    ] = False,
    method: Annotated[
        list[str] | None,
        typer.Option("--method", "-m", help="Only this method (repeat)."),
    ] = None,
    trust: Annotated[
        list[str] | None,
        typer.Option(
            help="With --run: a method whose code may be run though not installed (repeat).", metavar="FILE.py:CLASS"
        ),
    ] = None,
    dataset: Annotated[
        list[str] | None, typer.Option(help="Only this dataset (repeat): gardens, gardens:real, or a folder.")
    ] = None,
    protocol: Annotated[
        list[str] | None, typer.Option(help="Only references-queries (repeat); with @5f, only of that radius.")
    ] = None,
    tolerance: Annotated[
        list[str] | None,
        typer.Option(help="Largest drop of a metric that passes; repeat for more.", metavar="METRIC=DROP"),
    ] = None,
    significance: Annotated[
        float | None, typer.Option(help="A drop fails if chance does that less often; 0: not tested.", metavar="P")
    ] = None,
    exact: Annotated[
        bool | None, typer.Option("--exact/--no-exact", help="Any query with another best answer fails.")
    ] = None,
    latency_ratio: Annotated[
        float | None,
        typer.Option(help="How many times as long the median query may take, on the same machine.", metavar="R"),
    ] = None,
    update: Annotated[
        bool, typer.Option("--update", help="Write the runs into the baseline, and these rules if any are given.")
    ] = False,
    prune: Annotated[bool, typer.Option("--prune", help="With --update: drop the cells without a run.")] = False,
    junit: Annotated[Path | None, typer.Option(help="Write JUnit XML as well.", metavar="FILE", dir_okay=False)] = None,
    markdown: Annotated[
        Path | None, typer.Option(help="Write Markdown as well.", metavar="FILE", dir_okay=False)
    ] = None,
    form: Annotated[GateFormat, typer.Option("--format", "-f", help="How to write the result to stdout.")] = "table",
) -> None:
    """Compare stored runs with a baseline: fail if accuracy fell by more than the rules allow.

    Exit code 0: all is well; 1: something fell or is missing; 3: images, runs or the baseline are missing or damaged.
    """
    from vpr_bench.gate.baseline import Baseline, read_baseline
    from vpr_bench.gate.evidence import collect, run_and_collect
    from vpr_bench.gate.gathering import with_names
    from vpr_bench.gate.selection import Selection
    from vpr_bench.gate.words import advice

    if prune and not update:
        raise UsageError("--prune drops cells from the file: give it with --update.")
    overrides = _overrides(tolerance, significance, exact, latency_ratio)
    find_here(*(method or []), *(trust or []))
    # Stdout is for results: what a method prints is not one.
    with redirect_stdout(sys.stderr), progress_bars():
        old = read_baseline(baseline) if baseline.exists() or not update else Baseline()
        if not (old.cells or update):
            raise DataError(f"{baseline} holds no cells: nothing would be judged. Record some with --update.")
        overrides.apply(old.rules)  # so that a typing error costs no time
        selection = Selection(method or [], dataset or [], protocol or [], trust or [])
        evidence = run_and_collect(old, selection, runs, say) if run else collect(old, selection, runs)
        judgement = evidence.judge(overrides, recording=update)
        judgement = with_names(judgement, evidence.runs, selection.sources, lambda told: say(f"note: {told}"))
    _print(judgement, form, junit, markdown)
    if not update:
        for line in advice(judgement):
            say(line)
        raise typer.Exit(judgement.exit_code)
    _update(evidence, judgement, overrides, baseline, prune=prune)


def _overrides(
    tolerance: list[str] | None, significance: float | None, exact: bool | None, latency_ratio: float | None
) -> "Overrides":
    from vpr_bench.gate.rules import Overrides

    drops = {}
    for assignment in tolerance or []:
        metric, _, drop = assignment.partition("=")
        try:
            drops[metric] = float(drop)
        except ValueError:
            raise UsageError(f"A tolerance is written metric=drop. Got {assignment!r} instead.") from None
    return Overrides(drops, significance, exact, latency_ratio)


def _update(evidence: "Evidence", judgement: "Judgement", overrides: "Overrides", path: Path, *, prune: bool) -> None:
    """Write the new baseline, unless something is wrong with what it would be made of."""
    from vpr_bench.gate.baseline import being_updated, write_baseline
    from vpr_bench.gate.update import updated

    if judgement.count("error"):
        complain(f"{path} is left as it is: what could not be judged cannot be recorded.")
        raise typer.Exit(judgement.exit_code)
    if not (evidence.recordable or prune):
        why = " Runs with --limit are not recorded: a baseline needs all queries." if evidence.partial else ""
        raise DataError(f"{path} is left as it is: there is nothing to record.{why}")
    asked = evidence.asked.cells
    with being_updated(path) as old:  # perhaps not what was judged: another process may have added its cells
        changes = updated(old, evidence.runs, overrides, only=asked, prune=prune, named=evidence.named)
        written = write_baseline(changes.baseline, path)
    say(f"{path}: {changes.summary() if written else 'unchanged'}")


def _print(judgement: "Judgement", form: GateFormat, junit: Path | None, markdown: Path | None) -> None:
    from vpr_bench.gate.junit import to_junit
    from vpr_bench.gate.markdown import to_markdown
    from vpr_bench.gate.tables import render

    if form == "json":
        write(json.dumps(judgement.as_dict(), indent=2))
    elif form == "table":
        show(render(judgement))
    else:
        write(to_junit(judgement) if form == "junit" else to_markdown(judgement))
    for path, written in ((junit, to_junit), (markdown, to_markdown)):  # last: the verdict is told whatever happens
        if path is not None:
            _write(path, written(judgement) + "\n")


def _write(path: Path, text: str) -> None:
    from vpr_bench.files.atomic import write_bytes
    from vpr_bench.files.disk import disk_errors

    with disk_errors(path):
        path.parent.mkdir(parents=True, exist_ok=True)
    write_bytes(path, text.encode())
