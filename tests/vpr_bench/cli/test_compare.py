import csv
import io
import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from vpr_bench.files.digest import sha256_of_file

SMALL = ("--param", "hog.width=32", "--param", "hog.height=32", "--param", "hog.cell=8")
TINY = ("--dataset", "tiny", "--protocol", "day_left-night_right")


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """Return where the runs of all tests are kept."""
    return tmp_path_factory.mktemp("kept") / "runs"


@pytest.fixture
def runs(vpr_bench, tiny_dataset, kept):
    """Folders of a run of random and one of hog, which are made once and copied for every test."""
    if not kept.exists():
        assert vpr_bench("run", "--method", "random", "--method", "hog", *SMALL, *TINY, "--output", str(kept)).code == 0
    shutil.copytree(kept, "runs")
    return [*folders("random"), *folders("hog")]


def folders(method):
    """Where the runs of a method lie, by their names."""
    return sorted(record.parent for record in Path("runs").glob(f"*/*/{method}/*/run.json"))


def rewritten(folder, **changes):
    """Change what a stored run says of itself."""
    record = json.loads((folder / "run.json").read_text())
    for name, value in changes.items():
        (record["key"] if name in record["key"] else record)[name] = value
    (folder / "run.json").write_text(json.dumps(record))


def test_a_table_for_people(vpr_bench, runs):
    done = vpr_bench("compare", runs[0].name[:6], str(runs[1]))
    assert done.code == 0 and done.err == ""
    assert "tiny/day_left-night_right@1f~miss  12 queries" in done.out
    for part in ("is B better?", "is B faster?", "McNemar", "that only B answers right", "night_right/Image0"):
        assert part in done.out


def test_swapping_the_runs_turns_the_differences_round(vpr_bench, runs):
    there, back = (
        json.loads(vpr_bench("compare", str(a), str(b), "--format", "json").out)
        for a, b in ((runs[0], runs[1]), (runs[1], runs[0]))
    )
    assert there["metrics"]["recall@1"]["b_minus_a"] == -back["metrics"]["recall@1"]["b_minus_a"] > 0
    assert [flip["query"] for flip in there["gained"]] == [flip["query"] for flip in back["lost"]]
    assert there["gained"][0]["file"].startswith("night_right/Image")


def test_metrics_radius_and_policy_are_chosen(vpr_bench, runs):
    words = ("--metric", "recall@1", "--metric", "recall@3", "--radius", "2", "--unmatched", "reject")
    content = json.loads(vpr_bench("compare", *map(str, runs), *words, "--resamples", "150", "--format", "json").out)
    assert list(content["metrics"]) == ["recall@1", "recall@3"]
    assert content["protocol"] == "tiny/day_left-night_right@2f~reject" and content["resamples"] == 150


def test_csv_and_markdown(vpr_bench, runs):
    done = vpr_bench("compare", *map(str, runs), "--format", "csv")
    lines = list(csv.DictReader(io.StringIO(done.out)))
    assert {"metric", "mcnemar", "latency_ms", "gained"} <= {line["part"] for line in lines}
    assert "bench methods" in done.err  # what limits the numbers has no place between them
    assert (
        "| metric | A | B | B - A | 95 % | p | better |" in vpr_bench("compare", *map(str, runs), "-f", "markdown").out
    )


def test_flips_are_drawn(vpr_bench, runs):
    done = vpr_bench("compare", *map(str, runs), "--plot", "flips.png", "--format", "json")
    assert done.code == 0 and "drawn: flips.png" in done.err
    with Image.open("flips.png") as sheet:
        assert sheet.width > 1000


def test_without_the_images_there_are_spaces_and_one_warning(vpr_bench, runs, tiny_dataset):
    tiny_dataset.without_images()
    done = vpr_bench("compare", *map(str, runs), "--plot", "flips.png")
    assert done.code == 0 and Path("flips.png").exists()
    assert done.err.count("warning") == 1 and "cannot be shown" in done.err
    assert "query " in done.out


def test_nothing_flipped(vpr_bench, runs):
    assert vpr_bench("run", "--method", "hog", *SMALL, *TINY, "--seed", "1").code == 0
    again = next(folder for folder in folders("hog") if folder != runs[1])
    done = vpr_bench("compare", str(runs[1]), str(again), "--plot", "flips.png")
    assert done.code == 0 and "nothing to draw" in done.err and not Path("flips.png").exists()
    assert "the same answers" in done.out


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("A", "A"), 2, "the same run"),
        (("A", "zz"), 2, "neither a run's folder nor"),
        (("A",), 2, "Missing argument 'B'"),
        (("A", "B", "--metric", "recal@1"), 2, "There is no metric 'recal@1'"),
        (("A", "B", "--radius", "-1"), 2, "Got -1.0"),
        (("A", "B", "--radius", "11"), 2, "reaches over the whole map"),
        (("A", "B", "--plot", "flips.svg"), 2, "must end in .png"),
        (("A", "B", "--plot", "nowhere/flips.png"), 3, "Cannot write"),
        (("A", "B", "--plot", "."), 2, "must end in .png"),
        (("A", "B", "--resamples", "99"), 2, "greater than or equal to 100"),
    ],
)
def test_errors(vpr_bench, runs, words, code, said):
    named = {"A": str(runs[0]), "B": str(runs[1])}
    done = vpr_bench("compare", *(named.get(word, word) for word in words))
    assert done.code == code and said in done.err and "Traceback" not in done.err
    assert not done.out  # nothing is computed first


def test_another_protocol(vpr_bench, runs):
    assert vpr_bench("run", "--method", "random", "--dataset", "tiny").code == 0
    other = next(folder for folder in folders("random") if folder != runs[0])
    done = vpr_bench("compare", str(runs[0]), str(other))
    assert done.code == 2 and "only runs on the same images can be compared" in done.err


def test_other_queries(vpr_bench, runs):
    assert vpr_bench("run", "--method", "random", *TINY, "--limit", "5").code == 0
    part = next(folder for folder in folders("random") if folder != runs[0])
    done = vpr_bench("compare", str(runs[1]), str(part))
    assert done.code == 2 and "12 queries, B 5 queries (--limit 5, --seed 0)" in done.err


def test_other_images(vpr_bench, runs):
    other = runs[0].rename("other")
    rewritten(other, dataset_digest="sha256:" + "1" * 64)
    done = vpr_bench("compare", str(other), str(runs[1]))
    assert done.code == 3 and "were not the same" in done.err


def test_damaged_runs(vpr_bench, runs):
    np.savez(runs[0] / "timings.npz", **{"seconds.total": np.zeros(3)})
    record = json.loads((runs[0] / "run.json").read_text())
    files = {**record["files"], "timings.npz": sha256_of_file(runs[0] / "timings.npz")}
    rewritten(runs[0], files=files)
    done = vpr_bench("compare", *map(str, runs))
    assert done.code == 3 and f"{runs[0]} is damaged" in done.err
    (runs[0] / "matches.npz").write_bytes(b"")
    assert vpr_bench("compare", *map(str, runs)).code == 3
