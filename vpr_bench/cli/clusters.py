"""``vpr-bench clusters``: the clusters that a method makes of a dataset's references."""

import sys
from collections.abc import Mapping
from contextlib import redirect_stdout
from decimal import Decimal
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import complain, say, show, write
from vpr_bench.cli.options import EditionOption, Format, FormatOption, ParamOption
from vpr_bench.cli.parameters import sort_parameters
from vpr_bench.cli.where import say_where
from vpr_bench.errors import UsageError

if TYPE_CHECKING:
    from vpr_bench.maps.references import References
    from vpr_bench.report.cluster_study import ClusterStudy
    from vpr_bench.report.cluster_table import ClusterReport
    from vpr_bench.types.traverse import Traverse

_MOST_VALUES = 1000

CLUSTERS_EXAMPLES = """[bold]Examples[/bold]

vpr-bench clusters gardens

vpr-bench clusters gardens --param n_clusters=23 --plot clusters.png

vpr-bench clusters gardens --study n_clusters=5..100..5 --plot study.png

vpr-bench clusters path/to/my/images --method my_file.py:MyMethod --format json
"""


def clusters(
    dataset: Annotated[
        str, typer.Argument(help="Dataset, dataset:edition, protocol id, or a folder of your own.", metavar="NAME|PATH")
    ],
    method: Annotated[
        str | None,
        typer.Option(
            "--method",
            "-m",
            help="Name, module:Class or my_file.py:Class. Default: the first one that clusters.",
            metavar="NAME",
        ),
    ] = None,
    param: ParamOption = None,
    references: Annotated[
        str | None,
        typer.Option(help="Traverses to cluster, also parts of them (summer.every10).", metavar="TRAVERSE"),
    ] = None,
    protocol: Annotated[str | None, typer.Option(help="Whose references to cluster. Default: the first.")] = None,
    edition: EditionOption = "auto",
    study: Annotated[
        str | None,
        typer.Option(
            help="Cluster with several values of a parameter, and compare: a,b,c or first..last..step.",
            metavar="NAME=VALUES",
        ),
    ] = None,
    plot: Annotated[Path | None, typer.Option(help="Draw the clusters, or the study.", metavar="FILE.png")] = None,
    form: FormatOption = "table",
) -> None:
    """Print which references a method puts into which cluster: start, stop, size and cohesion of each."""
    from vpr_bench.maps.references import of_dataset
    from vpr_bench.method.build import build_method
    from vpr_bench.method.clustering import ReferenceClusterer, clustering_method
    from vpr_bench.report.cluster_study import ClusterStudy
    from vpr_bench.report.cluster_table import ClusterReport

    asked = None if study is None else parse_study(study)
    _check_picture(plot, of_study=asked is not None)
    # Stdout is for results: what a method prints is not one.
    with redirect_stdout(sys.stderr), progress_bars():
        name = method or clustering_method()
        given = sort_parameters([name], param or [])[name]
        parameter, values = asked or ("", [])
        changes = {value: {parameter: value} for value in values} or {"": {}}
        built = {value: build_method(name, given | change, 0) for value, change in changes.items()}
        found = of_dataset(dataset, references, protocol, edition)
        say_where(found.part.dataset or dataset, found.part.edition, found.base, chosen=_chosen(dataset, edition))
        source, clusterer = _source(found), ReferenceClusterer(found.traverse)
        reports, failed = {}, 0
        for value, one in built.items():
            try:
                reports[value] = ClusterReport(one.label, source, clusterer.cluster(one))
            except UsageError as error:  # of one value, others may do
                complain(str(error))
                failed = error.exit_code
    if reports and asked is not None:
        _show_study(
            ClusterStudy(_label(name, given), source, parameter, list(reports), list(reports.values())), form, plot
        )
    elif reports:
        _show_report(reports[""], found.traverse, form, plot)
    if failed:
        raise typer.Exit(failed)


def parse_study(text: str) -> tuple[str, list[str]]:
    """Read ``name=a,b,c``, where ``first..last`` and ``first..last..step`` stand for all numbers from there to there.

    Raises
    ------
    UsageError
        If it is not written so, or there are very many values.

    Examples
    --------
    >>> parse_study("n_clusters=2,5..20..5")
    ('n_clusters', ['2', '5', '10', '15', '20'])
    >>> parse_study("similarity=0.6..0.7..0.05")
    ('similarity', ['0.6', '0.65', '0.7'])
    """
    name, equals, rest = text.partition("=")
    if not name or not equals or not rest:
        raise UsageError(f"A study is written name=value,value or name=first..last..step. Got {text!r} instead.")
    values = [value for part in rest.split(",") for value in (_range(part) if ".." in part else [part])]
    return name, list(dict.fromkeys(values))


def _range(text: str) -> list[str]:
    try:
        first, last, step = (Decimal(part) for part in [*text.split(".."), "1"][:3])
        count = int((last - first) // step) + 1
    except (ArithmeticError, ValueError):
        count = 0
    if not 0 < count <= _MOST_VALUES or text.count("..") > 2:
        raise UsageError(
            f"A range is written first..last or first..last..step, with at most {_MOST_VALUES} values. "
            f"Got {text!r} instead."
        )
    return [f"{(first + number * step).normalize():f}" for number in range(count)]


def _check_picture(file: Path | None, *, of_study: bool) -> None:
    """Refuse a picture that cannot be drawn before anything is computed."""
    from vpr_bench.report.figure import FORMATS, check_picture

    if file is not None:
        check_picture(file, FORMATS if of_study else ["png"])


def _show_report(report: "ClusterReport", references: "Traverse", form: Format, plot: Path | None) -> None:
    from vpr_bench.report.cluster_sheet import draw_cluster_sheet

    _print(report, form)
    if plot is not None:
        with progress_bars():
            say(f"drawn: {draw_cluster_sheet(report, references, plot)}")


def _show_study(study: "ClusterStudy", form: Format, plot: Path | None) -> None:
    _print(study, form)
    if plot is not None:
        say(f"drawn: {study.draw(plot)}")


def _print(result: "ClusterReport | ClusterStudy", form: Format) -> None:
    if form == "json":
        write(result.json())
    elif form == "csv":
        write(result.csv())
    elif form == "markdown":
        write(result.grid().markdown())
    else:
        show(result.grid().rich())


def _label(name: str, given: Mapping[str, str]) -> str:
    """Name a method with the parameters that were given."""
    return f"{name}({', '.join(f'{key}={value}' for key, value in given.items())})" if given else name


def _source(found: "References") -> str:
    """Name what is clustered: dataset, edition and traverse."""
    edition = "" if found.part.edition == "real" else f":{found.part.edition}"
    return f"{found.part.dataset}{edition}/{found.part.traverse}"


def _chosen(dataset: str, edition: str) -> bool:
    """Say whether the user named the edition."""
    return edition != "auto" or ":" in dataset
