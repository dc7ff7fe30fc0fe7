import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.gate.answered import Answered
from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.bootstrap import bootstrap
from vpr_bench.metrics.definitions import METRICS, compute
from vpr_bench.types.ground_truth import GroundTruth

NAMES = [name for name, metric in METRICS.items() if metric.function]


@st.composite
def matches(draw):
    """Draw answers of a method that sometimes gives none, with ties, on queries that sometimes have no match."""
    n, size = draw(st.integers(1, 12)), draw(st.integers(2, 6))
    rows = [draw(st.permutations(range(size))) for _ in range(n)]
    known = np.array([draw(st.integers(0, size)) for _ in range(n)])
    scores = np.array([sorted(draw(st.lists(st.integers(-2, 2), min_size=size, max_size=size)))[::-1] for _ in rows])
    given_none = np.arange(size) >= known[:, None]
    truth = [draw(st.lists(st.integers(0, size - 1), unique=True, max_size=2)) for _ in rows]
    indices = np.where(given_none, -1, np.array(rows))
    return indices, np.where(given_none, -np.inf, scores / 3), GroundTruth.from_lists(truth, size)


@given(matches(), st.sampled_from(["exclude", "miss", "reject"]))
def test_every_metric_and_its_bootstrap_follow_from_what_is_kept(drawn, unmatched):
    indices, scores, truth = drawn
    answers = Answers.from_matches(indices, scores, truth, unmatched)
    kept = Answered.of(indices[:, 0], answers)
    again = Answered.from_texts(**kept.texts(), n_references=truth.n_references)
    rebuilt = again.answers(unmatched, answers.depth)
    assert compute(NAMES, rebuilt) == pytest.approx(compute(NAMES, answers), nan_ok=True)
    assert np.array_equal(rebuilt.queries, answers.queries)
    ours, theirs = (bootstrap(one, ["pr_auc", "roc_auc"], resamples=20) for one in (rebuilt, answers))
    assert str(ours) == str(theirs)


@pytest.mark.parametrize(
    ("column", "values"),
    [
        ("best", ["0", "3"]),
        ("best", ["0", "-1"]),
        ("best", ["0", "x"]),
        ("rank", ["0", "9" * 30]),
        ("rank", ["0", "٣"]),
        ("score", ["0", "2"]),
        ("score", ["1", "1"]),
    ],
)
def test_values_that_cannot_be_are_refused(column, values):
    texts = {"best": ["0", "-"], "rank": ["0", "-"], "score": ["0", "-"]} | {column: values}
    with pytest.raises(ValueError, match=r"whole number|leave some out"):
        Answered.from_texts(**texts, n_references=3)
