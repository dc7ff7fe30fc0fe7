import dataclasses
import math

import numpy as np
import pytest

from vpr_bench.errors import DataError
from vpr_bench.leaderboard.collect import cell_of, collect
from vpr_bench.leaderboard.entry import METRICS
from vpr_bench.report.rows import score_run
from vpr_bench.types.protocol import Protocol


def test_a_row_says_what_the_run_says(make_run):
    run = make_run(right=7)
    entry = collect(run)
    row = score_run(run, METRICS, resamples=2000)
    for name in METRICS:
        interval = entry.metrics[name]
        assert repr(interval.value) == repr(row.metrics[name])
        assert repr((interval.low, interval.high)) == repr(row.intervals[name])
    assert entry.right.tolist() == [True] * 7 + [False] * 3
    assert (entry.n_references, entry.n_queries, entry.n_available, entry.n_counted) == (10, 10, 10, 10)
    assert entry.cell == cell_of(run)
    assert entry.run == run.folder.name
    assert (entry.commit, entry.changed, entry.package) == ("c" * 40, True, "0.1.0")


def test_latency_is_that_of_the_stages_there_are_columns_for(make_run):
    latency = collect(make_run()).latency
    assert latency["latency_total_p50"] == pytest.approx(30)
    assert latency["latency_decode_p95"] == pytest.approx(500)
    assert not [name for name in latency if "odd" in name or "p99" in name]


def test_another_radius(make_run):
    run = make_run(right=3)
    assert collect(run, run.protocol.with_radius(5)).metrics["recall@1"].value == 1.0


def test_a_partial_run_knows_how_many_queries_there_are(make_run):
    entry = collect(make_run(asked=4))
    assert entry.partial
    assert (entry.n_queries, entry.n_available) == (4, 10)


def test_queries_without_a_match_are_not_in_right(make_run):
    run = make_run(right=10)
    run.__dict__["places"] = dataclasses.replace(run.places, queries=np.arange(10.0) + 4)
    entry = collect(run, Protocol.parse("streets/day-night@0f~reject"))
    assert entry.n_counted == len(entry.right) == 6
    assert entry.metrics["recall@1"].value == 0.0


def test_nothing_to_find_has_no_recall(make_run):
    run = make_run()
    run.__dict__["places"] = dataclasses.replace(run.places, queries=np.arange(10.0) + 100)
    entry = collect(run)
    assert math.isnan(entry.metrics["recall@1"].value)
    assert len(entry.right) == 0


@pytest.mark.parametrize(
    "change", [{"fit_seconds": math.inf}, {"created": "soon"}, {"peak_memory": {"fit": -1}}, {"future": -1}]
)
def test_a_record_that_says_nonsense_is_damaged(make_run, change):
    run = make_run()
    with pytest.raises(DataError, match="is damaged"):
        collect(dataclasses.replace(run, record=run.record.model_copy(update=change)))
