"""``vpr-bench bench``: how fast the harness itself is."""

import json
from typing import Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import write

app = typer.Typer(help="Measure the harness itself: time and memory.", no_args_is_help=True)


@app.callback()
def _group() -> None:
    pass


@app.command("pairs")
def pairs(
    queries: Annotated[int, typer.Option(min=2, help="Queries, and as many references.")] = 27_592,
    dimensions: Annotated[int, typer.Option(min=1, help="Numbers per descriptor.")] = 256,
    radius: Annotated[int, typer.Option(min=0, help="In frames.")] = 10,
    seed: Annotated[int, typer.Option(min=0, help="Of the descriptors.")] = 0,
) -> None:
    """Measure pr_auc_pairs, which looks at every query-reference pair, and print the facts as JSON."""
    from vpr_bench.bench.pairs import run

    with progress_bars():
        write(json.dumps(run(queries, dimensions, radius, seed), indent=2))
