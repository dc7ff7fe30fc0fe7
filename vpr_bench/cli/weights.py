"""``vpr-bench weights``: which pre-trained weights there are, getting them, checking them."""

from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import complain, say, show, write
from vpr_bench.cli.listing import TextFormatOption

if TYPE_CHECKING:
    from vpr_bench.weights.card import WeightsCard

app = typer.Typer(help="Find, fetch and check the pre-trained weights of methods.", no_args_is_help=True)

LIST_EXAMPLES = """[bold]Examples[/bold]

vpr-bench weights list

vpr-bench weights list --format json
"""
FETCH_EXAMPLES = """[bold]Example[/bold]

vpr-bench weights fetch resnet18-imagenet
"""

NameArgument = Annotated[str, typer.Argument(help="Weights id.")]


@app.command("list", epilog=LIST_EXAMPLES)
def list_(form: TextFormatOption = "table") -> None:
    """List the weights that are known, what they were trained on, their licences, and where they are."""
    from vpr_bench.weights.card import WEIGHTS

    cards = WEIGHTS.load_all()
    if form == "json":
        import json

        write(json.dumps([_facts(card) for card in cards.values()], indent=2, ensure_ascii=False))
        return
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False)
    for column in ("id", "architecture", "trained on", "licence", "where"):
        table.add_column(column, overflow="fold")
    for card in cards.values():
        where = str(_facts(card)["path"] or _not_here(card))
        table.add_row(*map(Text, (card.id, card.architecture, card.training_set, card.licence, where)))
    show(table)


@app.command("fetch", epilog=FETCH_EXAMPLES)
def fetch(name: NameArgument) -> None:
    """Download weights and verify them; an interrupted download is continued."""
    from vpr_bench.weights.card import find_weights_card
    from vpr_bench.weights.fetch import fetch_weights

    card = find_weights_card(name)
    say(f"{card.id}: {card.licence}")
    with progress_bars():
        write(str(fetch_weights(card)))


@app.command("path")
def path(
    name: Annotated[str | None, typer.Argument(help="Weights id. Default: the folder of weights.")] = None,
) -> None:
    """Print the folder of weights, or the file of some."""
    from vpr_bench.weights.place import find_weights, weights_root

    write(str(find_weights(name) if name else weights_root()))


@app.command("verify")
def verify(
    name: Annotated[str | None, typer.Argument(help="Weights id. Default: all that are here.")] = None,
    accept: Annotated[
        bool, typer.Option("--accept", help="Take this file for the right one where no digest is published.")
    ] = False,
) -> None:
    """Check that weights have the digest that is published, or else the one that was met here first, and can be read.

    Exit code 1: another file than the one met first; 3: missing or damaged.
    """
    from vpr_bench.errors import UsageError, VprBenchError
    from vpr_bench.weights.card import WEIGHTS, find_weights_card
    from vpr_bench.weights.checkpoint import load_checkpoint
    from vpr_bench.weights.digest import weights_digest
    from vpr_bench.weights.place import find_file

    if accept and name is None:
        raise UsageError("Say which weights to accept.")
    cards = [find_weights_card(name)] if name else list(WEIGHTS.load_all().values())
    code = 0
    for card in cards:
        if name is None and not _facts(card)["path"]:
            write(f"{card.id}: {_not_here(card)}")
            continue
        try:
            digest = weights_digest(card, afresh=True, accept=accept)
            load_checkpoint(find_file(card))
        except VprBenchError as error:
            complain(str(error))
            code = max(code, error.exit_code)
        else:
            write(f"{card.id}: {digest}, as it should be")
    if code:
        raise typer.Exit(code)


def _facts(card: "WeightsCard") -> dict[str, object]:
    """Return the card with the path of the file, None if it is not here."""
    from vpr_bench.weights.place import MissingWeightsError, find_file

    try:
        here: str | None = str(find_file(card))
    except MissingWeightsError:
        here = None
    return {**card.model_dump(mode="json"), "path": here}


def _not_here(card: "WeightsCard") -> str:
    return f"not here: vpr-bench weights fetch {card.id}" if card.url else f"not here: {card.obtain}"
