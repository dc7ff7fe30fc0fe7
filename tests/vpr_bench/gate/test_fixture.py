import json
import re
import secrets
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from vpr_bench.gate.baseline import read_baseline

HOG = 'vpr_gate("hog", "tiny", parameters={"width": 32, "height": 32, "cell": 8}'


@dataclass(frozen=True)
class Outcome:
    """How a session of pytest ended, and what it printed."""

    passed: bool
    out: str


@pytest.fixture
def pytest_run(tiny_dataset, tmp_path, monkeypatch, capsys):
    """Run a test function with this body in a session of its own, in this process and the folder ``here``."""
    here = tmp_path / "here"
    here.mkdir()
    monkeypatch.chdir(here)
    (here / "pytest.ini").write_text("[pytest]\n")

    def run(body, *words):
        file = here / f"test_{secrets.token_hex(8)}.py"  # each is a module of its own
        file.write_text(f"def test_accuracy(vpr_gate):\n    {body}\n")
        plugins = ("-p", "no:vpr-bench", "-p", "vpr_bench.gate.fixture", "-p", "no:cacheprovider")  # once, if installed
        capsys.readouterr()
        code = pytest.main([*plugins, "-c", "pytest.ini", "--import-mode=importlib", str(file), *words])
        assert code in (pytest.ExitCode.OK, pytest.ExitCode.TESTS_FAILED)
        return Outcome(code == pytest.ExitCode.OK, capsys.readouterr().out)

    return run


def test_without_a_cell_it_says_how_to_record_one(pytest_run):
    assert "There is no baseline" in pytest_run(f"{HOG})").out
    assert pytest_run('vpr_gate("random", "tiny")', "--vpr-update").passed
    done = pytest_run(f"{HOG})")
    assert not done.passed
    assert re.search(r"holds no 'tiny/day_left-day_right@1f hog\(.*--vpr-update", done.out)


def test_recorded_answers_pass(pytest_run):
    assert pytest_run(f"{HOG})", "--vpr-update").passed
    assert pytest_run(f"{HOG}, exact=True, tolerance={{'recall@1': 0.0}})", "--vpr-runs", "again").passed
    assert Path("again").is_dir()


def test_a_fall_fails_with_metrics_and_queries(pytest_run):
    pytest_run(f"{HOG})", "--vpr-update")
    path = Path("baseline.json")
    cell = next(iter(read_baseline(path).cells.values()))
    better = cell.model_copy(update={"label": "random", "method": "random", "parameters": {}})
    path.write_text(read_baseline(path).with_cells([better.sealed()]).text())
    done = pytest_run('vpr_gate("random", "tiny")')
    assert not done.passed
    assert "random on tiny/day_left-day_right@1f: fail" in done.out
    assert "recall@1 fell by" in done.out
    assert "recall@1: 1.000 →" in done.out
    assert "lost: 0 (day_right/Image000.jpg" in done.out
    assert "Traceback" not in done.out


def test_ini_values_are_found_from_the_folder_of_the_file_on(pytest_run):
    Path("pytest.ini").write_text("[pytest]\nvpr_baseline = ci/accuracy.json\nvpr_runs = ci/runs\n")
    assert pytest_run(f"{HOG})", "--vpr-update").passed
    assert Path("ci", "accuracy.json").is_file()
    assert Path("ci", "runs").is_dir()


def test_recording_again_keeps_the_file(pytest_run):
    pytest_run(f"{HOG})", "--vpr-update")
    before = Path("baseline.json").read_bytes()
    assert pytest_run(f"{HOG})", "--vpr-update", "--vpr-runs", "again").passed
    assert Path("baseline.json").read_bytes() == before


def test_each_radius_and_policy_has_a_cell_of_its_own(pytest_run):
    assert pytest_run('vpr_gate("random", "tiny")', "--vpr-update").passed
    wider = 'vpr_gate("random", "tiny", protocol="day_left-day_right@4f")'
    assert not pytest_run(wider).passed
    assert pytest_run(wider, "--vpr-update").passed
    assert pytest_run(wider).passed
    assert pytest_run('vpr_gate("random", "tiny/day_left-day_right@4f~reject")', "--vpr-update").passed
    reaches = [cell.protocol.partition("@")[2] for cell in read_baseline(Path("baseline.json")).cells.values()]
    assert reaches == ["1f", "4f", "4f~reject"]
    assert len(list(Path("runs").rglob("run.json"))) == 1


def test_a_cell_is_run_with_its_own_threads(pytest_run):
    assert pytest_run('vpr_gate("random", "tiny")', "--vpr-update").passed
    path = Path("baseline.json")
    (cell,) = read_baseline(path).cells.values()
    path.write_text(read_baseline(path).with_cells([cell.model_copy(update={"threads": 1}).sealed()]).text())
    assert pytest_run('vpr_gate("random", "tiny")', "--vpr-runs", "again").passed
    (record,) = Path("again").rglob("run.json")
    assert json.loads(record.read_text())["key"]["threads"] == 1


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ('vpr_gate("hogg", "tiny")', "no method 'hogg'"),
        ('vpr_gate("random", "tinny")', "tinny"),
        ('vpr_gate("random", "tiny", protocol="a-b")', "a-b"),
        ('vpr_gate("random", "tiny", seed=3)', "has seed 0. Got 3 instead"),
        ('vpr_gate("random", "tiny", k=3)', "has k 12. Got 3 instead"),
        ('vpr_gate("random", "tiny", tolerance={"auc": 1})', "no metric 'auc'"),
        (
            'vpr_gate("random", "tiny", tolerance=0.1)',
            "tolerance is {metric: drop}, such as {'recall@1': 0.02}. Got 0.1",
        ),
        ('vpr_gate("random", "tiny", tolerance=0)', "tolerance is {metric: drop}"),
        ('vpr_gate("random", "tiny", parameters=["cell"])', "parameters is {name: value}"),
        ('vpr_gate("random", 3)', "dataset is the name of a dataset"),
        ('vpr_gate("random", "tiny", seed="0")', "seed is a whole number. Got '0'"),
    ],
)
def test_mistakes_are_told_in_a_line(pytest_run, body, said):
    assert pytest_run('vpr_gate("random", "tiny")', "--vpr-update").passed
    done = pytest_run(body)
    assert not done.passed
    assert said in done.out
    assert "vpr_bench/" not in done.out
    assert "During handling" not in done.out


def test_other_images_fail(pytest_run, tiny_dataset):
    assert pytest_run('vpr_gate("random", "tiny")', "--vpr-update").passed
    first, second = (tiny_dataset.folder / "day_right" / f"Image00{number}.jpg" for number in (0, 1))
    first.write_bytes(second.read_bytes())
    done = pytest_run('vpr_gate("random", "tiny")')
    assert not done.passed
    assert "the images are others: sha256:" in done.out


def test_the_plugin_is_light():
    code = "import sys, vpr_bench.gate.fixture; print(*{'numpy', 'pydantic', 'scipy', 'rich'} & sys.modules.keys())"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []
