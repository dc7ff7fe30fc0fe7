import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from vpr_bench.errors import UsageError
from vpr_bench.metrics import bootstrap as module
from vpr_bench.metrics.bootstrap import Interval, bootstrap, bootstrap_difference, resampled
from vpr_bench.metrics.definitions import METRICS, compute


def flips(n, share, seed):
    """``n`` answers, each right with the given chance."""
    return np.random.default_rng(seed).random(n) < share


@settings(max_examples=40)
@given(data=st.data())
def test_a_resample_is_the_metric_on_the_queries_drawn(data, any_answers):
    answers = data.draw(any_answers())
    samples = resampled(answers, METRICS, resamples=5, seed=3)
    generator = np.random.default_rng(3)
    for i in range(5):
        drawn = generator.integers(len(answers), size=len(answers)) if len(answers) else np.zeros(0, int)
        again = compute(METRICS, answers.take(drawn))
        for name in METRICS:
            assert samples[name][i] == pytest.approx(again[name], nan_ok=True, rel=1e-12)


def test_chunks_do_not_matter(make, monkeypatch):
    answers = make(flips(50, 0.5, 0), np.arange(50) % 7)
    whole = resampled(answers, ["pr_auc"], resamples=23)["pr_auc"]
    monkeypatch.setattr(module, "CHUNK_ELEMENTS", 200)
    assert np.array_equal(resampled(answers, ["pr_auc"], resamples=23)["pr_auc"], whole)


def test_the_seed_decides(make):
    answers = make(flips(50, 0.5, 0), np.arange(50))
    assert bootstrap(answers, ["pr_auc"], 50, seed=1) == bootstrap(answers, ["pr_auc"], 50, seed=1)
    assert bootstrap(answers, ["pr_auc"], 50, seed=1) != bootstrap(answers, ["pr_auc"], 50, seed=2)


def test_more_confidence_is_a_wider_interval(make):
    answers = make(flips(80, 0.5, 0), np.arange(80))
    narrow = bootstrap(answers, ["recall@1"], 300, confidence=0.5)["recall@1"]
    wide = bootstrap(answers, ["recall@1"], 300, confidence=0.99)["recall@1"]
    assert wide.low < narrow.low <= narrow.value <= narrow.high < wide.high


def test_what_is_undefined_stays_undefined(make):
    for answers in (make([], []), make([1, 1], [2, 1])):
        interval = bootstrap(answers, ["roc_auc", "pr_auc_pairs"], 20)
        assert all(np.isnan(dataclasses.astuple(value)).all() for value in interval.values())


def test_resamples_in_which_a_metric_is_undefined_are_left_out(make):
    # With one wrong answer in six, about a third of the resamples have no wrong one and so no ROC.
    answers = make([1, 1, 1, 1, 1, 0], [6, 5, 4, 3, 2, 1])
    assert np.isnan(resampled(answers, ["roc_auc"], 200)["roc_auc"]).any()
    assert bootstrap(answers, ["roc_auc"], 200)["roc_auc"] == Interval(1, 1, 1)


def test_the_interval_covers_the_truth_as_often_as_it_says(make):
    # 300 experiments of 200 queries with a true recall of 0.7: 95 % of the intervals, give
    # or take 1.3 %, should hold it.
    held = 0
    for experiment in range(300):
        answers = make(flips(200, 0.7, experiment), np.zeros(200))
        interval = bootstrap(answers, ["recall@1"], 200, seed=experiment)["recall@1"]
        held += interval.low <= 0.7 <= interval.high
    assert 0.90 <= held / 300 <= 0.98


def test_the_paired_interval_is_narrower_than_the_unpaired_spread(make):
    # The second run answers like the first, and five of a hundred queries better.
    right = flips(100, 0.5, 0)
    better = right | (np.cumsum(~right) <= 5)
    first, second = make(better, np.arange(100)), make(right, np.arange(100))
    difference = bootstrap_difference(first, second, ["recall@1"], 500)["recall@1"]
    assert difference.value == pytest.approx(0.05)
    assert 0 < difference.low < 0.05 < difference.high < 0.12
    alone = bootstrap(first, ["recall@1"], 500)["recall@1"]
    assert difference.high - difference.low < alone.high - alone.low


def test_a_run_does_not_differ_from_itself(make):
    answers = make(flips(30, 0.5, 0), np.arange(30))
    assert bootstrap_difference(answers, answers, ["pr_auc"], 20)["pr_auc"] == Interval(0, 0, 0)


def test_runs_on_different_queries_are_not_compared(make):
    with pytest.raises(ValueError, match="same queries"):
        bootstrap_difference(make([1], [1]), make([1, 0], [1, 1]), ["pr_auc"])
    with pytest.raises(ValueError, match="same policy"):
        bootstrap_difference(make([1], [1]), make([1], [1], unmatched="miss"), ["pr_auc"])


def test_impossible_settings_are_refused(make):
    answers = make([1], [1])
    with pytest.raises(UsageError, match=r"at least 1\. Got 0"):
        bootstrap(answers, ["pr_auc"], resamples=0)
    with pytest.raises(UsageError, match=r"between 0 and 1\. Got 95"):
        bootstrap(answers, ["pr_auc"], resamples=1, confidence=95)
    with pytest.raises(UsageError, match="no metric"):
        bootstrap(answers, ["pr_auck"])
