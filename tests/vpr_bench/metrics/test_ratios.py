import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.metrics.ratios import paired_ratio


@pytest.fixture
def noise():
    """Return the slowness of a machine for each of 5 rounds of 41 images: mostly a little, at times 100-fold."""
    random = np.random.default_rng(0)
    return np.where(random.random((5, 41)) < 0.3, 100.0, 1.0) * random.uniform(1, 1.1, (5, 41))


def test_what_slows_down_both_changes_nothing(noise):
    ratio = paired_ratio(0.012 * noise, 0.010 * noise)
    assert (ratio.low, ratio.value, ratio.high) == pytest.approx((1.2, 1.2, 1.2))


def test_single_disturbed_answers_do_not_move_the_ratio():
    first, seconds = np.full((3, 20), 0.010), np.full((3, 20), 0.015)
    seconds[0], first[1] = 9.0, 9.0  # a whole round of each
    assert paired_ratio(seconds, first).value == pytest.approx(1.5)


def test_the_interval_is_of_images_and_covers_the_ratio(noise):
    images = np.random.default_rng(1).uniform(1, 3, 41)
    ratio = paired_ratio(images * noise, noise, seed=3)
    assert ratio.value == pytest.approx(np.median(images))
    assert 1 < ratio.low < ratio.value < ratio.high < 3
    assert paired_ratio(images * noise, noise, seed=3) == ratio
    again = paired_ratio(np.tile(images * noise, (4, 1)), np.tile(noise, (4, 1)), seed=3)
    assert (again.low, again.high) == pytest.approx((ratio.low, ratio.high))  # more rounds are not more images


@given(
    st.lists(st.tuples(st.floats(0.1, 10), st.floats(0.1, 10)), min_size=1, max_size=31).filter(lambda x: len(x) % 2)
)
def test_the_other_way_round_it_is_the_inverse(times):
    one, other = np.array(times).T[:, None]
    assert paired_ratio(one, other, 1).value == pytest.approx(1 / paired_ratio(other, one, 1).value)


@pytest.mark.parametrize("shape", [(3, 0), (0, 3)])
def test_without_times_there_is_no_ratio(shape):
    assert np.isnan(paired_ratio(np.empty(shape), np.empty(shape)).value)


def test_a_stage_that_took_no_time_has_no_ratio():
    ratio = paired_ratio(np.ones((2, 3)), np.zeros((2, 3)))
    assert np.isnan([ratio.value, ratio.low, ratio.high]).all()


def test_times_of_other_images_are_refused():
    with pytest.raises(ValueError, match="same images and rounds"):
        paired_ratio(np.ones((2, 3)), np.ones((3, 2)))
