"""``vpr-bench bench methods``: methods timed side by side."""

import json
import shlex
import sys
from contextlib import redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import show, write
from vpr_bench.cli.listing import PageFormat
from vpr_bench.cli.options import EditionOption, ThreadsOption
from vpr_bench.cli.parameters import sort_parameters, split_assignment
from vpr_bench.cli.where import say_where
from vpr_bench.errors import UsageError

if TYPE_CHECKING:
    from vpr_bench.bench.variants import Variant

METHODS_EXAMPLES = """[bold]Examples[/bold]

vpr-bench bench methods --dataset gardens --variant twostage --variant "twostage n_components=1 rerank=cosine"

vpr-bench bench methods --dataset gardens --variant gardens.map --variant "gardens.map n_components=1" --rounds 5

vpr-bench bench methods --dataset gardens --variant hog --variant path/to/my_method.py:MyMethod --format json
"""


def methods(
    dataset: Annotated[
        str, typer.Option(help="Dataset, dataset:edition, protocol id, or a folder of your own.", metavar="NAME")
    ],
    variant: Annotated[
        list[str],
        typer.Option(
            help="A method or a map, and its name=value parameters, in quotes. Repeat: the first is what others are "
            "compared with.",
            metavar="'NAME [name=value …]'",
        ),
    ],
    protocol: Annotated[str | None, typer.Option(help="references-queries. Default: the first.")] = None,
    edition: EditionOption = "auto",
    limit: Annotated[int, typer.Option(min=1, help="How many queries are asked.", metavar="N")] = 50,
    rounds: Annotated[int, typer.Option(min=1, help="How often each is asked.", metavar="R")] = 3,
    k: Annotated[int | None, typer.Option("--k", help="Answers per query. Default: 20, or the whole map.")] = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the queries, and of the order of the methods.")] = 0,
    threads: ThreadsOption = None,
    form: Annotated[PageFormat, typer.Option("--format", "-f", help="How to write the result to stdout.")] = "table",
) -> None:
    """Time methods side by side: fitted in one process, asked the same images in memory in turn.

    Prints milliseconds per query and stage, and how many times as long each takes as the first.
    """
    from vpr_bench.bench.methods import run
    from vpr_bench.dataset.load import load_case
    from vpr_bench.report.comparison import comparison_grid

    # Stdout is for results: what a method prints is not one.
    with redirect_stdout(sys.stderr), progress_bars():
        variants = [read_variant(text, seed) for text in variant]  # first, so that a typing error costs no time
        case = load_case(dataset, protocol, edition)
        said = case.protocol
        say_where(said.dataset, said.edition, case.folder, chosen=edition != "auto" or ":" in dataset)
        comparison = run(case, variants, limit=limit, rounds=rounds, threads=threads, seed=seed, k=k)
    if form == "json":
        write(json.dumps(comparison.as_dict(), indent=2, ensure_ascii=False))
    elif form == "markdown":
        write(comparison_grid(comparison).markdown())
    else:
        show(comparison_grid(comparison).rich())


def read_variant(text: str, seed: int) -> "Variant":
    """Read ``name parameter=value …``, where the name is that of a method or the folder of a map.

    Words are taken apart as a shell does, so that one with spaces can be put in quotes.

    Raises
    ------
    UsageError
        If it is not written so, or the method or a parameter does not exist.
    DataError
        If the map is damaged, or of another version.
    """
    from vpr_bench.bench.variants import Variant
    from vpr_bench.maps.map import load_map
    from vpr_bench.method.build import build_method

    try:
        name, *assignments = shlex.split(text)
    except ValueError:
        raise UsageError(f"A variant is written 'method name=value …'. Got {text!r} instead.") from None
    if (Path(name) / "map.json").exists():
        return Variant.of_map(text, load_map(name, parameters=dict(map(split_assignment, assignments))))
    return Variant(text, build_method(name, sort_parameters([name], assignments)[name], seed))
