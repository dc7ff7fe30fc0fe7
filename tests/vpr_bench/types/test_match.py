import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.types.match import Match


def test_types_are_settled_and_the_input_is_copied():
    indices, scores = np.array([3, 1], dtype=np.int64), np.array([0.5, 0.5], dtype=np.float32)
    match = Match(indices, scores)
    indices[0], scores[0] = 9, 9
    assert match.indices.tolist() == [3, 1] and match.scores.tolist() == [0.5, 0.5]
    assert match.indices.dtype == np.int64 and match.scores.dtype == np.float32
    assert len(match) == 2


@pytest.mark.parametrize(
    ("indices", "scores", "message"),
    [
        ([0, 1], [0.5], "shape"),
        ([[0]], [[0.5]], "shape"),
        ([0.0], [0.5], "integers"),
        ([True], [0.5], "integers"),
        ([-1], [0.5], "not negative"),
        ([2, 2], [0.5, 0.4], "unique"),
        ([0], [np.nan], "finite"),
        ([0], [np.inf], "finite"),
        ([0, 1], [0.4, 0.5], "must not increase"),
    ],
)
def test_what_is_not_a_match_is_refused(indices, scores, message):
    with pytest.raises(ValueError, match=message):
        Match(indices, scores)


def test_ranking_keeps_the_order_of_equal_scores():
    match = Match.from_scores([0.2, 0.9, 0.2, 0.9], k=3)
    assert match.indices.tolist() == [1, 3, 0]


def test_ranking_of_candidates_names_the_candidates():
    match = Match.from_scores([0.2, 0.9], k=10, candidates=[17, 4])
    assert match.indices.tolist() == [4, 17]


@pytest.mark.parametrize(
    ("scores", "k", "said"),
    [([0.5], 0, "at least 1"), ([0.5, 0.4], -1, "at least 1"), ([np.nan, 0.5], 1, "Got NaN for 1 of 2")],
)
def test_ranking_refuses_what_cannot_be_ranked(scores, k, said):
    with pytest.raises(ValueError, match=said):
        Match.from_scores(scores, k)


def test_a_method_may_answer_nothing():
    assert len(Match([], [])) == 0


@given(st.lists(st.sampled_from([-np.inf, -1.0, 0.0, 0.5, 2.0]), min_size=1, max_size=60), st.integers(1, 12))
def test_a_few_of_many_are_the_same_as_the_first_of_all(scores, k):
    scores = [2.5, *scores]
    expected = np.argsort(-np.array(scores), kind="stable")[:k]
    if np.isneginf(np.array(scores)[expected]).any():
        with pytest.raises(ValueError, match="finite"):
            Match.from_scores(scores, k)
    else:
        assert Match.from_scores(scores, k).indices.tolist() == expected.tolist()
