import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from vpr_bench.errors import UsageError
from vpr_bench.metrics import bootstrap as module
from vpr_bench.metrics.answers import NEVER, Answers
from vpr_bench.metrics.bootstrap import (
    Difference,
    Interval,
    bootstrap,
    bootstrap_difference,
    percentile_interval,
    resampled,
    two_sided_p_value,
)
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


# A population whose true values can be worked out. Method A has uniform scores and is right with the chance that its
# score says, so that precision over the threshold t is (1 + t) / 2 and recall (1 - t^2) / 2. Method B is right with the
# square root of its score for a chance. A query that is hard for one is hard for the other.
TRUE_RECALL = {"A": 1 / 2, "B": 2 / 3}
TRUE_PR_AUC = {"A": 5 / 12, "B": 2 / 3 * (2 * np.log(2) - 1 / 2)}


def drawn(n, seed):
    """Answers of A and B to ``n`` queries of the population."""
    generator = np.random.default_rng(seed)
    hard, *scores = generator.random((3, n))
    columns = [(hard < chance, score) for chance, score in zip((scores[0], np.sqrt(scores[1])), scores, strict=True)]
    return [Answers(right, score, np.ones(n, bool), np.where(right, 0, NEVER)) for right, score in columns]


def test_the_population_is_as_it_was_worked_out():
    values = [compute(["recall@1", "pr_auc"], answers) for answers in drawn(1_000_000, seed=0)]
    for name, found in zip("AB", values, strict=True):
        assert found["recall@1"] == pytest.approx(TRUE_RECALL[name], abs=0.002)
        assert found["pr_auc"] == pytest.approx(TRUE_PR_AUC[name], abs=0.002)


def test_intervals_cover_the_truth_as_often_as_they_say():
    # Of a value and of a paired difference, in many experiments of as many queries as a short walk has.
    truth = {"recall@1": TRUE_RECALL, "pr_auc": TRUE_PR_AUC}
    experiments = 1200
    held = dict.fromkeys([(name, what) for name in truth for what in ("value", "difference")], 0)
    for seed in range(experiments):
        first, second = drawn(200, seed)
        values = [compute(truth, answers) for answers in (first, second)]
        samples = [resampled(answers, truth, 500, seed) for answers in (first, second)]
        for name, true in truth.items():
            value = percentile_interval(values[0][name], samples[0][name])
            held[name, "value"] += value.low <= true["A"] <= value.high
            difference = percentile_interval(values[1][name] - values[0][name], samples[1][name] - samples[0][name])
            held[name, "difference"] += difference.low <= true["B"] - true["A"] <= difference.high
    assert {what: 0.93 <= count / experiments <= 0.97 for what, count in held.items()} == dict.fromkeys(held, True), (
        held
    )


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
    assert bootstrap_difference(answers, answers, ["pr_auc"], 20)["pr_auc"] == Difference(0, 0, 0, p_value=1)


@settings(max_examples=25)
@given(data=st.data())
def test_swapping_the_runs_negates_the_difference(data, any_answers):
    first = data.draw(any_answers())
    right = np.array(data.draw(st.lists(st.booleans(), min_size=len(first), max_size=len(first))), dtype=bool)
    right &= first.has_match & first.answered
    second = dataclasses.replace(first, correct=right, rank=np.where(right, 0, NEVER))
    there, back = (bootstrap_difference(*pair, METRICS, 20) for pair in ((first, second), (second, first)))
    for name in METRICS:
        turned = Difference(-back[name].value, -back[name].high, -back[name].low, back[name].p_value)
        assert dataclasses.astuple(there[name]) == pytest.approx(dataclasses.astuple(turned), nan_ok=True, abs=1e-12)


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


@given(st.lists(st.one_of(st.floats(-1, 1), st.just(float("nan"))), max_size=50))
def test_a_p_value_is_a_chance_whichever_way_round(values):
    samples = np.array(values)
    p_value = two_sided_p_value(samples)
    if np.isnan(samples).all():
        assert np.isnan(p_value)
    else:
        assert 0 < p_value <= 1
        assert p_value == two_sided_p_value(-samples)


@given(
    st.integers(39, 300), st.integers(0, 20), st.integers(0, 5), st.sampled_from([0.9, 0.95, 0.99]), st.integers(-1, 1)
)
def test_the_interval_leaves_out_nothing_just_where_p_is_at_most_the_level(above, below, ties, confidence, sign):
    samples = sign * np.repeat([0.005, 0.0, -0.005], [above, ties, below])
    interval = percentile_interval(0.0, samples, confidence)
    finest = 2 / (len(samples) + 1) <= 1 - confidence + 1e-9  # fewer resamples than that cannot say anything
    if finest:
        assert (interval.low > 0 or interval.high < 0) == (two_sided_p_value(samples) <= 1 - confidence + 1e-9)


def test_the_bounds_of_an_interval_are_resampled_values():
    samples = np.repeat([0.0, 0.005], [50, 1950])
    assert percentile_interval(0.005, samples) == Interval(0.005, 0.0, 0.005)
    assert percentile_interval(0.0, np.arange(1.0, 1000), 0.9) == Interval(0.0, 50.0, 950.0)
    assert percentile_interval(0.0, np.array([2.0, np.nan, 1.0])) == Interval(0.0, 1.0, 2.0)
