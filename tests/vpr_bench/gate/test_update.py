import pytest

from vpr_bench.errors import DataError
from vpr_bench.gate import Baseline, Overrides, Rule, Rules, record_cell, updated
from vpr_bench.gate.matching import asked_for
from vpr_bench.types.protocol import Protocol

ID = "gardens/day_left-day_right@0f made-up"


@pytest.fixture
def old(store, tmp_path):
    cells = [record_cell(store(root=tmp_path / "old", label=label)) for label in ("made-up", "other")]
    cells[0] = cells[0].model_copy(update={"rules": Rules(metrics={"recall@1": Rule(tolerance=0.5)})})
    return Baseline().with_cells(cells)


def test_a_repeated_run_changes_nothing(old, store):
    update = updated(old, [store(total=0.9, created="2027-01-01T00:00:00+00:00", threads=1)])
    assert update.baseline == old
    assert (update.recorded, update.added, update.dropped) == ([], [], [])


def test_other_answers_are_recorded_and_the_cells_rules_kept(old, store, made_up_answers, shift):
    indices, scores = made_up_answers()
    update = updated(old, [store(shift(indices, [3]), scores)])
    assert update.recorded == [ID]
    assert update.baseline.cells[ID].answered.best[3] == (indices[3, 0] + 30) % 200
    assert update.baseline.cells[ID].rules == old.cells[ID].rules
    update.baseline.cells[ID].check()


def test_new_ones_are_added_and_those_not_run_are_kept(old, store):
    update = updated(old, [store(), store(label="fresh")])
    assert update.added == ["gardens/day_left-day_right@0f fresh"]
    assert update.baseline.cells.keys() == {*old.cells, *update.added}
    assert list(update.baseline.cells) == sorted(update.baseline.cells)


def test_pruning_drops_what_was_asked_about_and_not_run(old, store):
    assert updated(old, [store()], prune=True).dropped == ["gardens/day_left-day_right@0f other"]
    assert updated(old, [], only=[ID], prune=True).dropped == [ID]


def test_no_baseline_without_cells_is_made(old):
    for baseline, prune in ((old, True), (Baseline(), False)):
        with pytest.raises(DataError, match="There is nothing to record"):
            updated(baseline, [], prune=prune)


def test_overrides_become_rules(old, store):
    update = updated(old, [store()], Overrides({"recall@3": 0.1}))
    assert update.baseline.rules.metrics["recall@3"] == Rule(tolerance=0.1)
    assert "recall@3" in update.baseline.cells[ID].metrics
    assert update.recorded == [ID]


def test_times_are_recorded_anew_where_they_are_judged_and_moved(old, store):
    slower, other = store(total=0.9), store(total=0.031, threads=1)
    assert updated(old, [slower], Overrides(latency_ratio=1.5)).recorded == [ID]
    assert updated(old, [other], Overrides(latency_ratio=1.5)).recorded == []


def test_a_second_radius_that_was_named_is_added(old, store):
    wider = asked_for(store(), Protocol.parse("gardens/day_left-day_right@3f"))
    assert updated(old, [wider]).added == []
    update = updated(old, [wider], only=[], named=True)
    assert update.added == ["gardens/day_left-day_right@3f made-up"]
    assert update.baseline.cells[ID] == old.cells[ID]
    assert updated(update.baseline, [wider], named=True).baseline == update.baseline
