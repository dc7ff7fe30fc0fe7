import numpy as np
import pytest

from vpr_bench.compare import compare_runs
from vpr_bench.compare.caveats import caveats
from vpr_bench.errors import UsageError


def test_everything_about_two_runs(pair_of_runs):
    found = compare_runs(*pair_of_runs, resamples=50, seed=4)
    assert (found.n_queries, found.n_counted, found.both, found.neither) == (8, 8, 2, 1)
    assert (found.mcnemar.only_first, found.mcnemar.only_second) == (2, 3)
    assert ([one.query for one in found.lost], [one.query for one in found.gained]) == ([0, 1], [4, 5, 6])
    assert [one.stage for one in found.speed.stages] == ["encode", "total"]
    assert (found.resamples, found.seed, found.simulated) == (50, 4, False)


def test_all_metrics_but_those_that_need_every_score(stored):
    few = compare_runs(stored(), stored(label="sad"), resamples=5)
    assert "pr_auc" in (names := [one.metric for one in few.metrics]) and "pr_auc_pairs" not in names
    all_scores = compare_runs(stored(k=8), stored(k=8, label="sad"), resamples=5)
    assert "pr_auc_pairs" in [one.metric for one in all_scores.metrics]
    asked = compare_runs(stored(), stored(label="sad"), ["pr_auc_pairs"], resamples=5)
    assert np.isnan(asked.metrics[0].first)


def test_queries_that_do_not_count(stored):
    labels = {"queries": np.arange(8.0) + 3, "references": np.arange(8.0)}  # five of them are on the map
    runs = [stored(first=first, labels=labels, label=str(first)) for first in ([3, 4, 5, 0, 0, 0, 0, 0], [0] * 8)]
    found = compare_runs(*runs, resamples=20)
    assert (found.n_queries, found.n_counted, found.both, found.neither) == (8, 5, 0, 2)
    missed = compare_runs(*runs, unmatched="miss", resamples=20)
    assert (missed.n_counted, missed.neither) == (8, 5)


def test_no_query_counts(stored):
    labels = {"queries": np.arange(8.0) + 50, "references": np.arange(8.0)}
    found = compare_runs(stored(labels=labels), stored(labels=labels, label="sad"), resamples=5)
    assert found.n_counted == 0 and all(np.isnan(one.difference.value) for one in found.metrics)
    assert found.mcnemar.p_value == 1.0 and not found.lost and not found.gained


def test_the_edition_is_remembered(stored):
    protocol = "gardens:simulated/day_left-night_right@0f"
    assert compare_runs(stored(protocol=protocol), stored(protocol=protocol, label="sad"), resamples=5).simulated


def test_folders_of_one_name_are_told_apart(stored, tmp_path):
    found = compare_runs(stored(), stored(label="sad"), resamples=5)
    assert found.folders == ("run0", "run1")
    found = compare_runs(stored(folder="before/run"), stored(folder="after/run"), resamples=5)
    assert found.folders == (str(tmp_path / "before/run"), str(tmp_path / "after/run"))


@pytest.mark.parametrize(
    ("changes", "identical"),
    [({}, True), ({"k": 2}, True), ({"scores": [0.5] * 8}, False), ({"first": [0] * 8}, False)],
)
def test_identical_answers(stored, changes, identical):
    found = compare_runs(stored(), stored(label="sad", **changes), ["recall@1"], resamples=5)
    assert found.identical is identical
    assert any("the same answers" in note for note in caveats(found)) is identical


def test_no_resamples(pair_of_runs):
    with pytest.raises(UsageError, match="at least 1"):
        compare_runs(*pair_of_runs, resamples=0)
