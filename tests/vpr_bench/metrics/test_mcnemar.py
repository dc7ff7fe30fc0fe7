import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.metrics.mcnemar import McNemar, mcnemar


def answers(both, only_first, only_second, neither):
    """Right and wrong answers with so many of each kind."""
    counts = (both, only_first, only_second, neither)
    return np.repeat([True, True, False, False], counts), np.repeat([True, False, True, False], counts)


@pytest.mark.parametrize(
    ("only_first", "only_second", "p_value"),
    [
        (0, 1, 1.0),  # one coin: each side is as uneven as it gets
        (0, 5, 2 / 2**5),
        (0, 6, 2 / 2**6),
        (1, 5, 2 * (1 + 6) / 2**6),
        (2, 8, 2 * (1 + 10 + 45) / 2**10),
        (10, 3, 2 * (1 + 13 + 78 + 286) / 2**13),
    ],
)
def test_values_worked_out_by_hand(only_first, only_second, p_value):
    found = mcnemar(*answers(20, only_first, only_second, 7))
    assert (found.only_first, found.only_second) == (only_first, only_second)
    assert found.p_value == pytest.approx(p_value, rel=1e-12)


def test_where_both_agree_or_err_equally_often_nothing_is_shown():
    assert mcnemar(*answers(30, 0, 0, 10)) == McNemar(0, 0, 1.0)
    assert mcnemar(*answers(0, 4, 4, 0)) == McNemar(4, 4, 1.0)
    assert mcnemar(*answers(0, 0, 0, 0)) == McNemar(0, 0, 1.0)


def test_queries_on_which_both_agree_do_not_matter():
    assert mcnemar(*answers(1000, 3, 12, 0)).p_value == mcnemar(*answers(0, 3, 12, 5)).p_value


@given(st.lists(st.tuples(st.booleans(), st.booleans()), max_size=60))
def test_swapping_the_methods_swaps_the_counts_and_nothing_else(pairs):
    first, second = np.array(pairs, dtype=bool).reshape(-1, 2).T
    there, back = mcnemar(first, second), mcnemar(second, first)
    assert (there.only_first, there.only_second) == (back.only_second, back.only_first)
    assert there.p_value == pytest.approx(back.p_value, rel=1e-12) and 0 < there.p_value <= 1


def test_there_are_as_few_false_alarms_as_the_level_says():
    # Two equal methods, 400 times: an exact test at 5 % may reject fewer, but not more than chance explains.
    generator = np.random.default_rng(0)
    p_values = [mcnemar(*(generator.random((2, 100)) < 0.7)).p_value for _ in range(400)]
    assert 0.01 < np.mean(np.array(p_values) < 0.05) < 0.07


def test_as_many_answers_of_each():
    with pytest.raises(ValueError, match="same shape"):
        mcnemar(np.ones(3, bool), np.ones(4, bool))
