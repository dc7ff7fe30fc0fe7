"""A small table of text, written for people or as Markdown."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from rich.box import SIMPLE_HEAD
from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text


@dataclass(frozen=True)
class Grid:
    """Cells below a head; the first column holds names, the others numbers.

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
        return Group(Text(self.title, style="bold"), table, note)

    def markdown(self) -> str:
        """Write the grid as a Markdown table below its title."""
        return "\n\n".join(part for part in (self.title, markdown_table(self.head, self.rows), self.note) if part)


def markdown_table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    r"""Write a Markdown table; line breaks in a cell become spaces.

    Examples
    --------
    >>> print(markdown_table(["name", "value"], [["a|b", "1"]]))
    | name | value |
    | --- | --- |
    | a\|b | 1 |
    """
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(_cell(cell) for cell in line) + " |" for line in lines)


def _cell(text: str) -> str:
    return " ".join(text.replace("|", "\\|").splitlines())
