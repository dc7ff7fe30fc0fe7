import json
import shutil
import xml.etree.ElementTree as ET
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from vpr_bench.files.atomic import read_arrays, write_arrays
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.runner.record import RunKey

SMALL = ("--param", "width=32", "--param", "height=32", "--param", "cell=8")
LABEL = "hog(width=32, height=32, cell=8)"
BASELINE = Path("baseline.json")


@pytest.fixture
def recorded(vpr_bench, tiny_dataset):
    """Return the folder of the run that the baseline was recorded from."""
    assert vpr_bench("run", "--method", "hog", *SMALL, "--dataset", "tiny").code == 0
    assert vpr_bench("gate", "--update").code == 0
    return next(Path("runs").rglob("run.json")).parent


def answer_otherwise(folder, queries):
    """Let the stored run answer some queries with the reference five places on."""
    matches = read_arrays(folder / "matches.npz")
    matches["indices"][queries] = (matches["indices"][queries] + 5) % 12
    write_arrays(folder / "matches.npz", matches)
    record = json.loads((folder / "run.json").read_text())
    record["files"]["matches.npz"] = sha256_of_file(folder / "matches.npz")
    (folder / "run.json").write_text(json.dumps(record))


def edit_record(folder, **facts):
    """Change the key of a run, and the name of its folder with it."""
    record = json.loads((folder / "run.json").read_text())
    record["key"] |= facts
    (folder / "run.json").write_text(json.dumps(record))
    folder.replace(folder.with_name(RunKey(**record["key"]).digest()))


def test_recording_and_judging(vpr_bench, recorded):
    done = vpr_bench("gate")
    assert done.code == 0
    assert "1 passed" in done.out
    assert "tiny/day_left-day_right@1f" in done.out


def test_updating_again_changes_nothing(vpr_bench, recorded):
    before = BASELINE.stat().st_mtime_ns
    done = vpr_bench("gate", "--update")
    assert (done.code, done.err) == (0, "baseline.json: unchanged\n")
    assert BASELINE.stat().st_mtime_ns == before


def test_ten_repeated_runs_never_fail(vpr_bench, recorded):
    for number in range(10):
        done = vpr_bench("gate", "--run", "--exact", "--runs", f"again{number}", "--tolerance", "recall@1=0")
        assert done.code == 0, done.out


def test_what_fell_is_named(vpr_bench, recorded):
    answer_otherwise(recorded, [3, 4])
    done = vpr_bench("gate", "--exact", "--junit", "gate.xml", "--markdown", "gate.md")
    assert done.code == 1
    assert "recall@1 fell by 0.167" in done.out
    assert "day_right/Image003.jpg" in done.out
    assert ET.parse("gate.xml").getroot().get("failures") == "1"  # noqa: S314 - it is our own
    assert "Image004.jpg" in Path("gate.md").read_text("utf-8")
    cell = json.loads(vpr_bench("gate", "--format", "json").out)["cells"][0]
    assert [one["query"] for one in cell["changed"]] == [3, 4]
    assert cell["lost"] == [{"query": query, "name": f"day_right/Image00{query}.jpg"} for query in (3, 4)]


def test_a_drop_that_is_allowed_passes(vpr_bench, recorded):
    answer_otherwise(recorded, [3])
    words = ("gate", "--tolerance", "recall@1=0.5", "--tolerance", "pr_auc=0.5", "--significance", "0")
    assert vpr_bench(*words).code == 0
    assert vpr_bench("gate").code == 1


def test_rules_are_written_with_an_update_and_not_without(vpr_bench, recorded):
    vpr_bench("gate", "--tolerance", "recall@5=0.1")
    assert "recall@5" not in json.loads(BASELINE.read_text())["rules"]["metrics"]
    assert vpr_bench("gate", "--update", "--tolerance", "recall@5=0.1", "--exact").code == 0
    rules = json.loads(BASELINE.read_text())["rules"]
    assert rules["metrics"]["recall@5"] == {"tolerance": 0.1}
    assert rules["exact"] is True


