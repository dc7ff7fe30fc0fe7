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
