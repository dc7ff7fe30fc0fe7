"""``vpr-bench run``: methods on datasets."""

import sys
from contextlib import redirect_stdout
from itertools import product
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from vpr_bench.cli import INTERRUPTED
from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import complain, say
from vpr_bench.cli.options import (
    RUNS,
    BootstrapOption,
    EditionOption,
    FormatOption,
    MetricOption,
    OutputOption,
    ParamOption,
    RadiusOption,
    ThreadsOption,
    UnmatchedOption,
    parse_radii,
)
from vpr_bench.cli.parameters import sort_parameters
from vpr_bench.cli.results import Scoring, check_metrics, print_rows
from vpr_bench.cli.where import say_where
from vpr_bench.errors import DataError, UsageError, VprBenchError

if TYPE_CHECKING:
    from vpr_bench.dataset.load import Case
    from vpr_bench.method.build import BuiltMethod
    from vpr_bench.report.rows import Row
    from vpr_bench.runner.run import RunOptions
    from vpr_bench.runner.store import RunStore, StoredRun

EXAMPLES = """[bold]Examples[/bold]

vpr-bench run --method twostage --dataset gardens

vpr-bench run --method hog --method twostage --dataset gardens --protocol all

vpr-bench run --method twostage --param n_components=1 --dataset gardens --radius 0,1,2,5 --bootstrap 2000

vpr-bench run --method hog --dataset gardens:simulated --limit 20 --format json

vpr-bench run --method hog --method twostage --dataset thesis --edition simulated

vpr-bench run --method hog --dataset path/to/my/images

vpr-bench run --method path/to/my_method.py:MyMethod --timeout 5 --dataset gardens

vpr-bench run --method seqslam --param inner=efficientnet-lite0 --param past=20 --dataset gardens
"""


Overwrite = Literal["only-missing", "always", "never"]


def run(
    method: Annotated[
        list[str],
        typer.Option("--method", "-m", help="Name, module:Class or my_file.py:Class; repeat for more.", metavar="NAME"),
    ],
    dataset: Annotated[
        list[str],
        typer.Option(
            "--dataset",
            help="Dataset, group of them, dataset:edition, protocol id, or a folder of your own; repeat.",
            metavar="NAME",
        ),
    ],
    protocol: Annotated[
        list[str] | None,
        typer.Option(help="references-queries, by name or of any of the traverses, or all. Default: the first."),
    ] = None,
    edition: EditionOption = "auto",
    param: ParamOption = None,
    radius: RadiusOption = None,
    unmatched: UnmatchedOption = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the order of the queries and of the methods.")] = 0,
    k: Annotated[int | None, typer.Option("--k", help="Answers kept per query. Default: 20, or the whole map.")] = None,
    limit: Annotated[
        int | None,
        typer.Option(
            help="Only the first N queries: of the shuffled ones, or, by sequence methods, in order.", metavar="N"
        ),
    ] = None,
    timeout: Annotated[
        float | None,
        typer.Option(help="How long one answer may take; a method that takes longer has failed.", metavar="SECONDS"),
    ] = None,
    threads: ThreadsOption = None,
    overwrite: Annotated[Overwrite, typer.Option(help="What becomes of stored runs.")] = "only-missing",
    metric: MetricOption = None,
    bootstrap: BootstrapOption = 0,
    output: OutputOption = RUNS,
    form: FormatOption = "table",
) -> None:
    """Run methods on datasets, and print one line for each.

    Runs are stored; what is stored already is shown, not run again, and what was interrupted is continued.
    """
    from vpr_bench.method.build import build_method
    from vpr_bench.report.rows import HEADLINE
    from vpr_bench.runner.run import RunOptions
    from vpr_bench.runner.store import RunStore

    radii = parse_radii(radius)
    scoring = Scoring(check_metrics(metric, HEADLINE), radii, unmatched, bootstrap)
    store, options = RunStore(output), RunOptions(seed, k, limit, threads, overwrite, timeout)
    rows: list[Row] = []
    failures = []
    try:
        # Stdout is for results: what a method prints is not one.
        with redirect_stdout(sys.stderr), progress_bars():
            methods = sort_parameters(method, param or [])
            for name, given in methods.items():
                build_method(name, given, seed)  # so that a typing error costs no time
            for case, (name, given) in product(_load(dataset, protocol, edition, scoring), methods.items()):
                try:
                    # A new one each time: what it did on another protocol must not change its answers.
                    stored = _run_one(case, build_method(name, given, seed), store, options)
                    scored = scoring.rows(stored, case.protocol)
                    rows += scored
                    if overwrite != "never":
                        _draw(scored, stored)
                except VprBenchError as error:
                    complain(str(error))
                    failures.append(error.exit_code)
    except KeyboardInterrupt:
        failures.append(INTERRUPTED)
    print_rows(rows, form)
    if failures:
        raise typer.Exit(max(failures))


def _draw(rows: list["Row"], stored: "StoredRun") -> None:
    """Draw the curves beside the run; without them the run is complete all the same."""
    from vpr_bench.report.curve import draw_curve

    try:
        draw_curve(rows, stored.folder)
    except DataError as error:
        say(f"warning: there is no picture: {error}")


def _load(datasets: list[str], protocols: list[str] | None, edition: str, scoring: "Scoring") -> list["Case"]:
    """Load every case, and say where the images come from."""
    from vpr_bench.dataset.card import expand_groups
    from vpr_bench.dataset.load import load_case

    cases = []
    for name in expand_groups(datasets):
        for pairing in _pairings(name, protocols, edition):
            # Loaded and stored at the protocol's own radius: another one only changes how answers are scored.
            case = load_case(name, pairing, edition, unmatched=scoring.unmatched)
            for radius in scoring.radii or []:
                case.places.check(case.protocol.with_radius(radius))
            cases.append(case)
        said = cases[-1].protocol
        say_where(said.dataset, said.edition, cases[-1].folder, chosen=edition != "auto" or ":" in name)
    return cases


def _pairings(name: str, protocols: list[str] | None, edition: str) -> list[str | None]:
    """Return what is asked of one dataset: a protocol each, None for its first."""
    from vpr_bench.dataset.request import Request
    from vpr_bench.dataset.source import Source

    if protocols != ["all"]:
        return [*dict.fromkeys(protocols)] if protocols else [None]
    request = Request.parse(name, edition=edition)
    if request.pairing is not None:
        raise UsageError(f"{name!r} names a protocol, but --protocol says all.")
    source = Source.find(request)
    return [f"{one.pairing}@{one.reach}" for one in source.card.listed_protocols()]


def _run_one(case: "Case", built: "BuiltMethod", store: "RunStore", options: "RunOptions") -> "StoredRun":
    from vpr_bench.runner.run import find_run, run_key
    from vpr_bench.runner.run import run as run_method

    found = find_run(store, run_key(case, built, options), options.overwrite)
    cell = f"{built.label} on {case.protocol.source}/{case.protocol.pairing}"
    say(f"{cell}: {'stored already' if found else 'running'}")
    stored = found or run_method(case, built, store, options)
    say(f"{cell}: {stored.folder}")
    return stored
