import json
from pathlib import Path

import numpy as np
import pytest

from vpr_bench.files.digest import sha256_of_file

SMALL = ("--param", "width=32", "--param", "height=32", "--param", "cell=8")
TINY = ("run", "--method", "hog", *SMALL, "--dataset", "tiny")


@pytest.fixture
def folder(vpr_bench, tiny_dataset):
    assert vpr_bench(*TINY).code == 0
    return next(Path("runs").rglob("run.json")).parent


def test_show_lists_all(vpr_bench, folder):
    done = vpr_bench("show")
    assert done.code == 0
    assert "hog(width=32, height=32, cell=8)" in done.out


@pytest.mark.parametrize("name", [lambda folder: str(folder), lambda folder: folder.name[:5]])
def test_show_one_with_its_details(vpr_bench, folder, name):
    done = vpr_bench("show", name(folder))
    assert done.code == 0
    assert "version 1" in done.out
    assert "cores" in done.out


def test_score_needs_neither_images_nor_method(vpr_bench, folder, tiny_dataset):
    tiny_dataset.without_images()
    done = vpr_bench("score", "--radius", "0,3", "--metric", "recall@1", "--format", "json")
    rows = json.loads(done.out)
    assert [row["protocol"].partition("@")[2] for row in rows] == ["0f", "3f"]
    assert rows[0]["metrics"]["recall@1"] <= rows[1]["metrics"]["recall@1"]


def test_score_computes_every_metric_by_default(vpr_bench, folder):
    metrics = json.loads(vpr_bench("score", "--format", "json").out)[0]["metrics"]
    assert {"pr_auc", "pr_auc_matched", "average_precision", "recall@10", "roc_auc"} <= metrics.keys()


def test_show_and_score_write_nothing(vpr_bench, folder):
    before = {file: file.stat().st_mtime_ns for file in folder.iterdir()}
    vpr_bench("score", "--radius", "0")
    vpr_bench("show", str(folder))
    assert {file: file.stat().st_mtime_ns for file in folder.iterdir()} == before


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("show", "zzzz"), 2, "neither a run's folder nor"),
        (("show", "0123456789ab"), 2, "no run begins with"),
        (("show", "/"), 2, "neither a run's folder nor"),
        (("show", "--output", "nowhere"), 3, "There are no runs under nowhere"),
        (("score", "--metric", "auc"), 2, "There is no metric 'auc'"),
        (("score", "--radius", "-3"), 2, "Got '-3'"),
    ],
)
def test_errors(vpr_bench, folder, words, code, said):
    done = vpr_bench(*words)
    assert done.code == code
    assert said in done.err


def test_damaged_run(vpr_bench, folder):
    (folder / "matches.npz").write_bytes(b"")
    done = vpr_bench("score", str(folder))
    assert done.code == 3
    assert "matches.npz is damaged" in done.err


def test_a_run_that_cannot_be_scored_hides_no_other(vpr_bench, folder):
    assert vpr_bench(*TINY, "--seed", "1").code == 0
    arrays = {"queries": np.zeros(2), "references": np.arange(12.0)}
    np.savez(folder / "labels.npz", **arrays)
    record = json.loads((folder / "run.json").read_text())
    record["files"]["labels.npz"] = sha256_of_file(folder / "labels.npz")
    (folder / "run.json").write_text(json.dumps(record))
    done = vpr_bench("show", "--format", "json")
    assert done.code == 3
    assert str(folder) in done.err
    assert len(json.loads(done.out)) == 1


def test_a_sweep_leaves_the_stored_protocol_alone(vpr_bench, folder):
    assert vpr_bench(*TINY, "--radius", "0,3", "--overwrite", "always").code == 0
    assert "tiny/day_left-day_right@1f" in vpr_bench("show").out


def test_a_sweep_is_a_table_of_radii(vpr_bench, folder):
    done = vpr_bench("score", "--radius", "0..3,5", "--metric", "recall@1")
    assert done.code == 0
    heads = [line.split()[2:] for line in done.out.splitlines() if line.startswith("radius (f)")]
    assert heads == [["0", "1", "2", "3", "5"]]
    text = vpr_bench("score", "--radius", "0..3,5", "--metric", "recall@1", "--format", "markdown").out
    assert "| radius (f) | 0 | 1 | 2 | 3 | 5 |" in text
    rows = json.loads(vpr_bench("score", "--radius", "0..3,5", "--format", "json").out)
    assert [row["radius"] for row in rows] == [0, 1, 2, 3, 5]


def test_a_sweep_of_several_runs_is_drawn(vpr_bench, folder):
    assert vpr_bench(*TINY, "--seed", "1").code == 0
    done = vpr_bench("score", "--radius", "0..3", "--plot", "radius.png", "--format", "json")
    assert done.code == 0 and len(json.loads(done.out)) == 8
    assert "radius.png" in done.err and Path("radius.png").read_bytes().startswith(b"\x89PNG")


