"""A table whose numbers are never cut: where a window is too narrow for them, its lines are wider than the window."""

from collections.abc import Iterable
from dataclasses import dataclass

from rich.cells import cell_len
from rich.console import Console, ConsoleOptions, RenderResult
from rich.table import Table

_NAMES = 18  # columns of the window that names have at least; longer ones are folded
_BETWEEN = 2  # padding, and the space where a line could stand


@dataclass(frozen=True)
class Unbroken:
    """A table of names, folded where there is little room, and of numbers, which are not.

    Attributes
    ----------
    table : Table
        Its first column holds the names.
    least : int
        Columns of the window that it needs at least.
    """

    table: Table
    least: int

    @classmethod
    def of(cls, table: Table, numbers: Iterable[Iterable[str]]) -> "Unbroken":
        """Wrap a table; ``numbers`` are the texts of each further column, its head among them."""
        widths = [max(cell_len(line) for text in (*column, "") for line in text.split("\n")) for column in numbers]
        return cls(table, _NAMES + sum(width + _BETWEEN for width in widths))

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """Lay the table out, wider than the window if it must be."""
        yield from console.render(self.table, options.update(max_width=max(options.max_width, self.least)))
