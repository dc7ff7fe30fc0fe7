"""A small table of text, written for people or as Markdown."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from rich.box import SIMPLE_HEAD
from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from vpr_bench.report.foreign import plain
from vpr_bench.report.unbroken import Unbroken

_BARE = re.compile(r"(?<!\\)((?:\\\\)*)\|")  # not escaped: an even number of backslashes before it


@dataclass(frozen=True)
class Grid:
    """Cells below a head; the first column holds names, the others numbers. All of it is text, and nothing markup.

    Attributes
    ----------
    title : str
        Says what the numbers are of.
    head : sequence of str
        One per column.
    rows : sequence of sequences of str
        As long as the head.
    note : str
        What stands below; may be empty.
    """

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    note: str = ""

    def rich(self) -> RenderableType:
        """Lay the grid out for a terminal."""
        table = Table(box=SIMPLE_HEAD, show_edge=False, padding=(0, 1, 0, 0), pad_edge=False)
        for number, name in enumerate(self.head):
            table.add_column(
                Text(name), justify="right" if number else "left", overflow="fold", no_wrap=number > 0, min_width=4
            )
        for row in self.rows:
            table.add_row(*map(Text, row))
        # Not the table's title and caption, which would be as narrow as the table.
        note = Text(f"{self.note}\n" if self.note else "", style="italic dim")
        columns = list(zip(self.head, *self.rows, strict=True))
        return Group(Text(self.title, style="bold"), Unbroken.of(table, columns[1:]), note)

    def markdown(self) -> str:
        """Write the grid as a Markdown table below its title; marks in the text are shown as they are."""
        table = markdown_table(_texts(self.head), map(_texts, self.rows))
        note = "\n".join(_texts(self.note.splitlines()))
        return "\n\n".join(part for part in (*_texts([self.title]), table, note) if part)


def markdown_table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    r"""Write a Markdown table of cells that are Markdown; line breaks in them become spaces.

    Foreign text has to be made :func:`~vpr_bench.report.foreign.plain` first.

    Examples
    --------
    >>> print(markdown_table(["name", "value"], [["`a|b`", "*1*"]]))
    | name | value |
    | --- | --- |
    | `a\|b` | *1* |
    """
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(_cell(cell) for cell in line) + " |" for line in lines)


def _cell(text: str) -> str:
    return " ".join(_BARE.sub(r"\1\\|", text).splitlines())


def _texts(texts: Sequence[str]) -> list[str]:
    return [plain(text) if text else "" for text in texts]
