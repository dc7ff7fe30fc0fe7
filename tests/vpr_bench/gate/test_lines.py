import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.gate.lines import PER_LINE, from_lines, to_lines

VALUES = st.lists(st.sampled_from(["-", "x", "0", "17", "199"]), max_size=3 * PER_LINE)


@given(VALUES)
def test_what_is_written_is_read(values):
    assert from_lines(to_lines(values), len(values)) == values


@given(VALUES.filter(bool), st.data())
def test_one_value_moves_one_line(values, data):
    place = data.draw(st.integers(0, len(values) - 1))
    other = [*values[:place], values[place] + "1", *values[place + 1 :]]
    moved = [old != new for old, new in zip(to_lines(values), to_lines(other), strict=True)]
    assert sum(moved) == 1
    assert moved[place // PER_LINE]


@pytest.mark.parametrize(
    "lines",
    [["0: 1 2"], ["0: 1 2 3 4"], ["1: 1 2 3"], ["0:1 2 3"], ["0: 1  2"], ["0: 1 2", "2: 3"], [], ["1 2 3"]],
    ids=str,
)
def test_anything_else_is_refused(lines):
    with pytest.raises(ValueError, match=r"values|each line"):
        from_lines(lines, 3)