def test_an_update_shows_what_it_changes(vpr_bench, recorded):
    answer_otherwise(recorded, [3, 4])
    done = vpr_bench("gate", "--update")
    assert done.code == 0
    assert "1 recorded anew" in done.err
    assert "-2 +0" in done.out
    assert vpr_bench("gate", "--exact").code == 0


def test_a_missing_run_fails_and_run_makes_it(vpr_bench, recorded):
    vpr_bench("run", "--method", "random", "--dataset", "tiny")
    assert vpr_bench("gate", "--update").code == 0
    shutil.rmtree(recorded)
    done = vpr_bench("gate")
    assert done.code == 1
    assert "there is no run of it: --run makes one" in done.out
    assert "missing" not in vpr_bench("gate", "--method", "random").out
    assert vpr_bench("gate", "--run", "--exact").code == 0
    assert recorded.is_dir()


def test_a_damaged_run_is_done_again_by_run(vpr_bench, recorded):
    (recorded / "matches.npz").write_bytes(b"")
    assert vpr_bench("gate", "--run").code == 0


def test_what_can_be_done_is_said(vpr_bench, recorded):
    vpr_bench("run", "--method", "random", "--dataset", "tiny")
    assert "--update records it" in vpr_bench("gate").err
    assert "--update records it" not in vpr_bench("gate", "--update").err


def test_reports_are_written_into_new_folders_after_the_verdict(vpr_bench, recorded):
    assert vpr_bench("gate", "--junit", "a/b/gate.xml", "--markdown", "c/gate.md").code == 0
    assert Path("a/b/gate.xml").exists() and Path("c/gate.md").exists()
    done = vpr_bench("gate", "--junit", "baseline.json/gate.xml")
    assert (done.code, "1 passed" in done.out) == (3, True)


def test_what_is_run_and_what_is_stored_is_said(vpr_bench, recorded):
    assert f"{LABEL} on tiny/day_left-day_right@1f: stored already" in vpr_bench("gate", "--run").err
    again = vpr_bench("gate", "--run", "--runs", "again")
    assert f"{LABEL} on tiny/day_left-day_right@1f: running" in again.err


def test_a_damaged_run_is_one_entry(vpr_bench, recorded):
    (recorded / "run.json").write_text("{")
    cells = json.loads(vpr_bench("gate", "--format", "json").out)["cells"]
    assert [(one["method"], one["verdict"]) for one in cells] == [(LABEL, "error")]
    assert cells[0]["reasons"][0].startswith("its run is damaged: ")


def test_a_gate_that_judges_nothing_is_not_green(vpr_bench, tiny_dataset):
    assert vpr_bench("run", "--method", "random", "--dataset", "tiny", "--limit", "3", "-o", "part").code == 0
    words = ("gate", "--runs", "part")
    done = vpr_bench(*words, "--update")
    assert done.code == 3
    assert "a baseline needs all queries" in done.err
    assert "skipped" in done.out
    assert not BASELINE.exists()
    BASELINE.write_text('{"schema_version": 1, "cells": {}}')
    done = vpr_bench(*words)
    assert (done.code, "holds no cells" in done.err) == (3, True)
    assert vpr_bench(*words, "--update").code == 3
    assert vpr_bench("run", "--method", "random", "--dataset", "tiny", "-o", "part").code == 0
    assert vpr_bench(*words, "--update").code == 0
    assert vpr_bench(*words).code == 0


def test_pruning(vpr_bench, recorded):
    vpr_bench("run", "--method", "random", "--dataset", "tiny")
    vpr_bench("gate", "--update")
    shutil.rmtree(recorded)
    assert len(json.loads(BASELINE.read_text())["cells"]) == 2
    vpr_bench("gate", "--update")
    assert len(json.loads(BASELINE.read_text())["cells"]) == 2
    assert "1 dropped" in vpr_bench("gate", "--update", "--prune").err
    assert list(json.loads(BASELINE.read_text())["cells"]) == ["tiny/day_left-day_right@1f random"]


