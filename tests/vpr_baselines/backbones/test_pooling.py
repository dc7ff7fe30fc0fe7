from itertools import pairwise

import numpy as np
import pytest

from vpr_baselines.backbones.pooling import gem


@pytest.fixture
def maps():
    return np.random.default_rng(0).random((2, 5, 3, 4), dtype=np.float32) * 6


def test_power_1_is_the_average(maps):
    assert gem(maps, power=1) == pytest.approx(maps.mean(axis=(2, 3)), rel=1e-5)


def test_it_lies_between_average_and_maximum_and_grows_with_the_power(maps):
    pooled = [gem(maps, power) for power in (1, 2, 3, 10)]
    for low, high in pairwise(pooled):
        assert (low < high).all()
    assert (pooled[-1] < maps.max(axis=(2, 3))).all()


def test_the_default_is_the_cubic_mean():
    assert gem(np.array([[[[1, 2], [3, 4]]]], np.float32)).item() == pytest.approx(25 ** (1 / 3))


def test_shape_and_type_are_settled_and_the_maps_left_alone(maps):
    before = maps.copy()
    pooled = gem(maps)
    assert pooled.shape == (2, 5) and pooled.dtype == np.float32
    assert np.array_equal(maps, before)


def test_maps_of_zeros_give_a_finite_number():
    assert 0 < gem(np.zeros((1, 1, 2, 2), np.float32)).item() < 1e-5
