import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.compare.speed import compare_speed, signed_rank_p_value
from vpr_bench.errors import DataError
from vpr_bench.runner.provenance import Provenance

TIMES = np.linspace(0.01, 0.02, 8)


def test_ratios_of_the_stages_that_both_noted(stored):
    first = stored(seconds={"decode": 1.0, "encode": TIMES, "match": TIMES, "total": 2 * TIMES})
    second = stored(seconds={"decode": 9.0, "encode": 3 * TIMES, "rerank": TIMES, "total": 5 * TIMES})
    speed = compare_speed(first, second, resamples=50)
    assert [one.stage for one in speed.stages] == ["encode", "total"]
    total = speed.stages[1]
    assert total.ratio.value == pytest.approx(2.5) and total.ratio.low == pytest.approx(2.5)
    assert (total.first_ms, total.second_ms) == (pytest.approx(30), pytest.approx(75))
    assert total.significant and total.p_value == pytest.approx(2 / 2**8)
    assert speed.refused == "" and list(speed.doubts) == []


def test_equal_times_are_not_told_apart(stored):
    speed = compare_speed(stored(), stored(label="sad"), resamples=20)
    assert all(one.ratio.value == 1 and not one.significant and one.p_value == 1 for one in speed.stages)


def test_stages_of_ones_own_stand_before_the_total(stored):
    times = dict.fromkeys(["total", "warp", "rerank", "encode", "blur"], 0.5)
    speed = compare_speed(stored(seconds=times), stored(seconds=times, label="sad"), resamples=5)
    assert [one.stage for one in speed.stages] == ["encode", "rerank", "blur", "warp", "total"]


@pytest.mark.parametrize("changes", [{"processor": "Other"}, {"threads": 1}, {"memory_bytes": 2**34}])
def test_another_machine_is_not_compared(stored, changes):
    first = stored()
    machine = first.record.machine.model_copy(update=changes)
    speed = compare_speed(first, stored(machine=machine))
    assert speed.stages == () and str(first.record.machine) in speed.refused and str(machine) in speed.refused


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        (
            {"provenance": Provenance(elsewhere=0.35)},
            "other processes took 35% of the machine's processor time during B",
        ),
        ({"provenance": Provenance()}, "what else the machine did was not noted during B"),
        ({"record": {"resumed": True}}, "B was interrupted and continued"),
    ],
)
def test_what_speaks_against_trusting_the_times(stored, changes, said):
    doubts = compare_speed(stored(), stored(label="sad", **changes), resamples=5).doubts
    assert len(doubts) == 1 and doubts[0].startswith(said)


def test_a_stage_that_took_no_time_has_no_ratio(stored):
    times = {"encode": 0.0, "total": 0.1}
    stage = compare_speed(stored(seconds=times), stored(seconds=times, label="sad"), resamples=5).stages[0]
    assert np.isnan(stage.ratio.value) and np.isnan(stage.p_value) and not stage.significant


@pytest.mark.parametrize("bad", [-1.0, float("nan"), float("inf")])
def test_impossible_times_are_damage(stored, bad):
    wrong = stored(seconds={"total": [bad, *[0.1] * 7]}, label="sad")
    with pytest.raises(DataError, match=f"{wrong.folder} is damaged"):
        compare_speed(stored(), wrong)


@given(st.lists(st.tuples(st.floats(1e-6, 10), st.floats(1e-6, 10)), max_size=30))
def test_swapping_the_runs_leaves_the_p_value(pairs):
    first, second = np.array(pairs, dtype=float).reshape(-1, 2).T
    there, back = signed_rank_p_value(first, second), signed_rank_p_value(second, first)
    assert there == pytest.approx(back, nan_ok=True)
    assert np.isnan(there) == (len(pairs) == 0)