@pytest.mark.parametrize("update", [(), ("--update",)])
@pytest.mark.parametrize(
    ("harm", "said"),
    [
        (lambda run: (run / "matches.npz").unlink(), "matches.npz is missing"),
        (lambda run: (run / "run.json").write_text("{"), "run.json is damaged"),
        (lambda run: (run / "run.json").write_text('{"schema_version": 99}'), "schema version 99"),
        (lambda run: edit_record(run, dataset_digest="sha256:" + "1" * 64), "the images are others: sha256:"),
        (lambda run: shutil.rmtree("runs"), "There are no runs under runs"),
        (lambda run: BASELINE.write_text("{"), "baseline.json is damaged"),
        (lambda run: BASELINE.write_text(BASELINE.read_text().replace('"k": 12', '"k": 11')), "digest is another one"),
    ],
    ids=range(7),
)
def test_bad_input_is_told_and_nothing_is_overwritten(vpr_bench, recorded, harm, said, update):
    harm(recorded)
    before = BASELINE.read_bytes()
    done = vpr_bench("gate", *update)
    assert done.code == 3
    assert said in " ".join((done.out + done.err).split())
    assert "Traceback" not in done.out + done.err
    assert BASELINE.read_bytes() == before


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("--baseline", "none.json"), 3, "Record one with `vpr-bench gate --baseline none.json --update`"),
        (("--prune",), 2, "--update"),
        (("--method", "hogg"), 2, "Did you mean 'hog'"),
        (("--dataset", "nordland"), 2, "'nordland'"),
        (("--protocol", "a-b"), 2, "'a-b'"),
        (("--tolerance", "recall@1"), 2, "A tolerance is written metric=drop. Got 'recall@1'"),
        (("--trust", "mine"), 2, "no method 'mine'"),
        (("--junit", "runs"), 2, "is a directory"),
        (("--tolerance", "recall@1=much"), 2, "metric=drop"),
        (("--tolerance", "auc=0.1"), 2, "no metric 'auc'"),
        (("--significance", "2"), 2, "Got 2"),
        (("--runs", "empty"), 3, "There are no runs under empty"),
        (("--markdown", "baseline.json/gate.md"), 3, "baseline.json is in the way"),
    ],
    ids=str,
)
def test_errors(vpr_bench, recorded, words, code, said):
    done = vpr_bench("gate", *words)
    assert done.code == code
    assert said in done.err


def test_nothing_is_recorded_where_there_are_no_runs(vpr_bench):
    assert vpr_bench("gate", "--update").code == 3
    assert not BASELINE.exists()


@pytest.mark.parametrize("form", ["table", "json", "junit", "markdown"])
def test_stdout_holds_the_result_alone(vpr_bench, recorded, form):
    done = vpr_bench("gate", "--run", "--runs", "again", "--format", form)
    assert done.code == 0
    assert f"{LABEL} on tiny" not in done.out
    assert f"{LABEL} on tiny" in done.err
    if form == "json":
        assert json.loads(done.out)["passed"] is True
    if form == "junit":
        assert ET.fromstring(done.out.encode()).get("tests") == "1"  # noqa: S314 - it is our own


def test_a_method_of_ones_own_is_run_if_it_is_named(vpr_bench, recorded):
    Path("mine.py").write_text(
        "import numpy as np\n"
        "from vpr_bench import Match\n\n\n"
        "class Mine:\n"
        "    def fit(self, references):\n"
        "        self.n_ = len(references)\n\n"
        "    def match(self, image, k):\n"
        "        return Match.from_scores(-np.arange(float(self.n_)), k)\n"
    )
    assert vpr_bench("run", "--method", "mine.py:Mine", "--dataset", "tiny").code == 0
    assert vpr_bench("gate", "--update").code == 0
    done = vpr_bench("gate", "--run", "--runs", "again")
    assert done.code == 2
    assert "say where it is with --trust" in " ".join(done.out.split())
    assert "2 passed" in vpr_bench("gate", "--run", "--runs", "again", "--trust", "mine.py:Mine").out
    assert vpr_bench("gate", "--run", "--runs", "again", "--method", "mine.py:Mine").code == 0
    Path("mine.py").write_text(Path("mine.py").read_text().replace("-np.arange", "np.arange"))
    done = vpr_bench("gate", "--run", "--runs", "again", "--method", "mine.py:Mine", "--exact")
    assert done.code == 1
    assert "12 of 12 queries" in done.out
    assert "version of the method" in done.out


