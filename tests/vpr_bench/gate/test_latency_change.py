import pytest

from vpr_bench.gate.latency_change import latency_change
from vpr_bench.gate.recording import record_cell


@pytest.fixture
def cells(store):
    def make(total, **facts):
        return record_cell(store()), record_cell(store(total=total, version="2", **facts))

    return make


def test_a_slower_run_on_the_same_machine_fails(cells):
    change = latency_change(*cells(0.06), limit=1.5)
    assert change.ratio == pytest.approx(2)
    assert change.fault is not None
    assert "2.00 times as long (30 → 60 ms): 1.5 times is allowed" in change.fault


@pytest.mark.parametrize("limit", [None, 2.5])
def test_what_is_allowed_does_not_fail(cells, limit):
    assert latency_change(*cells(0.06), limit).fault is None


@pytest.mark.parametrize(
    ("facts", "doubt"),
    [
        ({"elsewhere": 0.5}, "other processes took 50%"),
        ({"elsewhere": None}, "was not noted during the run"),
        ({"machine": "another"}, "different machines"),
    ],
)
def test_times_that_cannot_be_compared_never_fail(cells, machine, facts, doubt):
    if "machine" in facts:
        facts = {"machine": machine.model_copy(update={"cores": 64})}
    change = latency_change(*cells(3.0, **facts), limit=1.1)
    assert change.fault is None
    assert doubt in change.doubt
    assert change.as_dict()["judged"] is False
