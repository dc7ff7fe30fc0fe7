"""A judgement as Markdown: the summary of a step of GitHub Actions, or a comment."""

from html import escape

from vpr_bench.errors import one_line
from vpr_bench.gate.verdict import Judgement, Verdict
from vpr_bench.gate.words import HEAD, by_protocol, details, legend, moved, reasons, skipped, table_rows
from vpr_bench.report.foreign import plain
from vpr_bench.report.grid import Grid


def to_markdown(judgement: Judgement) -> str:
    """Write the verdict, a table per protocol, and what moved, folded away.

    Parameters
    ----------
    judgement : Judgement
        What was found; names in it are escaped.
    """
    word = "passed" if judgement.exit_code == 0 else "failed"
    parts = [f"**Accuracy gate {word}**: {plain(judgement.summary())}"]
    for protocol, verdicts in by_protocol(judgement).items():
        rows = [row for verdict in verdicts for row in table_rows(verdict)]
        parts += [f"### {plain(protocol)}", Grid("", HEAD, rows).markdown()]
        parts += [_details(verdict) for verdict in details(judgement, protocol)]
    parts += [plain(line) for line in [*legend(judgement), *skipped(judgement)]]
    return "\n\n".join(parts)


def _details(verdict: Verdict) -> str:
    lines = [f"- {plain(line)}" for line in reasons(verdict)]
    lines += [f"- {plain(title)}: {plain(queries)}" for title, queries in moved(verdict)]
    head = f"{escape(one_line(verdict.label))}: {verdict.outcome}"
    opened = " open" if verdict.exit_code else ""
    return f"<details{opened}><summary>{head}</summary>\n\n" + "\n".join(lines) + "\n\n</details>"
