import pytest

from vpr_bench.gate.damaged import DamagedRun
from vpr_bench.gate.recording import record_cell


@pytest.fixture
def cell(store, elsewhere):
    return record_cell(store(label="hog(cell=8)", root=elsewhere))


def test_a_whole_run_is_not_damaged(store):
    assert DamagedRun.at(store().folder) is None


def test_it_is_known_by_its_record(store, cell):
    run = store(label="hog(cell=8)")
    (run.folder / "matches.npz").unlink()
    damaged = DamagedRun.at(run.folder)
    assert damaged.cell([cell]) == cell
    assert damaged.cell([cell.model_copy(update={"seed": 7})]) is None
    verdict = damaged.verdict()
    assert (verdict.label, verdict.protocol, verdict.exit_code) == (cell.label, cell.protocol, 3)
    assert "its run is damaged: " in verdict.reasons[0]


def test_without_a_record_it_is_known_by_its_folder_if_that_tells(store, cell):
    run = store(label="hog(cell=8)", protocol="gardens:simulated/day_left-day_right@0f")
    (run.folder / "run.json").write_text("{")
    damaged = DamagedRun.at(run.folder)
    mine = cell.model_copy(update={"protocol": "gardens:simulated/day_left-day_right@3f"})
    assert damaged.cell([cell]) is None
    assert damaged.cell([cell, mine]) == mine
    assert damaged.cell([mine, mine.model_copy(update={"seed": 7})]) is None
    assert damaged.verdict().label == "a stored run"


def test_one_of_another_version_is_not_called_damaged(store):
    run = store()
    record = run.folder / "run.json"
    record.write_text(record.read_text().replace('"schema_version":2', '"schema_version":99'))
    verdict = DamagedRun.at(run.folder).verdict("made-up", "a/b-c@1f")
    assert "its run cannot be read: " in verdict.reasons[0]
