from pathlib import Path

import pytest

from vpr_bench.dataset.load import load_case
from vpr_bench.errors import DataError, UsageError
from vpr_bench.gate.recording import record_cell
from vpr_bench.gate.rerun import Sources, run_cell, run_cells
from vpr_bench.method.build import build_method
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.store import RunStore
from vpr_bench.types.protocol import Protocol

SMALL = {"width": 32, "height": 32, "cell": 8}


@pytest.fixture
def recorded(tiny_dataset, tmp_path):
    built = build_method("hog", SMALL, 7)
    options = RunOptions(seed=7, k=4, threads=1)
    return run(load_case("tiny"), built, RunStore(tmp_path / "then"), options)


def test_a_cell_is_run_exactly_as_it_was_recorded(recorded, tmp_path):
    again = run_cell(record_cell(recorded), tmp_path / "now", Sources())
    assert again.record.key == recorded.record.key
    assert record_cell(again).answers == record_cell(recorded).answers


def test_what_is_stored_is_not_run_again(recorded, tmp_path):
    before = (recorded.folder / "run.json").stat().st_mtime_ns
    again = run_cell(record_cell(recorded), tmp_path / "then", Sources())
    assert again.folder == recorded.folder
    assert (recorded.folder / "run.json").stat().st_mtime_ns == before


def test_a_cell_of_another_radius_needs_no_run_of_its_own(recorded, tmp_path):
    wider = record_cell(recorded, Protocol.parse("tiny/day_left-day_right@3f"))
    again = run_cell(wider, tmp_path / "then", Sources())
    assert again.folder == recorded.folder
    assert again.protocol == wider.asked


def test_other_images_are_refused_before_anything_is_run(recorded, tmp_path):
    cell = record_cell(recorded).model_copy(update={"dataset": "sha256:" + "1" * 64})
    with pytest.raises(DataError, match=r"the images are others: sha256:1+ in the baseline, sha256:"):
        run_cell(cell, tmp_path / "now", Sources())
    assert not (tmp_path / "now").exists()


def test_code_is_not_run_because_a_baseline_names_it(recorded, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("bad.py").write_text("raise SystemError('was run')\nclass Bad: ...\n")
    cell = record_cell(recorded).model_copy(update={"method": "bad.py:Bad", "label": "bad.py:Bad", "parameters": {}})
    with pytest.raises(UsageError, match="say where it is with --trust"):
        run_cell(cell, tmp_path / "now", Sources())
    with pytest.raises(UsageError, match="was run"):
        run_cell(cell, tmp_path / "now", Sources(methods={"bad.py:Bad": "bad.py:Bad"}))


def test_methods_inside_are_found_where_the_user_says(tiny_dataset, tmp_path, monkeypatch):
    file = tmp_path / "methods" / "mine.py"
    file.parent.mkdir()
    file.write_text("from vpr_baselines.sequence.seqslam import SeqSlam\nfrom vpr_baselines.hog import Hog\n")
    outer, inner = f"{file}:SeqSlam", f"{file}:Hog"
    small = {f"inner.{name}": value for name, value in SMALL.items()}
    built = build_method(outer, {"past": 3, "inner": inner, **small})
    then = run(load_case("tiny"), built, RunStore(tmp_path / "then"), RunOptions(threads=1))
    cell, places = record_cell(then), {"mine.py:SeqSlam": outer, "mine.py:Hog": inner}
    assert run_cell(cell, tmp_path / "now", Sources(places)).record.key == then.record.key
    for name in places:
        with pytest.raises(UsageError, match="not installed"):
            run_cell(cell, tmp_path / "now", Sources({name: places[name]}))


def test_a_method_that_is_called_otherwise_now(recorded, tmp_path):
    cell = record_cell(recorded).model_copy(update={"label": "hog(cells=8)"})
    with pytest.raises(UsageError, match="is now called"):
        run_cell(cell, tmp_path / "now", Sources())


def test_one_that_cannot_be_run_hides_no_other(recorded, tmp_path):
    cell = record_cell(recorded)
    gone = cell.model_copy(update={"method": "nosuch", "label": "nosuch"})
    runs, errors = run_cells([gone, cell], tmp_path / "now", Sources())
    assert len(runs) == 1
    assert [(one.label, one.outcome) for one in errors] == [("nosuch", "error")]
    assert "There is no method 'nosuch'" in errors[0].reasons[0]


def test_images_of_ones_own_are_found_where_they_are_said_to_be(tiny_images, tmp_path):
    case = load_case(str(tiny_images), "day_left-day_right")
    then = run(case, build_method("hog", SMALL), RunStore(tmp_path / "then"))
    sources = Sources(folders={case.protocol.dataset: str(tiny_images)})
    assert run_cell(record_cell(then), tmp_path / "then", sources).folder == then.folder
