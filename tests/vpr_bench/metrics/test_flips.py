import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.metrics.answers import NEVER
from vpr_bench.metrics.flips import flips


def test_both_ways_by_the_number_of_the_query(make):
    first = dataclasses.replace(make([1, 1, 0, 0], [4, 3, 2, 1]), queries=np.array([9, 5, 7, 2]))
    second = dataclasses.replace(make([1, 0, 1, 1], [4, 3, 2, 1]), queries=first.queries)
    found = flips(first, second)
    assert found.lost.tolist() == [5]
    assert found.gained.tolist() == [2, 7]  # ascending
    assert found.lost.dtype == found.gained.dtype == np.int64


@given(data=st.data())
def test_swapping_the_runs_swaps_the_ways(data, any_answers):
    first = data.draw(any_answers())
    right = np.array(data.draw(st.lists(st.booleans(), min_size=len(first), max_size=len(first))), dtype=bool)
    second = dataclasses.replace(first, correct=right, rank=np.where(right, 0, NEVER))
    there, back = flips(first, second), flips(second, first)
    assert np.array_equal(there.lost, back.gained) and np.array_equal(there.gained, back.lost)
    assert len(there.gained) - len(there.lost) == int(right.sum()) - int(first.correct.sum())


def test_other_queries_are_refused(make):
    with pytest.raises(ValueError, match="same queries"):
        flips(make([1], [1]), make([1, 0], [1, 1]))