def test_markdown(vpr_bench, folder):
    assert vpr_bench("show", "--format", "markdown").out.startswith("| method | run | protocol | recall@1 |")


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("score", "--plot", "radius.png"), 2, "give several"),
        (("score", "--radius", "0,1", "--plot", "radius.gif"), 2, "must end in .png or .svg"),
        (("score", "--radius", "0,1", "--plot", "nowhere/radius.png"), 3, "there is no folder nowhere"),
        (("score", "--radius", "3..1"), 2, "A range of radii goes up"),
        (("score", "--radius", "0..999999999"), 2, "A range of radii goes up"),
        (("score", "--radius", "-1..2"), 2, "Got '-1..2'"),
        (("show", "--plot-stages", "lost.png"), 2, "nothing to draw"),
        (("show", "--plot-stages", "lost.txt"), 2, "must end in .png or .svg"),
    ],
)
def test_pictures_that_cannot_be_drawn(vpr_bench, folder, words, code, said):
    done = vpr_bench(*words)
    assert done.code == code and said in done.err and "Traceback" not in done.err


def test_losses_of_a_method_that_notes_its_shortlists(vpr_bench, tiny_dataset):
    Path("narrowing.py").write_text(
        "import numpy as np\n"
        "from vpr_bench.shortlist import shortlist\n"
        "from vpr_bench.types.match import Match\n"
        "class Narrowing:\n"
        "    def fit(self, references): pass\n"
        "    def match(self, image, k):\n"
        "        shortlist('coarse', np.arange(6))\n"
        "        return Match(np.arange(k), -np.arange(k))\n"
    )
    done = vpr_bench("run", "--method", "narrowing.py:Narrowing", "--dataset", "tiny")
    assert "lost the right place by: coarse" in done.out
    stored = str(next(Path("runs").rglob("run.json")).parent)
    done = vpr_bench("show", stored, "--plot-stages", "lost.png")
    assert done.code == 0 and "right place among them" in done.out and Path("lost.png").exists()
    tiny_dataset.without_images()
    rows = json.loads(vpr_bench("score", stored, "--radius", "0,3", "--format", "json").out)
    assert rows[0]["steps"][0]["lost"] > rows[1]["steps"][0]["lost"] > 0
    assert "lost by coarse" in vpr_bench("score", stored, "--radius", "0,3").out


OLD = Path(__file__).parents[1] / "runner" / "stored" / "v1"


def test_provenance(vpr_bench, folder):
    done = vpr_bench("show", str(folder), "--provenance")
    assert done.code == 0
    command = " ".join(("vpr-bench", *TINY))
    for fact in (command, "vpr-bench 0", "numpy", "started", "fingerprint", "of the machine's processor time"):
        assert fact in done.out
    content = json.loads(vpr_bench("show", str(folder), "--provenance", "--format", "json").out)
    assert len(content) == 1
    record = json.loads((folder / "run.json").read_text())
    assert content[0]["argv"] == ["vpr-bench", *TINY]
    assert content[0]["dataset_digest"] == record["key"]["dataset_digest"]
    assert content[0]["machine"]["blas"] == record["machine"]["blas"]
    assert content[0]["started"] <= content[0]["completed"]


def test_provenance_of_all_and_of_old_runs(vpr_bench):
    done = vpr_bench("show", "--provenance", "--output", str(OLD))
    assert done.code == 0
    assert done.out.count("fingerprint") == 2
    lines = [line.rstrip() for line in done.out.splitlines()]
    unknown = [line.removesuffix("not noted").strip() for line in lines if line.endswith("not noted")]
    assert {"method from", "command", "started", "memory", "BLAS", "elsewhere"} <= set(unknown)
    content = json.loads(vpr_bench("show", "--provenance", "--output", str(OLD), "--format", "json").out)
    assert [one["argv"] for one in content] == [None, None]


def test_a_command_that_is_not_to_be_noted(vpr_bench, tiny_dataset, monkeypatch):
    monkeypatch.setenv("VPR_BENCH_NO_ARGV", "1")
    assert vpr_bench(*TINY).code == 0
    content = json.loads(vpr_bench("show", "--provenance", "--format", "json").out)
    assert content[0]["argv"] is None


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--format", "csv"), "table or json"),
        (("--format", "markdown"), "table or json"),
        (("--plot-stages", "lost.png"), "draws nothing"),
    ],
)
def test_provenance_is_no_table_of_rows_and_no_picture(vpr_bench, folder, words, said):
    done = vpr_bench("show", "--provenance", *words)
    assert done.code == 2 and said in done.err


def test_old_runs_are_shown(vpr_bench):
    done = vpr_bench("show", "83288172c0ed", "--output", str(OLD))
    assert done.code == 0 and "1 thread, Linux" in done.out


def test_what_a_run_says_moves_no_cursor(vpr_bench, folder):
    record = json.loads((folder / "run.json").read_text())
    record["provenance"]["argv"] = ["vpr-bench", "[bold]\x1b[2J"]
    record["machine"]["processor"] = "\x1b[2JA"
    (folder / "run.json").write_text(json.dumps(record))
    for words in (("--provenance",), ()):
        done = vpr_bench("show", str(folder), *words)
        assert done.code == 0 and "\x1b" not in done.out
