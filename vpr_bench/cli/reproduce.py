"""``vpr-bench reproduce``: a stored run done again, and whether it answers the same."""

import json
import sys
from contextlib import redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import say, show, write
from vpr_bench.cli.listing import TextFormatOption
from vpr_bench.cli.options import RUNS
from vpr_bench.errors import DataError, blaming, one_line

if TYPE_CHECKING:
    from rich.console import RenderableType

    from vpr_bench.report.rows import Row
    from vpr_bench.runner.agreement import Agreement
    from vpr_bench.runner.environment import Difference

REPRODUCE_EXAMPLES = """[bold]Examples[/bold]

vpr-bench reproduce 3f2a

vpr-bench reproduce runs/gardens/day_left-night_right/hog/9bc4cf0169f3 --format json

vpr-bench reproduce 3f2a --method path/to/my_method.py:MyMethod --dataset path/to/my/images
"""

_LATENCY = "latency_total_p50"


def reproduce(
    run: Annotated[str, typer.Argument(help="Run folder, or the first digits of its hash.")],
    method: Annotated[
        list[str] | None,
        typer.Option(
            "--method", "-m", help="Where a method is that is not installed; repeat for more.", metavar="FILE.py:CLASS"
        ),
    ] = None,
    dataset: Annotated[
        str | None, typer.Option(help="Where the images are, if in a folder of your own.", metavar="PATH")
    ] = None,
    runs: Annotated[Path, typer.Option(help="Folder that holds the run.", file_okay=False)] = RUNS,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder that the new run goes to.", file_okay=False)
    ] = Path("reproduced"),
    form: TextFormatOption = "table",
) -> None:
    """Do a stored run again, exactly, and say whether it answers the same: exit 0 if so, 1 if not.

    Exit 3 if method, weights or images are no longer those of the run. The run itself is left as it is.
    """
    from vpr_bench.report.rows import score_run
    from vpr_bench.runner.agreement import agreement
    from vpr_bench.runner.environment import differences
    from vpr_bench.runner.reproduce import reproduce as do_again
    from vpr_bench.runner.select import select_run
    from vpr_bench.runner.store import RunStore

    original = select_run(run, runs)
    with blaming(f"{original.folder} is damaged", DataError):
        before = score_run(original)  # first: what cannot be compared is not worth the time
    with redirect_stdout(sys.stderr), progress_bars():
        again = do_again(original, RunStore(output), method or (), dataset)
        say(one_line(f"{again.record.label} on {again.record.protocol}: {again.folder}"))
    with blaming(f"{original.folder} is damaged", DataError):
        agreed = agreement(original, again)
    after, changed = score_run(again), differences(original.record, again.record)
    if form == "json":
        write(json.dumps(_content(before, after, agreed, changed), indent=2, ensure_ascii=False))
    else:
        show(_report(before, after, agreed, changed))
    raise typer.Exit(not agreed.identical)


def _content(before: "Row", after: "Row", agreed: "Agreement", changed: list["Difference"]) -> dict[str, Any]:
    first, second = before.as_dict(), after.as_dict()
    return {
        "method": before.method,
        "protocol": str(before.protocol),
        "recorded": first["folder"],
        "again": second["folder"],
        **agreed.as_dict(),
        "metrics": {
            name: {"recorded": value, "again": second["metrics"][name]} for name, value in first["metrics"].items()
        },
        "latency_ms": {
            _LATENCY: {"recorded": first["latency_ms"].get(_LATENCY), "again": second["latency_ms"].get(_LATENCY)}
        },
        "elsewhere": {
            side: row.run.record.provenance.elsewhere for side, row in (("recorded", before), ("again", after))
        },
        "environment": [{"what": one.what, "recorded": one.first, "again": one.second} for one in changed],
    }


def _report(before: "Row", after: "Row", agreed: "Agreement", changed: list["Difference"]) -> "RenderableType":
    from rich.console import Group
    from rich.text import Text

    from vpr_bench.report.grid import Grid
    from vpr_bench.report.numbers import share

    partial = " (partial)" if before.partial else ""
    numbers = [[name, share(value), share(after.metrics[name])] for name, value in before.metrics.items()]
    times = [f"{row.latency[_LATENCY]:.1f}" for row in (before, after)]
    others = [_percent(row.run.record.provenance.elsewhere) for row in (before, after)]
    rows = [*numbers, ["total ms, p50 (not judged)", *times], ["processor time of others, %", *others]]
    title = one_line(f"{before.method}{partial} on {before.protocol}, {agreed.queries} queries")
    lines = [Text(line, style="" if agreed.identical else "bold red") for line in verdict(agreed)]
    return Group(Grid(title, ["", "recorded", "again"], rows).rich(), *lines, _surroundings(changed))


def _percent(value: float | None) -> str:
    from vpr_bench.report.numbers import UNDEFINED

    return UNDEFINED if value is None else f"{100 * value:.1f}"


def _surroundings(changed: list["Difference"]) -> "RenderableType":
    """Lay out what both runs noted differently, and name what only one of them noted."""
    from rich.console import Group
    from rich.table import Table
    from rich.text import Text

    if not changed:
        return Text("Machine, system, code and versions are as they were.")
    table = Table(box=None, pad_edge=False)
    for head in ("not as it was", "recorded", "again"):
        table.add_column(head, overflow="fold")
    for what, first, second in changed:
        if first is not None and second is not None:
            table.add_row(*(Text(one_line(word)) for word in (what, first, second)))
    parts: list[RenderableType] = [Text(""), table] if table.row_count else []
    if unknown := ", ".join(one_line(one.what) for one in changed if one.first is None or one.second is None):
        parts.append(Text(f"Noted by one of the two only: {unknown}.", style="dim"))
    return Group(*parts)


def verdict(agreed: "Agreement") -> list[str]:
    """Say in words whether two runs answered the same."""
    if agreed.identical:
        packed = "" if agreed.same_file else ", though the file is packed otherwise"
        shortlists = "" if agreed.shortlists is None else ", and every shortlist"
        return [f"Identical: all {agreed.queries} answers, bit by bit{packed}{shortlists}."]
    lines = ["NOT identical."]
    lines.append(
        f"Of {agreed.queries} queries, {agreed.best} have another best match, {agreed.ranking} another ranking, "
        f"{agreed.scores} other scores; the largest difference of two scores is {agreed.largest:.3g}."
    )
    if agreed.unpaired:
        lines.append(f"{agreed.unpaired} queries were asked only once.")
    if not agreed.labels:
        lines.append("The places are others.")
    if agreed.shortlists is False:
        lines.append("The shortlists are others.")
    return lines
