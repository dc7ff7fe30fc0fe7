"""``vpr-bench data preview``: a picture in which a person sees whether the ground truth is right."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import say, write
from vpr_bench.cli.options import EditionOption

if TYPE_CHECKING:
    from vpr_bench.types.protocol import Protocol

PREVIEW_EXAMPLES = """[bold]Examples[/bold]

vpr-bench data preview gardens

vpr-bench data preview path/to/my/images --radius 10 --count 16 --output walk.png
"""

MOST = 200
"""Queries on one sheet; a picture of more is larger than most viewers open."""


def preview(
    dataset: Annotated[
        str, typer.Argument(help="Dataset, dataset:edition, protocol id, or a folder of your own.", metavar="NAME|PATH")
    ],
    protocol: Annotated[str | None, typer.Option(help="references-queries. Default: the first.")] = None,
    edition: EditionOption = "auto",
    radius: Annotated[float | None, typer.Option(help="Instead of the protocol's own.", metavar="R")] = None,
    count: Annotated[int, typer.Option(min=1, max=MOST, help="How many queries to show.", metavar="N")] = 8,
    seed: Annotated[int, typer.Option(min=0, help="Another one shows other queries.")] = 0,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Default: dataset_references-queries.png, here.", metavar="FILE.png"),
    ] = None,
) -> None:
    """Draw queries with their true matches, to see whether the ground truth is right; print the picture's path."""
    from vpr_bench.dataset.load import load_case
    from vpr_bench.report.contact_sheet import draw_contact_sheet
    from vpr_bench.report.figure import check_picture

    if output is not None:
        check_picture(output, ["png"])
    with progress_bars():
        case = load_case(dataset, protocol, edition, radius)
        if case.protocol.simulated:
            say(f"{case.protocol}: SIMULATED images, rendered by vpr-bench")
        file = output or Path(file_name(case.protocol))
        write(str(draw_contact_sheet(case, file, count, seed)))


def file_name(protocol: "Protocol") -> str:
    """Return what a protocol's picture is called: editions other than the real one are named, too."""
    return f"{protocol.source.replace(':', '-')}_{protocol.pairing:.180}.png"
