import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_baselines.spatial.cells import CellEncoder, from_bytes, to_bytes


def maps(count=6, channels=8, height=4, width=5, seed=0):
    return np.random.default_rng(seed).normal(3, 2, (count, channels, height, width)).astype(np.float32)


@pytest.mark.parametrize(("dimensions", "expected"), [(5, 5), (8, 8), (99, 8)])
def test_cells_are_unit_vectors_of_as_many_dimensions_as_there_can_be(dimensions, expected):
    learnt = maps()
    cells = CellEncoder.learn(learnt, dimensions, keep=99, whitening=0.3).encode(learnt[0])
    assert cells.vectors.shape == (20, expected) and cells.vectors.dtype == np.float32
    assert np.allclose(np.linalg.norm(cells.vectors, axis=1), 1, atol=1e-5)
    assert cells.positions.tolist() == list(range(20))


def test_the_cells_that_differ_most_from_the_mean_are_kept():
    learnt = maps()
    encoder = CellEncoder.learn(learnt, 8, keep=3, whitening=0.0)
    one = np.broadcast_to(encoder.mean[:, None, None], (8, 4, 5)).copy()
    for row, column in ((0, 2), (2, 4), (3, 0)):
        one[:, row, column] += 5 * encoder.deviation
    assert encoder.encode(one).positions.tolist() == [2, 14, 15]


def test_without_projection_a_cell_is_its_standardised_channels():
    """Eigenvectors turn all cells alike, so that products between cells stay."""
    learnt = maps()
    standard = (learnt[0] - learnt.mean((0, 2, 3))[:, None, None]) / learnt.std((0, 2, 3))[:, None, None]
    expected = standard.reshape(8, -1).T / np.linalg.norm(standard.reshape(8, -1), axis=0)[:, None]
    vectors = CellEncoder.learn(learnt, 8, keep=99, whitening=0.0).encode(learnt[0]).vectors
    assert np.allclose(vectors @ vectors.T, expected @ expected.T, atol=1e-4)


def test_whitening_makes_directions_equally_long():
    random = np.random.default_rng(0)
    spread = random.normal(size=(50, 3, 10, 10)).astype(np.float32)
    spread[:, 1] = 0.9 * spread[:, 0] + 0.1 * spread[:, 1]  # two channels that nearly say the same
    lengths = []
    for whitening in (0.0, 0.5, 1.0):
        encoder = CellEncoder.learn(spread, 3, keep=99, whitening=whitening)
        rows = ((spread - encoder.mean[:, None, None]) / encoder.deviation[:, None, None]).transpose(0, 2, 3, 1)
        rows = rows.reshape(-1, 3) / np.linalg.norm(rows.reshape(-1, 3), axis=1, keepdims=True)
        variances = ((rows @ encoder.projection) ** 2).mean(axis=0)
        lengths.append(variances.max() / variances.min())
    assert lengths[0] > lengths[1] > lengths[2] and lengths[2] == pytest.approx(1, abs=1e-3)


@pytest.mark.parametrize("same", [np.zeros((1, 4, 2, 2)), np.full((3, 4, 2, 2), 7.0)])
def test_images_without_any_structure_give_finite_cells(same):
    learnt = same.astype(np.float32)
    assert np.isfinite(CellEncoder.learn(learnt, 4, keep=3, whitening=1.0).encode(learnt[0]).vectors).all()


def test_an_encoder_is_the_same_after_storing():
    learnt = maps()
    encoder = CellEncoder.learn(learnt, 5, keep=7, whitening=0.3)
    found = CellEncoder.from_arrays(encoder.arrays())
    assert found.shape == (4, 5) and found.keep == 7
    assert np.array_equal(found.encode(learnt[1]).vectors, encoder.encode(learnt[1]).vectors)


@given(st.integers(0, 2**32 - 1))
def test_bytes_lose_less_than_half_a_step(seed):
    vectors = np.random.default_rng(seed).uniform(-1, 1, (3, 4)).astype(np.float32)
    stored = to_bytes(vectors)
    assert stored.dtype == np.int8
    assert np.abs(from_bytes(stored) - vectors).max() <= 0.5 / 127 + 1e-6
