import numpy as np
import pytest
from hypothesis import strategies as st

from vpr_bench.metrics.answers import NEVER, Answers


@st.composite
def _any_answers(draw, all_matched=False):
    """Up to 30 queries, few distinct scores (so that many tie), every policy, every mix of outcomes."""
    outcomes = ["right", "second", "wrong", "wrong again"]
    if not all_matched:
        outcomes += ["unmatched", "unanswered", "unmatched and unanswered"]
    given = draw(st.lists(st.sampled_from(outcomes), max_size=30))
    unmatched = draw(st.sampled_from(["exclude", "miss", "reject"]))
    if unmatched == "exclude":
        given = [outcome for outcome in given if not outcome.startswith("unmatched")]
    scores = draw(st.lists(st.integers(-4, 4), min_size=len(given), max_size=len(given)))
    column = np.array(given, dtype=object)
    return Answers(
        correct=column == "right",
        score=np.where([o.endswith("unanswered") for o in given], -np.inf, np.array(scores, dtype=float)),
        has_match=~np.array([o.startswith("unmatched") for o in given], dtype=bool),
        rank=np.select([column == "right", column == "second"], [0, 1], NEVER).astype(np.int64),
        unmatched=unmatched,
    )


@pytest.fixture(scope="session")
def any_answers():
    """A hypothesis strategy; with ``all_matched=True`` every query has a match and an answer."""
    return _any_answers


@pytest.fixture
def make():
    """Answers from short columns: right or wrong, score, and optionally which queries have a match."""

    def make(correct, score, has_match=None, rank=None, unmatched="exclude"):
        correct = np.array(correct, dtype=bool)
        return Answers(
            correct,
            np.array(score, dtype=float),
            np.ones(len(correct), bool) if has_match is None else np.array(has_match, dtype=bool),
            np.where(correct, 0, NEVER) if rank is None else np.array(rank),
            unmatched,
        )

    return make
