"""``vpr-bench data``: where images are, getting them, checking them."""

from pathlib import Path
from typing import Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import complain, say, write

app = typer.Typer(help="Find, fetch and verify the images of datasets.", no_args_is_help=True)

NameArgument = Annotated[str, typer.Argument(help="Dataset id.")]


@app.command("path")
def path(dataset: Annotated[str | None, typer.Argument(help="Dataset id. Default: the data root.")] = None) -> None:
    """Print the data root, or the folder that holds a dataset's real images."""
    from vpr_bench.dataset.card import find_card
    from vpr_bench.dataset.editions import resolve_edition
    from vpr_bench.dataset.folders import data_root

    write(str(resolve_edition(find_card(dataset), "real")[1] if dataset else data_root()))


@app.command("fetch")
def fetch(dataset: NameArgument) -> None:
    """Download a dataset's real images and verify them; an interrupted download is continued."""
    from vpr_bench.dataset.acquire import fetch_images
    from vpr_bench.dataset.card import find_card

    card = find_card(dataset)
    say(f"{card.id}: {card.licence}")
    with progress_bars():
        write(str(fetch_images(card)))


@app.command("verify")
def verify(
    dataset: NameArgument,
    folder: Annotated[Path | None, typer.Option(help="Holds the traverses. Default: under the data root.")] = None,
) -> None:
    """Check that a dataset's real images are complete, decode, and are the copy that the card knows."""
    from vpr_bench.dataset.acquire import verify_images
    from vpr_bench.dataset.card import find_card
    from vpr_bench.dataset.editions import resolve_edition

    card = find_card(dataset)
    folder = folder or resolve_edition(card, "real")[1]
    with progress_bars():
        faults = verify_images(card, folder)
    for fault in faults:
        complain(str(fault))
    if faults:
        raise typer.Exit(max(fault.exit_code for fault in faults))
    write(f"{card.id}: {sum(one.images for one in card.traverses)} images in {folder} are the ones the card knows")
