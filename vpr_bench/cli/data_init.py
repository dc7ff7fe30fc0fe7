"""``vpr-bench data init``: describe a folder of one's own images, and show what was understood."""

import json
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import say, show, write
from vpr_bench.cli.listing import TextFormatOption
from vpr_bench.errors import DataError, UsageError

if TYPE_CHECKING:
    from rich.table import Table

    from vpr_bench.dataset.describe_own import Description
    from vpr_bench.dataset.load import Case

INIT_EXAMPLES = """[bold]Examples[/bold]

vpr-bench data init path/to/my/images

vpr-bench data init ./walk --radius 10 --licence "CC BY 4.0" --force
"""

PREVIEW_FILE = "vpr-bench-preview.png"


def init(
    path: Annotated[Path, typer.Argument(help="Folder of your own images.")],
    layout: Annotated[str | None, typer.Option(help="Read it as this layout. Default: the best that fits.")] = None,
    dataset_id: Annotated[str | None, typer.Option("--id", help="Default: made from the folder's name.")] = None,
    name: Annotated[str | None, typer.Option(help="What people call it.", metavar="TEXT")] = None,
    radius: Annotated[
        float | None, typer.Option(help="How far apart the same place may be, in frames or metres.", metavar="R")
    ] = None,
    licence: Annotated[str | None, typer.Option(help="Of the images.", metavar="TEXT")] = None,
    citation: Annotated[str | None, typer.Option(help="What to cite.", metavar="TEXT")] = None,
    force: Annotated[bool, typer.Option("--force", help="Write a card anew that is there already.")] = False,
    form: TextFormatOption = "table",
) -> None:
    """Look at a folder of images, and write what is found into a card beside them: vpr-bench.toml.

    A picture, vpr-bench-preview.png, shows queries with their true matches: look whether they are right.
    """
    from vpr_bench.dataset.content import traverse_digest
    from vpr_bench.dataset.describe_own import CARD_FILE, describe_own
    from vpr_bench.dataset.load import load_from, load_traverse
    from vpr_bench.files.atomic import write_bytes
    from vpr_bench.report.contact_sheet import draw_contact_sheet

    folder = _folder(path)
    if not force and (folder / CARD_FILE).exists():
        raise UsageError(f"{folder / CARD_FILE} is there already: edit it, or write it anew with --force.")
    found = describe_own(
        folder, layout, dataset_id=dataset_id, radius=radius, name=name, licence=licence, citation=citation
    )
    card = found.card
    with progress_bars():
        traverses = {one.name: load_traverse(card, one, folder).traverse for one in card.traverses}
        cases = [load_from(card, protocol, folder) for protocol in card.listed_protocols()]
        text = found.with_digests(lambda one: traverse_digest(traverses[one]))
        # Drawn before the card is written: where an image is damaged there is neither.
        picture = draw_contact_sheet(cases[0], _preview_file(folder, cases))
        write_bytes(found.file, text.encode())
    counts = {one: len(traverse) for one, traverse in traverses.items()}
    facts = _facts(found, counts, cases, picture, _next(path))
    if form == "json":
        write(json.dumps(facts, indent=2, ensure_ascii=False))
    else:
        _show(facts)
    if not cases[0].ground_truth.has_match.any():
        say("warning: no query has a match: look at the picture, and give a larger --radius if the places are right")


def _folder(path: Path) -> Path:
    folder = path.expanduser()
    if folder.is_file():
        raise DataError(f"{path} is a file: name the folder that holds the images, unpacked.")
    if not folder.is_dir():
        raise DataError(f"There is no folder {path}. Name the one that holds your images.")
    return folder.resolve()


def _preview_file(folder: Path, cases: "list[Case]") -> Path:
    """Return where the picture goes; hidden where it would lie among images and pass for one of them."""
    sources = [source for case in cases for traverse in (case.references, case.queries) for source in traverse.sources]
    among = any(isinstance(source, Path) and source.parent == folder for source in sources)
    return folder / (f".{PREVIEW_FILE}" if among else PREVIEW_FILE)


def _next(path: Path) -> str:
    """Return the command to type next, with the folder named so that it cannot be taken for a dataset."""
    from vpr_bench.dataset.request import own_folder

    text = str(path)
    return shlex.join(["vpr-bench", "run", "--method", "hog", "--dataset", text if own_folder(text) else f"./{text}"])


def _facts(
    found: "Description", counts: dict[str, int], cases: "list[Case]", picture: Path, following: str
) -> dict[str, Any]:
    import numpy as np

    card = found.card
    protocols = []
    for case in cases:
        per_query = np.diff(case.ground_truth.offsets)
        protocols.append(
            {
                "id": str(case.protocol),
                "references": len(case.references),
                "queries": len(case.queries),
                "with_match": int((per_query > 0).sum()),
                "matches_per_query": float(per_query.mean()) if len(per_query) else 0.0,
            }
        )
    return {
        "dataset": card.id,
        "layout": card.loader.layout,
        "found": card.summary,
        "unit": card.unit,
        "traverses": [{"name": one.name, "folder": one.path, "images": counts[one.name]} for one in card.traverses],
        "protocols": protocols,
        "other_layouts": found.others,
        "card": str(found.file),
        "preview": str(picture),
        "next": following,
    }


def _show(facts: dict[str, Any]) -> None:
    from rich.text import Text

    show(Text.assemble((facts["dataset"], "bold"), f"  {facts['found']} (layout {facts['layout']})\n"))
    show(_table(["traverse", "folder", "images"], [list(one.values()) for one in facts["traverses"]]))
    rows = [
        [one["id"], f"{one['with_match']:,} of {one['queries']:,}", f"{one['matches_per_query']:.1f}"]
        for one in facts["protocols"]
    ]
    rows[0][0] += "  (default)"
    show(_table(["protocol", "queries with a match", "matches per query"], rows))
    for layout, found in facts["other_layouts"].items():
        show(Text(f"It could also be read with --layout {layout}: {found}"))
    # As it is, so that paths and the command can be copied from a narrow window too.
    write(f"card     {facts['card']}  (edit the radius and the protocols here)")
    write(f"preview  {facts['preview']}  (look whether the matches are right)")
    write(f"next     {facts['next']}")


def _table(titles: list[str], rows: list[list[Any]]) -> "Table":
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False, header_style="bold")
    for title in titles:
        table.add_column(
            title, overflow="fold", justify="left" if title in ("traverse", "folder", "protocol") else "right"
        )
    for row in rows:
        table.add_row(*(Text(f"{value:,}" if isinstance(value, int) else str(value)) for value in row))
    table.add_row()
    return table
