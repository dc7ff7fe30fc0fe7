"""``vpr-bench compare``: whether one stored run is better than another on the same queries."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import say, show, write
from vpr_bench.cli.options import RUNS, Format, FormatOption, MetricOption, OutputOption, UnmatchedOption
from vpr_bench.cli.results import check_metrics

if TYPE_CHECKING:
    from vpr_bench.compare.paired import PairedComparison
    from vpr_bench.report.pictures import RunPictures

COMPARE_EXAMPLES = """[bold]Examples[/bold]

vpr-bench compare 3f2a 9bc4

vpr-bench compare 3f2a 9bc4 --radius 5 --metric recall@1 --metric pr_auc --plot flips.png

vpr-bench compare before/run after/run --format json
"""

_RUN = "a run's folder, or the first digits of its hash."
_LEAST = 100  # resamples: of fewer, a 95 % interval says nothing


def compare(
    a: Annotated[str, typer.Argument(help=f"The run to be beaten: {_RUN}", metavar="A")],
    b: Annotated[str, typer.Argument(help=f"The run that may be better: {_RUN}", metavar="B")],
    metric: MetricOption = None,
    radius: Annotated[
        float | None, typer.Option(help="Radius instead of the one that both were run with.", metavar="R")
    ] = None,
    unmatched: UnmatchedOption = None,
    resamples: Annotated[int, typer.Option(min=_LEAST, help="Of the bootstrap over queries.", metavar="N")] = 2000,
    seed: Annotated[int, typer.Option(min=0, help="Of the bootstrap.")] = 0,
    plot: Annotated[
        Path | None,
        typer.Option(help="Draw the queries that only one of them answers right.", metavar="FILE.png"),
    ] = None,
    dataset: Annotated[
        str | None,
        typer.Option(help="Where the images are, if not where the dataset's name says: a folder.", metavar="NAME"),
    ] = None,
    output: OutputOption = RUNS,
    form: FormatOption = "table",
) -> None:
    """Say whether run B is better than run A, query by query on the same queries. No method is asked.

    Differences are B minus A, ratios of times B over A. Intervals are of a paired bootstrap.
    """
    from vpr_bench.compare.paired import compare_runs
    from vpr_bench.report.figure import check_picture
    from vpr_bench.report.pictures import RunPictures
    from vpr_bench.runner.select import select_run

    if plot is not None:
        check_picture(plot, ["png"])
    metrics = check_metrics(metric, ()) or None
    first, second = select_run(a, output), select_run(b, output)
    with progress_bars():
        comparison = compare_runs(
            first, second, metrics, radius=radius, unmatched=unmatched, resamples=resamples, seed=seed
        )
        pictures = RunPictures(first, lambda message: say(f"warning: {message}"), dataset, render=plot is not None)
        _print(comparison, pictures, form)
        if plot is not None:
            _draw(comparison, pictures, plot)


def _print(comparison: "PairedComparison", pictures: "RunPictures", form: Format) -> None:
    from vpr_bench.compare.caveats import caveats, time_caveats
    from vpr_bench.compare.export import to_csv, to_json
    from vpr_bench.compare.tables import comparison_grids

    def file_of(query: int) -> str | None:
        return pictures.query_name(query) if pictures.case else None

    if form == "json":
        write(to_json(comparison, file_of))
    elif form == "csv":
        write(to_csv(comparison, file_of))
        for note in (*caveats(comparison), *time_caveats(comparison)):
            say(f"note: {note}")
    elif form == "markdown":
        write("\n\n".join(grid.markdown() for grid in comparison_grids(comparison, pictures.query_name)))
    else:
        for grid in comparison_grids(comparison, pictures.query_name):
            show(grid.rich())


def _draw(comparison: "PairedComparison", pictures: "RunPictures", file: Path) -> None:
    from vpr_bench.compare.flip_sheet import draw_flips

    if comparison.lost or comparison.gained:
        say(f"drawn: {draw_flips(comparison, pictures, file)}")
    else:
        say(f"Both answer the same queries right: there is nothing to draw, and {file} is not written.")
