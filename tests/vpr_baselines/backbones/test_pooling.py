from itertools import pairwise

import numpy as np
import pytest

from vpr_baselines.backbones.pooling import POOLINGS, average, gem, grid


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


def test_a_grid_pools_cell_by_cell(maps):
    pooled = grid(maps, 1, 2)
    assert pooled.shape == (2, 10) and pooled.dtype == np.float32
    assert np.array_equal(pooled, np.concatenate([gem(maps[..., :2]), gem(maps[..., 2:])], axis=1))
    assert np.array_equal(grid(maps, 1, 1), gem(maps))


@pytest.mark.parametrize(("rows", "columns"), [(1, 3), (2, 3), (4, 5)])
def test_cells_cover_every_pixel_and_none_is_empty(rows, columns):
    """Each pixel in turn is the only one that is not zero."""
    for place in range(3 * 4):
        one = np.zeros((1, 1, 3, 4), np.float32)
        one.flat[place] = 1
        pooled = grid(one, rows, columns)
        assert pooled.shape == (1, rows * columns) and pooled.max() > 0.1


def test_all_poolings_agree_on_a_constant_map():
    for name, pool in POOLINGS.items():
        pooled = pool(np.full((1, 2, 3, 4), 0.5, np.float32))
        assert pooled == pytest.approx(0.5), name
        assert pooled.dtype == np.float32


def test_the_average_is_the_mean(maps):
    assert np.array_equal(average(maps), maps.mean(axis=(2, 3)))
