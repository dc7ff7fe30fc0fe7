import io

import pytest
from rich.console import Console
from rich.table import Table

from vpr_bench.report.grid import Grid
from vpr_bench.report.unbroken import Unbroken

ROWS = [("a_method_with_a_long_name(and=parameters)", "0.905", "0.884", "0.976")]
HEAD = ("method", "recall@1", "pr_auc", "matched")


def printed(renderable, width):
    file = io.StringIO()
    Console(file=file, width=width).print(renderable, crop=False)
    return file.getvalue()


@pytest.mark.parametrize("width", [8, 20, 30, 50, 200])
def test_no_digit_is_lost_however_narrow_the_window(width):
    text = printed(Grid("title", HEAD, ROWS).rich(), width)
    assert all(cell in text for cell in (*ROWS[0][1:], *HEAD[1:]))


def test_names_are_folded_before_the_table_is_wider_than_the_window():
    lines = printed(Grid("title", HEAD, ROWS).rich(), 50).splitlines()
    assert max(map(len, lines)) <= 50
    assert "a_method_with_a_long_name" not in "".join(lines)


def test_the_widest_line_of_a_cell_counts():
    assert Unbroken.of(Table(), [["head\nof two", "1"], ["x"]]).least == 18 + 8 + 3
