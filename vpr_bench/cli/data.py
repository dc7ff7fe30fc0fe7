"""``vpr-bench data``: where images are, getting them, checking them."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import complain, say, write
from vpr_bench.cli.data_init import INIT_EXAMPLES, init
from vpr_bench.cli.data_lint import LINT_EXAMPLES, lint
from vpr_bench.cli.data_preview import PREVIEW_EXAMPLES, preview

if TYPE_CHECKING:
    from vpr_bench.dataset.source import Source

app = typer.Typer(help="Find, fetch, describe and check the images of datasets.", no_args_is_help=True)
app.command("init", epilog=INIT_EXAMPLES)(init)
app.command("preview", epilog=PREVIEW_EXAMPLES)(preview)
app.command("lint", epilog=LINT_EXAMPLES)(lint)

NameArgument = Annotated[str, typer.Argument(help="Dataset id, dataset:edition, or a folder of your own.")]


@app.command("path")
def path(
    dataset: Annotated[str | None, typer.Argument(help="Dataset id. Default: the data root.")] = None,
) -> None:
    """Print the data root, or the folder that holds a dataset's real images."""
    from vpr_bench.dataset.folders import data_root

    write(str(_real(dataset).folder if dataset else data_root()))


@app.command("fetch")
def fetch(dataset: Annotated[str, typer.Argument(help="Dataset id.")]) -> None:
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
    accept: Annotated[
        bool, typer.Option("--accept", help="Take these images for the right ones where the card knows none.")
    ] = False,
) -> None:
    """Check that a dataset's real images are complete, decode, and are the copy that is known."""
    from vpr_bench.dataset.acquire import accept_images, verify_images

    source = _real(dataset)
    folder = folder or source.folder
    with progress_bars():
        if accept and source.foreign:
            accept_images(source.card, folder, source.name)
        faults = verify_images(source.card, folder, source.name if source.foreign else None)
    for fault in faults:
        complain(str(fault))
    if faults:
        raise typer.Exit(max(fault.exit_code for fault in faults))
    write(f"{source.name}: all images in {folder} decode and are the ones that are known")


def _real(dataset: str) -> "Source":
    """Look up real images: those that are named, or else the dataset's own."""
    from vpr_bench.dataset.request import Request
    from vpr_bench.dataset.source import Source

    request = Request.parse(dataset)
    return Source.find(request if request.edition != "auto" else Request.parse(dataset, edition="real"))
