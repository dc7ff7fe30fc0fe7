import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from vpr_baselines.sequence.rows import contrasted, similarity_row
from vpr_bench.types.match import Match


class Scorer:
    def __init__(self, row):
        self.row = row

    def fit(self, references): ...

    def match(self, image, k): ...

    def scores(self, image):
        return self.row


class Ranker:
    def __init__(self, match):
        self.answer = match

    def fit(self, references): ...

    def match(self, image, k):
        self.asked = k
        return self.answer


def test_scores_are_taken_where_a_method_has_them():
    assert similarity_row(Scorer([0.5, -1, 2]), None, 3).tolist() == [0.5, -1, 2]


@pytest.mark.parametrize("row", [[1.0, 2.0], [1.0, np.nan, 2.0], [1.0, np.inf, 2.0], [[1.0, 2.0, 3.0]]])
def test_scores_that_are_no_row_are_refused(row):
    with pytest.raises(ValueError, match=r"the scores must be \(3,\) and finite"):
        similarity_row(Scorer(row), None, 3)


def test_the_others_are_asked_for_all_references():
    method = Ranker(Match([2, 0], [0.9, 0.4]))
    assert similarity_row(method, None, 4).tolist() == pytest.approx([0.4, 0.4, 0.9, 0.4])
    assert method.asked == 4
    assert similarity_row(Ranker(Match([], [])), None, 3).tolist() == [0, 0, 0]


def test_contrast_is_that_of_the_neighbourhood():
    """By the formula, written as a loop."""
    row = np.random.default_rng(0).normal(size=40).astype(np.float32)
    width, padded = 7, np.pad(row, 3, mode="symmetric").astype(np.float64)
    windows = np.lib.stride_tricks.sliding_window_view(padded, width)
    expected = (row - windows.mean(axis=1)) / (windows.std(axis=1) + row.std(dtype=np.float64))
    assert contrasted(row, width) == pytest.approx(expected, abs=1e-5)


def test_without_a_neighbourhood_the_whole_row_counts():
    row = np.array([1, 2, 3, 6], dtype=np.float32)
    expected = (row - row.mean()) / (2 * row.std())
    for width in (0, 4, 5):
        assert contrasted(row, width) == pytest.approx(expected)


@pytest.mark.parametrize("row", [np.zeros(9), np.full(9, 0.3), np.full(1, 5), 1e6 + 1e-3 * np.arange(9)])
def test_nothing_stands_out_of_an_even_row(row):
    assert not contrasted(row.astype(np.float32), 3).any()


@given(
    row=arrays(np.float32, st.integers(1, 50), elements=st.floats(-100, 100, width=32)),
    width=st.integers(0, 60),
    scale=st.sampled_from([0.5, 1, 8]),
    shift=st.sampled_from([-4, 0, 16]),
)
def test_contrast_is_finite_and_knows_no_unit(row, width, scale, shift):
    found = contrasted(row, width)
    assert found.dtype == np.float32 and found.shape == row.shape
    assert np.isfinite(found).all()
    if row.std() > 1:
        assert contrasted(row * scale + shift, width) == pytest.approx(found, abs=1e-3)
