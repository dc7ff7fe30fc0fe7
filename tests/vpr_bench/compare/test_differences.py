import numpy as np
import pytest

from vpr_bench.compare.differences import differences
from vpr_bench.compare.pair import RunPair
from vpr_bench.errors import UsageError
from vpr_bench.metrics.bootstrap import bootstrap_difference
from vpr_bench.metrics.definitions import METRICS


def test_differences_are_of_the_paired_bootstrap(pair_of_runs):
    pair = RunPair.of(*pair_of_runs)
    found = differences(pair, ["recall@1", "pr_auc"], resamples=200, seed=3)
    expected = bootstrap_difference(pair.answers[1], pair.answers[0], ["recall@1", "pr_auc"], 200, seed=3)
    assert {one.metric: one.difference for one in found} == expected
    assert (found[0].first, found[0].second, found[0].difference.value) == (0.5, 0.625, 0.125)
    assert not found[0].significant and found[0].p_value > 0.5


def test_a_difference_that_is_there_is_significant(stored):
    right = list(range(8))
    found = differences(
        RunPair.of(stored(first=[7 - place for place in right]), stored(first=right)), ["recall@1"], 500
    )
    assert found[0].significant and found[0].p_value == pytest.approx(2 / 501)


def test_swapping_the_runs_turns_everything_round(pair_of_runs):
    first, second = pair_of_runs
    there = differences(RunPair.of(first, second), list(METRICS), 100)
    back = differences(RunPair.of(second, first), list(METRICS), 100)
    for one, other in zip(there, back, strict=True):
        assert one.first == pytest.approx(other.second, nan_ok=True)
        assert one.difference.value == pytest.approx(-other.difference.value, nan_ok=True)
        assert one.difference.low == pytest.approx(-other.difference.high, nan_ok=True)
        assert one.difference.high == pytest.approx(-other.difference.low, nan_ok=True)
        assert one.p_value == pytest.approx(other.p_value, nan_ok=True)


def test_what_was_not_kept_is_undefined(stored):
    found = differences(RunPair.of(stored(k=3), stored(k=6, label="sad")), ["recall@5", "pr_auc_pairs"], 20)
    for one in found:
        assert np.isnan(one.difference.value) and np.isnan(one.difference.low) and np.isnan(one.p_value)
        assert not one.significant
    assert found[0].second == 1.0


def test_every_pair_is_a_decision_where_all_scores_were_kept(stored):
    pair = RunPair.of(stored(k=8), stored(k=8, label="sad", first=[1, 0, 2, 3, 4, 5, 6, 7]))
    found = differences(pair, ["pr_auc_pairs"], 20)[0]
    assert found.difference.value < 0 and np.isnan(found.difference.low)


def test_a_metric_that_does_not_exist(pair_of_runs):
    with pytest.raises(UsageError, match="no metric"):
        differences(RunPair.of(*pair_of_runs), ["pr_auck"])
