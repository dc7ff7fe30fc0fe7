import json
import math
from dataclasses import replace

import pytest

from vpr_bench.errors import UsageError
from vpr_bench.report.rows import score_run


def test_scores_at_the_stored_radius(stored):
    row = score_run(stored())
    assert row.metrics["recall@1"] == 0.5
    assert row.metrics["recall@5"] == 1.0
    assert row.metrics["pr_auc"] == 0.5
    assert row.metrics["pr_auc_matched"] == 1.0
    assert str(row.protocol) == "gardens/day_left-night_right@0f"


@pytest.mark.parametrize(("radius", "recall"), [(0, 0.5), (1, 0.75), (2, 1.0)])
def test_scores_at_another_radius(stored, radius, recall):
    run = stored()
    row = score_run(run, ["recall@1"], run.protocol.with_radius(radius))
    assert row.metrics["recall@1"] == recall
    assert row.protocol.radius == radius


def test_pairs_are_scored_because_every_match_is_complete(stored):
    assert 0 < score_run(stored(), ["pr_auc_pairs"]).metrics["pr_auc_pairs"] < 1


def test_intervals_only_when_asked(stored):
    run = stored()
    assert score_run(run).intervals == {}
    low, high = score_run(run, ["recall@1"], resamples=200).intervals["recall@1"]
    assert 0 <= low < 0.5 < high <= 1


def test_latency_leaves_decoding_apart(stored):
    row = score_run(stored())
    assert row.latency["latency_total_p50"] == pytest.approx(30)
    assert row.latency["latency_decode_p50"] == pytest.approx(500)


def test_as_dict_is_json_with_null_for_undefined(stored):
    run = stored()
    row = score_run(run, ["recall@1", "roc_auc"], run.protocol.with_radius(2))  # everything right: roc_auc is undefined
    assert math.isnan(row.metrics["roc_auc"])
    content = json.loads(json.dumps(row.as_dict(), allow_nan=False))
    assert content["metrics"] == {"recall@1": 1.0, "roc_auc": None}
    assert content["protocol"] == "gardens/day_left-night_right@2f"


def test_unmatched_policy_is_written_in_the_protocol(stored):
    run = stored()
    row = score_run(run, protocol=replace(run.protocol, unmatched="reject"))
    assert str(row.protocol).endswith("@0f~reject")


def test_a_run_does_not_say_what_its_dataset_does_not(stored):
    run = stored()
    with pytest.raises(UsageError, match="lists no ground truth"):
        score_run(run, protocol=replace(run.protocol, unit="given", radius=0))


@pytest.mark.parametrize("radius", [-1.0, float("nan"), 3.0])
def test_bad_radius(stored, radius):
    run = stored()
    with pytest.raises(UsageError, match="radius"):
        score_run(run, protocol=run.protocol.with_radius(radius))