def test_a_folder_of_ones_own(vpr_bench, tiny_images):
    run = ("run", "--method", "random", "--dataset", str(tiny_images), "--protocol", "day_left-day_right")
    assert vpr_bench(*run).code == 0
    assert vpr_bench("gate", "--update").code == 0
    words = ("gate", "--run", "--runs", "again", "--exact")
    assert vpr_bench(*words).code == 2  # where the folder is, the baseline does not say
    assert vpr_bench(*words, "--dataset", str(tiny_images)).code == 0


def test_random_answers_of_another_seed_are_another_cell(vpr_bench, recorded):
    assert vpr_bench("run", "--method", "random", "--dataset", "tiny", "--seed", "5").code == 0
    assert vpr_bench("gate", "--update").code == 0
    assert json.loads(BASELINE.read_text())["cells"]["tiny/day_left-day_right@1f random"]["seed"] == 5
    assert np.all([vpr_bench("gate", "--run", "--runs", "again", "--exact").code == 0 for _ in range(2)])


def test_a_cell_of_another_radius_is_added_by_its_name(vpr_bench, recorded):
    wider = ("--protocol", "day_left-day_right@4f")
    judged = vpr_bench("gate", *wider)
    assert (judged.code, "1 new, 1 not asked about, nothing was judged" in judged.out) == (1, True)
    done = vpr_bench("gate", "--update", *wider)
    assert (done.code, done.err) == (0, "baseline.json: 1 added\n")
    ids = [f"tiny/day_left-day_right@{reach} {LABEL}" for reach in ("1f", "4f")]
    assert list(json.loads(BASELINE.read_text())["cells"]) == ids
    for words in ((), wider, (*wider, "--run"), ("--run", "--runs", "again"), ("--update",)):
        done = vpr_bench("gate", *words)
        assert done.code == 0
        assert "new" not in done.out
    assert "2 passed" in done.out


def test_the_real_images_only(vpr_bench, recorded):
    vpr_bench("run", "--method", "hog", *SMALL, "--dataset", "tiny:simulated")
    assert vpr_bench("gate", "--update").code == 0
    assert "2 passed" in vpr_bench("gate", "--dataset", "tiny").out
    assert "1 passed, 1 not asked about" in vpr_bench("gate", "--dataset", "tiny:real").out


def test_cells_that_another_process_adds_meanwhile_are_kept(vpr_bench, recorded, monkeypatch):
    vpr_bench("run", "--method", "random", "--dataset", "tiny")
    before = BASELINE.read_text()
    vpr_bench("gate", "--update")
    with_random = BASELINE.read_text()
    BASELINE.write_text(before)

    @contextmanager
    def waited(*_):
        BASELINE.write_text(with_random)
        yield

    monkeypatch.setattr("vpr_bench.gate.baseline.held", waited)
    answer_otherwise(recorded, [3])
    assert vpr_bench("gate", "--update", "--method", "hog").code == 0
    cells = json.loads(BASELINE.read_text())["cells"]
    assert len(cells) == 2
    assert BASELINE.read_text() != with_random


def test_a_metric_that_needs_more_answers_than_were_kept_fails(vpr_bench, tiny_dataset):
    assert vpr_bench("run", "--method", "hog", *SMALL, "--dataset", "tiny", "--k", "4").code == 0
    assert vpr_bench("gate", "--update").code == 0
    done = vpr_bench("gate", "--tolerance", "recall@5=0")
    assert done.code == 1
    assert "it needs more answers than the 4 that were kept (--k)" in " ".join(done.out.split())
