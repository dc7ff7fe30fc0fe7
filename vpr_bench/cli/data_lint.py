"""``vpr-bench data lint``: what is wrong with the images and the ground truth of a dataset."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import show, write
from vpr_bench.cli.listing import TextFormatOption

if TYPE_CHECKING:
    from vpr_bench.dataset.lint import Finding, Inspection
    from vpr_bench.dataset.source import Source
    from vpr_bench.types.protocol import Protocol

LINT_EXAMPLES = """[bold]Examples[/bold]

vpr-bench data lint gardens

vpr-bench data lint ./my-walks --format json
"""

_STYLES = {"error": "bold red", "warning": "yellow", "note": "dim"}


def lint(
    dataset: Annotated[str, typer.Argument(help="Dataset id, dataset:edition, or a folder of your own.")],
    protocol: Annotated[
        list[str] | None,
        typer.Option("--protocol", help="references-queries; repeat for more. Default: all of the dataset."),
    ] = None,
    form: TextFormatOption = "table",
) -> None:
    """Find damaged, doubled, dark and frozen images, wrong places and holes in the ground truth.

    Exits with 0 if there is nothing worse than a note, 1 if there is, and 3 if nothing can be loaded.
    """
    from vpr_bench.dataset.lint import inspect_source

    source, protocols = _asked(dataset, protocol or [])
    with progress_bars():
        inspection = inspect_source(source, protocols)
    if form == "json":
        _write_json(source.name, inspection)
    else:
        _show(inspection.findings)
        write(_summary(source.name, inspection))
    if inspection.images == 0:
        raise typer.Exit(3)
    if any(one.severity != "note" for one in inspection.findings):
        raise typer.Exit(1)


def _asked(dataset: str, pairings: Sequence[str]) -> "tuple[Source, list[Protocol] | None]":
    """Look up a dataset, and the protocols that are named; None for all that there are."""
    from vpr_bench.dataset.request import Request
    from vpr_bench.dataset.source import Source

    requests = [Request.parse(dataset, pairing) for pairing in pairings] or [Request.parse(dataset)]
    source = Source.find(requests[0])
    if requests[0].pairing is None:
        return source, None
    named = [(one, source.card.protocol(one.pairing, source.edition)) for one in requests]
    return source, [replace(found, unmatched=one.unmatched or found.unmatched) for one, found in named]


def _write_json(dataset: str, inspection: "Inspection") -> None:
    import json

    content = {
        "dataset": dataset,
        "protocols": [str(protocol) for protocol in inspection.protocols],
        "images": inspection.images,
        "findings": [finding.as_dict() for finding in inspection.findings],
    }
    write(json.dumps(content, indent=2, ensure_ascii=False))


def _show(findings: "Sequence[Finding]") -> None:
    from rich.table import Table
    from rich.text import Text

    from vpr_bench.dataset.lint import SEVERITIES

    for severity in SEVERITIES:
        rows = [finding for finding in findings if finding.severity == severity]
        if not rows:
            continue
        title = Text(f"{severity.capitalize()}s", style=_STYLES[severity])
        table = Table(title=title, title_justify="left", box=None, pad_edge=False)
        for column in ("check", "where", "what"):
            table.add_column(column, overflow="fold")
        for finding in rows:  # as texts: a file may be called [red]
            table.add_row(Text(finding.check), Text(finding.where), Text(finding.message))
        show(table)


def _summary(name: str, inspection: "Inspection") -> str:
    """Say in one line what was looked at, and how much was found."""
    from vpr_bench.dataset.lint import SEVERITIES
    from vpr_bench.dataset.lint.finding import counted

    looked = (
        f"{counted(inspection.images, 'image')} of {counted(inspection.traverses, 'traverse')}, "
        f"{counted(len(inspection.protocols), 'protocol')}"
    )
    counts = {kind: sum(one.severity == kind for one in inspection.findings) for kind in SEVERITIES}
    found = ", ".join(counted(count, kind) for kind, count in counts.items() if count)
    return f"{name}: {found or 'nothing wrong'} in {looked}"
