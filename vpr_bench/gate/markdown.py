"""A judgement as Markdown: the summary of a step of GitHub Actions, or a comment."""

from vpr_bench.gate.verdict import Judgement, Verdict
from vpr_bench.gate.words import HEAD, by_protocol, details, moved, reasons, table_rows
from vpr_bench.report.grid import markdown_table

_PLAIN = frozenset(" .,+-=/→≥×…–'%?;()")


def to_markdown(judgement: Judgement) -> str:
    """Write the verdict, a table per protocol, and what moved, folded away.

    Parameters
    ----------
    judgement : Judgement
        What was found; names in it are escaped.
    """
    word = "passed" if judgement.exit_code == 0 else "failed"
    parts = [f"**Accuracy gate {word}**: {escape(judgement.summary())}"]
    for protocol, verdicts in by_protocol(judgement).items():
        rows = [[escape(cell) for cell in row] for verdict in verdicts for row in table_rows(verdict)]
        parts += [f"### {escape(protocol)}", markdown_table(HEAD, rows)]
        parts += [_details(verdict) for verdict in details(judgement, protocol)]
    return "\n\n".join(parts)


def escape(text: str) -> str:
    """Write text so that nothing in it is taken for Markdown or HTML, on one line.

    Examples
    --------
    >>> escape("day_left <b>*x*|")
    'day_left &#60;b&#62;&#42;x&#42;&#124;'
    """
    marks = " ".join(text.split())
    return "".join(
        mark if mark.isalnum() or mark in _PLAIN or _harmless(marks, place) else f"&#{ord(mark)};"
        for place, mark in enumerate(marks)
    )


def _harmless(text: str, place: int) -> bool:
    """Tell whether this is a mark inside a word, or a colon behind one: they emphasise nothing and link nowhere."""
    before, mark, after = text[max(place - 1, 0) : place], text[place], text[place + 1 : place + 2]
    return (mark in "_@" and before.isalnum() and after.isalnum()) or (mark == ":" and after in ("", " "))


def _details(verdict: Verdict) -> str:
    lines = [f"- {escape(line)}" for line in reasons(verdict)]
    lines += [f"- {escape(title)}: {escape(queries)}" for title, queries in moved(verdict)]
    head = f"{escape(verdict.label)}: {verdict.outcome}"
    opened = " open" if verdict.exit_code else ""
    return f"<details{opened}><summary>{head}</summary>\n\n" + "\n".join(lines) + "\n\n</details>"
