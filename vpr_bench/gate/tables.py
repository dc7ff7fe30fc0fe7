"""A judgement for people, at a terminal."""

from rich.console import Group, RenderableType
from rich.text import Text

from vpr_bench.gate.verdict import Judgement, Outcome, Verdict
from vpr_bench.gate.words import HEAD, by_protocol, details, legend, moved, reasons, skipped, table_rows
from vpr_bench.report.grid import Grid

_STYLES: dict[Outcome, str] = {
    "pass": "green",
    "fail": "bold red",
    "missing": "red",
    "error": "bold red",
    "new": "cyan",
}


def render(judgement: Judgement) -> RenderableType:
    """Lay out one table per protocol, what is to be said of each cell below it, and how many came to what."""
    parts: list[RenderableType] = []
    for protocol, verdicts in by_protocol(judgement).items():
        parts.append(Grid(protocol, HEAD, [row for verdict in verdicts for row in table_rows(verdict)]).rich())
        parts += [_details(verdict) for verdict in details(judgement, protocol)]
    parts += [Text(line, style="dim") for line in legend(judgement)]
    parts += [Text(line) for line in skipped(judgement)]
    style = "bold green" if judgement.exit_code == 0 else "bold red"
    return Group(*parts, Text(judgement.summary(), style=style))


def _details(verdict: Verdict) -> RenderableType:
    text = Text(table_rows(verdict)[0][0], style="bold")
    text.append(f"  {verdict.outcome}\n", style=_STYLES[verdict.outcome])
    for line in reasons(verdict):
        text.append(f"  {line}\n", style="not bold")
    for title, queries in moved(verdict):
        text.append(f"  {title}: ", style="not bold")
        text.append(f"{queries}\n", style="not bold dim")
    return text
