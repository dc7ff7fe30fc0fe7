import pytest

from vpr_bench.gate.cell import cell_id
from vpr_bench.gate.recording import record_cell


def test_the_digest_covers_everything_but_the_rules(store):
    cell = record_cell(store())
    assert cell.sealed() == cell
    assert cell.model_copy(update={"created": "another day"}).sealed().digest != cell.digest
    with pytest.raises(ValueError, match="digest"):
        cell.model_copy(update={"version": "2"}).check()


def test_the_same_answers_on_another_day(store):
    cell = record_cell(store())
    later = store(total=0.5, created="2027-01-01T00:00:00+00:00", elsewhere=0.9, threads=1)
    assert cell.same_answers(record_cell(later))
    assert not cell.same_answers(record_cell(store(version="2")))


def test_a_cell_is_called_by_its_protocol_and_its_method(store):
    assert cell_id("hog(cell=16, bins=9)", "x/y-z@1f") == "x/y-z@1f hog(cell=16, bins=9)"
    assert record_cell(store(label="hog")).id == "gardens/day_left-day_right@0f hog"
