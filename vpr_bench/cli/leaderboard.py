"""``vpr-bench leaderboard``: stored runs become the rows of one file, and that becomes tables and a page."""

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import say, show, write
from vpr_bench.cli.options import RUNS, Format, FormatOption
from vpr_bench.cli.stored import RunArgument
from vpr_bench.errors import DataError, UsageError, VprBenchError

if TYPE_CHECKING:
    from vpr_bench.leaderboard.merge import Merge
    from vpr_bench.leaderboard.renewal import Renewal
    from vpr_bench.leaderboard.standing import Board
    from vpr_bench.runner.store import StoredRun

_PAGE = "index.html"

LEADERBOARD_EXAMPLES = """[bold]Examples[/bold]

vpr-bench leaderboard

vpr-bench leaderboard 3f2a 9bc4 --output boards --no-page

vpr-bench leaderboard --check
"""


def leaderboard(
    run: RunArgument = None,
    runs: Annotated[
        Path | None,
        typer.Option(help=f"Folder that holds the runs. Default: {RUNS}, if there are any.", file_okay=False),
    ] = None,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder of results.csv and the tables.", file_okay=False)
    ] = Path("leaderboards"),
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; exit with 1 if anything is not as it would be written.")
    ] = False,
    page: Annotated[bool, typer.Option(help="Make index.html too, with curves and pictures of failures.")] = True,
    form: FormatOption = "table",
) -> None:
    """Put stored runs into results.csv, and make ranked tables of it, one per protocol.

    Rows whose runs are not here stay. A newer run of the same method, protocol and machine replaces the older one,
    unless it asked fewer queries or kept fewer answers.
    """
    from vpr_bench.leaderboard.renewal import claimed, renewal
    from vpr_bench.leaderboard.results import RESULTS

    _check_output(output)
    stored = _stored(run, runs, optional=(output / RESULTS).exists())
    leave_out = None if run else _leave_out
    if check:
        with progress_bars():
            stale = renewal(output, stored, leave_out).stale()
        _judge(stale, run or [], runs, output)
        return
    if page:
        _check_page(output / _PAGE)
    with progress_bars(), claimed(output):
        made = renewal(output, stored, leave_out)
        made.write()
        _tell(made.merge, stored if run else [], output)
        _print(made, form)
        if page:
            _write_page(made.boards, [*stored, *(_whole_folder(runs or RUNS) if run else [])], output / _PAGE)


def _check_output(folder: Path) -> None:
    from vpr_bench.runner.store import RECORD

    if next(folder.glob(f"*/*/*/*/{RECORD}"), None):
        raise UsageError(
            f"{folder} holds runs, and --output is where the tables go. Take the runs from there with --runs {folder}, "
            "and give another --output."
        )


def _stored(names: list[str] | None, root: Path | None, optional: bool) -> list["StoredRun"]:
    """Return the named runs, or all; none only where rows are there already and no folder was named."""
    from vpr_bench.runner.select import select_runs

    if names:
        return select_runs(names, root or RUNS)
    found = _whole_folder(root or RUNS)
    if not found and (root is not None or not optional):
        raise DataError(f"There are no runs under {root or RUNS}. Make one with `vpr-bench run`, or give --runs.")
    return found


def _whole_folder(root: Path) -> list["StoredRun"]:
    from vpr_bench.runner.store import RunStore

    return RunStore(root).runs()


def _leave_out(error: VprBenchError) -> None:
    say(f"warning: {error} It is left out.")


def _judge(stale: Sequence[Path], names: Sequence[str], runs: Path | None, output: Path) -> None:
    if not stale:
        say(f"{output} is up to date.")
        return
    for path in stale:
        say(f"not up to date: {path}")
    command = ["vpr-bench", "leaderboard", *names, *(["--runs", str(runs)] if runs else []), "--output", str(output)]
    files = "1 file is" if len(stale) == 1 else f"{len(stale)} files are"
    raise VprBenchError(f"{files} not what would be written now. Renew with `{shlex.join(command)}`.")


def _tell(merged: "Merge", named: Sequence["StoredRun"], output: Path) -> None:
    from vpr_bench.report.foreign import shortened

    for what, entries in (("new", merged.new), ("replaced", merged.replaced), ("dropped", merged.dropped)):
        for entry in entries:
            partial = f" ({entry.n_queries} of {entry.n_available} queries)" if entry.partial else ""
            say(f"{what}: {shortened(entry.method)} on {entry.protocol}, machine {entry.machine}{partial}")
    there = {entry.run for entry in merged.entries}
    for run in named:
        if run.record.key.digest() not in there:
            say(
                f"passed over: {run.folder}: of its method and protocol there is a newer run, or one of all queries, "
                "or one that kept more answers (--k)."
            )
    dropped = f", {len(merged.dropped)} dropped" if merged.dropped else ""
    say(
        f"{len(merged.new)} row{'s' * (len(merged.new) != 1)} new, {len(merged.replaced)} replaced, "
        f"{len(merged.kept)} unchanged{dropped}. Tables: {output}"
    )


def _print(made: "Renewal", form: Format) -> None:
    from vpr_bench.leaderboard.folder import OVERVIEW
    from vpr_bench.leaderboard.overview import overview_grids
    from vpr_bench.leaderboard.results import to_csv, to_json

    if form == "json":
        write(to_json(made.merge.entries))
    elif form == "csv":
        write(to_csv(made.merge.entries).removesuffix("\n"))
    elif form == "markdown":
        write(made.tables[OVERVIEW].removesuffix("\n"))
    else:
        for grid in overview_grids(made.boards):
            show(grid.rich())


def _check_page(file: Path) -> None:
    from vpr_bench.page.page import check_room

    check_room(file)


def _write_page(boards: Sequence["Board"], runs: Sequence["StoredRun"], file: Path) -> None:
    from vpr_bench.page.page import write_page

    shown = {one.entry.run for board in boards for one in board.standings}
    here = {run.record.key.digest(): run for run in runs}
    write_page(
        boards, {run: here[run] for run in here if run in shown}, file, lambda message: say(f"warning: {message}")
    )
    say(f"page: {file}")
