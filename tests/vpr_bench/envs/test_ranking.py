import pickle
import re

import numpy as np
import pytest
from gymnasium.error import InvalidAction
from gymnasium.vector.utils import batch_space

from vpr_bench.envs.ranking import Ranking
from vpr_bench.types.match import Match

SPACE = Ranking(n_references=10, k=3, seed=4)


def action(indices, scores=(0.9, 0.5, 0.1)):
    return {"indices": np.array(indices), "scores": np.array(scores, dtype=np.float32)}


def test_samples_are_valid_and_repeat():
    drawn = [SPACE.sample() for _ in range(50)]
    assert all(one in SPACE for one in drawn)
    assert {tuple(one["indices"]) for one in drawn} != {tuple(drawn[0]["indices"])}
    SPACE.seed(7)
    first = SPACE.sample()
    SPACE.seed(7)
    assert np.array_equal(SPACE.sample()["indices"], first["indices"])


def test_samples_of_a_batch_are_valid():
    space = Ranking(10, 3, batch=5, seed=0)
    drawn = space.sample()
    assert drawn["indices"].shape == drawn["scores"].shape == (5, 3)
    assert drawn in space


def test_a_ranking_is_not_drawn_in_parts():
    with pytest.raises(ValueError, match="neither mask"):
        SPACE.sample(mask={})


@pytest.mark.parametrize(
    "valid",
    [
        action([4, 2, 0]),
        action([4, 2, 0], [57, 57, -3e30]),
        action([4, -1, -1], [0.1, 0.0, 7.0]),
        action([-1, -1, -1], [-np.inf] * 3),
    ],
    ids=["full", "any finite scores", "padded", "no answer"],
)
def test_valid_answers_belong_to_it(valid):
    assert valid in SPACE
    indices, scores = SPACE.parse(valid)
    assert indices.shape == scores.shape == (1, 3)
    assert indices.dtype == np.int64 and scores.dtype == np.float32
    assert np.array_equal(np.isneginf(scores), indices < 0)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (action([4, 2, 10]), "[0, 10)"),
        (action([4, -2, -1]), "[0, 10)"),
        (action([4, 4, 0]), "only once"),
        (action([4, -1, 0]), "after the first -1"),
        (action([4, 2, 0], [0.1, 0.5, 0.9]), "must not increase"),
        (action([4, 2, 0], [np.nan, 0.5, 0.1]), "finite"),
        (action([4, 2, 0], [np.inf, 0.5, 0.1]), "finite"),
        (action([4, 2, -1], [0.5, -np.inf, 0]), "finite"),
        ({"indices": [4, 2, 0], "scores": [1e300, 1, 0]}, "finite"),
        (action([4, 2], [0.5, 0.1]), "shape (3,)"),
        (action([4.0, 2.0, 0.0]), "integers"),
        (action([4, 2, 0])["indices"], "dict"),
        ({"indices": [1, 2, 3]}, "dict"),
        (7, "dict"),
        (Match([1], [0.5]), "dict"),
    ],
)
def test_others_are_refused_with_a_reason(wrong, words):
    assert wrong not in SPACE
    with pytest.raises(InvalidAction, match=re.escape(words)):
        SPACE.parse(wrong)


def test_the_wrong_row_of_a_batch_is_shown_and_rows_that_are_no_answers_are_not_looked_at():
    space = Ranking(10, 3, batch=2)
    both = {"indices": np.array([[4, 2, 0], [5, 5, 0]]), "scores": np.zeros((2, 3), np.float32)}
    with pytest.raises(InvalidAction, match=r"\[5 5 0\]"):
        space.parse(both)
    indices, _ = space.parse(both, rows=np.array([True, False]))
    assert indices.tolist() == [[4, 2, 0]]


def test_what_is_parsed_is_a_copy():
    given = action([4, -1, -1])
    indices, scores = SPACE.parse(given)
    indices[:], scores[:] = 7, 7
    assert given["indices"].tolist() == [4, -1, -1] and given["scores"][0] == np.float32(0.9)


def test_a_match_becomes_an_action():
    padded = SPACE.of(Match([7], [0.5]))
    assert padded["indices"].tolist() == [7, -1, -1] and padded["scores"].tolist() == [0.5, -np.inf, -np.inf]
    assert SPACE.of(Match(range(9), -np.arange(9)))["indices"].tolist() == [0, 1, 2]
    assert padded in SPACE


def test_gymnasium_can_batch_and_pickle_it():
    batched = batch_space(SPACE, 4)
    assert isinstance(batched, Ranking) and batched.batch == 4
    assert batched.sample() in batched
    assert pickle.loads(pickle.dumps(SPACE)) == SPACE  # noqa: S301
