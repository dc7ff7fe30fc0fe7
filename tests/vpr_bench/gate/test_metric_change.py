from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.gate.metric_change import metric_change
from vpr_bench.gate.rules import Rule
from vpr_bench.metrics.answers import NEVER, Answers


def answers(correct, has_match=None, unmatched="exclude"):
    correct = np.asarray(correct, bool)
    matched = np.ones(len(correct), bool) if has_match is None else has_match
    return Answers(correct, np.linspace(1, 0, len(correct)), matched, np.where(correct, 0, NEVER), unmatched)


def right(count, n=200):
    return answers(np.arange(n) < count)


@pytest.mark.parametrize(("now", "fails"), [(140, False), (136, False), (135, True), (160, False)])
def test_tolerance_is_the_largest_drop_that_passes(now, fails):
    change = metric_change("recall@1", Rule(tolerance=0.02), right(140), right(now))
    assert bool(change.faults) is fails
    assert change.difference == pytest.approx((now - 140) / 200)


def test_significance_of_shares_is_mcnemars():
    change = metric_change("recall@1", Rule(significance=0.05), right(140), right(134))
    assert change.p_value == pytest.approx(2 * 0.5**6)
    assert "McNemar" in change.faults[0]
    assert not metric_change("recall@1", Rule(significance=0.05), right(140), right(135)).faults
    assert not metric_change("recall@1", Rule(significance=0.01), right(140), right(134)).faults


@pytest.mark.parametrize("metric", ["pr_auc", "average_precision", "roc_auc"])
def test_significance_of_the_others_is_the_paired_bootstraps(metric):
    random = np.random.default_rng(1)
    before = answers(np.sort(random.random(200)) < 0.7)
    shuffled = answers(random.permutation(before.correct))
    change = metric_change(metric, Rule(significance=0.05), before, shuffled)
    assert change.interval is not None
    assert change.interval[1] < 0 and change.p_value <= 0.05
    assert "bootstrap" in change.faults[0]


@pytest.mark.parametrize("significance", [0.001, 0.05, 0.3, 0.9])
@pytest.mark.parametrize("seed", range(4))
def test_the_bootstraps_p_value_decides_and_its_interval_agrees(significance, seed):
    random = np.random.default_rng(seed)
    before, after = (answers(random.permutation(60) < count) for count in (40, 34))
    change = metric_change("pr_auc", Rule(significance=significance), before, after)
    if change.difference < 0:
        assert bool(change.faults) is (change.p_value <= significance) is (change.interval[1] < 0)


@given(st.lists(st.booleans(), min_size=1, max_size=30), st.sampled_from(["recall@1", "pr_auc", "accuracy", "roc_auc"]))
def test_the_same_answers_never_fail(correct, metric):
    change = metric_change(metric, Rule(tolerance=0, significance=0.99), answers(correct), answers(correct))
    assert not change.faults
    assert change.difference == 0 or np.isnan(change.before)


@pytest.mark.parametrize(("depth", "fails"), [(20, True), (50, False), (NEVER, False)])
def test_a_metric_that_needs_more_answers_than_were_kept_fails(depth, fails):
    shallow = replace(right(140), depth=depth)
    change = metric_change("recall@50", Rule(tolerance=0), shallow, shallow)
    assert bool(change.faults) is fails
    assert np.isnan(change.difference) == fails
    assert all("recall@50 is undefined: it needs more answers than the 20" in fault for fault in change.faults)


def test_undefined_now_fails_and_undefined_then_does_not():
    nothing, something = answers([True, True]), answers([True, False])
    assert metric_change("roc_auc", Rule(), something, nothing).faults == ("roc_auc was 1.000 and is undefined now",)
    assert not metric_change("roc_auc", Rule(tolerance=0), nothing, something).faults


def test_accuracy_counts_what_is_rejected_well():
    matched = np.arange(20) < 10
    silent = answers(matched, matched, "reject")
    silent = Answers(matched, np.where(matched, 1.0, -np.inf), matched, silent.rank, "reject")
    loud = Answers(matched, np.ones(20), matched, silent.rank, "reject")
    change = metric_change("accuracy", Rule(significance=0.05), silent, loud)
    assert (change.before, change.after) == (1.0, 0.5)
    assert change.p_value == pytest.approx(2 * 0.5**10)
