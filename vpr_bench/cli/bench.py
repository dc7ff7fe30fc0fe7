"""``vpr-bench bench``: how fast the harness itself is, and how fast methods are beside each other."""

import json
from typing import Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.bench_methods import METHODS_EXAMPLES, methods
from vpr_bench.cli.console import write
from vpr_bench.cli.parameters import split_assignment

app = typer.Typer(
    help="Measure methods beside each other, and the harness itself: time and memory.", no_args_is_help=True
)


@app.callback()
def _group() -> None:
    pass


app.command("methods", epilog=METHODS_EXAMPLES)(methods)


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


@app.command("bootstrap")
def bootstrap(
    queries: Annotated[int, typer.Option(min=1, help="How many are drawn from.")] = 27_592,
    resamples: Annotated[int, typer.Option(min=1, help="How often they are drawn.")] = 2000,
    seed: Annotated[int, typer.Option(min=0, help="Of the answers and the draws.")] = 0,
) -> None:
    """Measure the intervals of all metrics, on one core, and print the facts as JSON."""
    from vpr_bench.bench.bootstrap import run

    with progress_bars():
        write(json.dumps(run(queries, resamples, seed), indent=2))


@app.command("streaming")
def streaming(
    dataset: Annotated[str, typer.Option(help="Whose images are repeated.")],
    method: Annotated[str, typer.Option("--method", "-m", help="Name of the method.")],
    param: Annotated[list[str] | None, typer.Option("--param", "-p", help="Parameter name=value.")] = None,
    frames: Annotated[int, typer.Option(min=2, help="Length of each traverse.")] = 27_592,
    limit: Annotated[int, typer.Option(min=1, help="Queries that are asked.")] = 200,
) -> None:
    """Measure memory and time of a whole run on long traverses, and print the facts as JSON."""
    from vpr_bench.bench.streaming import run

    parameters = dict(map(split_assignment, param or []))
    with progress_bars():
        write(json.dumps(run(dataset, method, parameters, frames, limit), indent=2))


@app.command("envs")
def envs(
    dataset: Annotated[str, typer.Option(help="Whose queries are asked.")] = "gardens:simulated",
    num_envs: Annotated[int, typer.Option(min=1, help="Queries per step of the vector environment.")] = 32,
    episodes: Annotated[int, typer.Option(min=1, help="How often all queries are asked.")] = 5,
) -> None:
    """Measure the Gymnasium environments: making one, and a step without its images; print the facts as JSON."""
    from vpr_bench.bench.envs import run

    with progress_bars():
        write(json.dumps(run(dataset, num_envs, episodes), indent=2))
