import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from vpr_baselines.spatial.agreement import agreement
from vpr_baselines.spatial.cells import Cells

ROWS, COLUMNS = 6, 8


def unit(vectors):
    return (vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)).astype(np.float32)


def scene(seed, rows=ROWS + 6, columns=COLUMNS + 6, dimensions=16):
    """A wide scene of distinct cells, of which images are cut-outs."""
    return unit(np.random.default_rng(seed).normal(size=(rows, columns, dimensions)))


def cut(scene, top=0, left=0):
    return Cells(scene[top : top + ROWS, left : left + COLUMNS].reshape(ROWS * COLUMNS, -1), np.arange(ROWS * COLUMNS))


def score(query, *candidates):
    vectors, positions = (np.stack([getattr(one, name) for one in candidates]) for name in ("vectors", "positions"))
    return agreement(query, vectors, positions, (ROWS, COLUMNS))


def test_an_image_agrees_with_itself_entirely():
    image = cut(scene(0))
    assert score(image, image) == pytest.approx(1, abs=1e-4)


@pytest.mark.parametrize(("down", "across"), [(0, 1), (2, 0), (1, 3), (3, 2)])
def test_a_displaced_image_agrees_as_far_as_the_two_overlap(down, across):
    """Cells outside the overlap find mutual neighbours too, which do not move together."""
    wide = scene(1)
    found = score(cut(wide), cut(wide, down, across), cut(scene(2)))
    overlap = (ROWS - down) * (COLUMNS - across) / (ROWS * COLUMNS)
    assert overlap - 1e-4 <= found[0] <= overlap + 0.1
    assert found[1] < 0.3 < found[0]


def test_the_same_cells_in_disorder_agree_little():
    image = cut(scene(3))
    disorder = np.random.default_rng(0).permutation(ROWS * COLUMNS)
    assert score(image, Cells(image.vectors[disorder], image.positions))[0] < 0.35


def test_only_mutual_neighbours_vote():
    """Two cells of the query have the same nearest neighbour, and only the nearer one is its nearest."""
    near, far, other = unit(np.array([[1, 0.1, 0], [1, 0.5, 0], [0, 0, 1]]))
    query = Cells(np.stack([near, far]), np.array([0, 20]))
    candidate = Cells(np.stack([unit(np.array([1.0, 0, 0])), -other]), np.array([0, 40]))
    expected = (1 / np.sqrt(1.01)) ** 2 / 2
    assert score(query, candidate) == pytest.approx(expected, abs=1e-5)


def test_votes_for_neighbouring_displacements_add_up_a_little():
    """A cell that moved one column farther counts exp(-1/2) at the peak of the others."""
    vectors = unit(np.eye(3))
    still = Cells(vectors, np.array([0, 10, 20]))
    assert score(still, Cells(vectors, np.array([0, 10, 21]))) == pytest.approx((2 + np.exp(-0.5)) / 3, abs=1e-5)
    assert score(still, Cells(vectors, np.array([0, 10, 23]))) == pytest.approx(2 / 3, abs=1e-5)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 1000), st.integers(1, 5))
def test_a_candidate_has_the_same_score_whatever_it_is_compared_beside(seed, count):
    random = np.random.default_rng(seed)
    images = [
        Cells(unit(random.normal(size=(9, 4))), np.sort(random.choice(ROWS * COLUMNS, 9, replace=False)))
        for _ in range(count + 1)
    ]
    together = score(*images)
    alone = [score(images[0], one)[0] for one in images[1:]]
    assert together.shape == (count,) and np.allclose(together, alone, atol=1e-5)


def test_identical_cells_everywhere_give_something_finite():
    flat = Cells(unit(np.ones((ROWS * COLUMNS, 4))), np.arange(ROWS * COLUMNS))
    assert np.isfinite(score(flat, flat)).all()
