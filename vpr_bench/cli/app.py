"""All commands of ``vpr-bench``."""

from typing import Annotated

import typer

from vpr_bench.cli.bench import app as bench
from vpr_bench.cli.check import app as check
from vpr_bench.cli.clusters import CLUSTERS_EXAMPLES, clusters
from vpr_bench.cli.compare import COMPARE_EXAMPLES, compare
from vpr_bench.cli.data import app as data
from vpr_bench.cli.doctor import doctor
from vpr_bench.cli.fit import EXTEND_EXAMPLES, FIT_EXAMPLES, extend, fit
from vpr_bench.cli.gate import GATE_EXAMPLES, gate
from vpr_bench.cli.leaderboard import LEADERBOARD_EXAMPLES, leaderboard
from vpr_bench.cli.listing import INFO_EXAMPLES, LIST_EXAMPLES, info, list_
from vpr_bench.cli.locate import LOCATE_EXAMPLES, locate
from vpr_bench.cli.reproduce import REPRODUCE_EXAMPLES, reproduce
from vpr_bench.cli.run import EXAMPLES, run
from vpr_bench.cli.stored import SCORE_EXAMPLES, SHOW_EXAMPLES, score, show
from vpr_bench.cli.weights import app as weights

app = typer.Typer(
    name="vpr-bench",
    help="Compare Visual Place Recognition methods with numbers that can be repeated.",
    epilog="Start with: vpr-bench run --method twostage --dataset gardens",
    no_args_is_help=True,
    add_completion=True,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(asked: bool) -> None:
    if asked:
        from vpr_bench import __version__

        typer.echo(f"vpr-bench {__version__}")
        raise typer.Exit


@app.callback()
def _main(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version and exit.", callback=_version, is_eager=True)
    ] = False,
) -> None:
    pass


app.command("run", epilog=EXAMPLES)(run)
app.command("fit", epilog=FIT_EXAMPLES)(fit)
app.command("locate", epilog=LOCATE_EXAMPLES)(locate)
app.command("extend", epilog=EXTEND_EXAMPLES)(extend)
app.command("list", epilog=LIST_EXAMPLES)(list_)
app.command("info", epilog=INFO_EXAMPLES)(info)
app.command("show", epilog=SHOW_EXAMPLES)(show)
app.command("score", epilog=SCORE_EXAMPLES)(score)
app.command("reproduce", epilog=REPRODUCE_EXAMPLES)(reproduce)
app.command("compare", epilog=COMPARE_EXAMPLES)(compare)
app.command("leaderboard", epilog=LEADERBOARD_EXAMPLES)(leaderboard)
app.command("clusters", epilog=CLUSTERS_EXAMPLES)(clusters)
app.command("gate", epilog=GATE_EXAMPLES)(gate)
app.command("doctor")(doctor)
app.add_typer(check, name="check")
app.add_typer(data, name="data")
app.add_typer(weights, name="weights")
app.add_typer(bench, name="bench")
