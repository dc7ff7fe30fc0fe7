import json
from pathlib import Path

import pytest

SMALL = ("--param", "width=32", "--param", "height=32", "--param", "cell=8")
TINY = ("run", "--method", "hog", *SMALL, "--dataset", "tiny")
OFFSET = """
from pathlib import Path
import numpy as np
from vpr_bench.types.match import Match
class Offset:
    version = "1"
    def fit(self, references):
        self.database_ = np.stack([image.mean(axis=(0, 1)) for image in references])
    def match(self, image, k):
        print("not a result")
        distances = np.linalg.norm(self.database_ - image.mean(axis=(0, 1)), axis=1)
        return Match.from_scores(-distances * float(Path(__file__).with_name("factor.txt").read_text()), k)
"""


def stored_run():
    return next(Path("runs").rglob("run.json")).parent


@pytest.fixture
def folder(vpr_bench, tiny_dataset):
    assert vpr_bench(*TINY).code == 0
    return stored_run()


@pytest.fixture
def offset(vpr_bench, tiny_dataset):
    """Store a run of a method in a file that answers otherwise when another file says so."""
    Path("offset.py").write_text(OFFSET)
    Path("factor.txt").write_text("1")
    assert vpr_bench("run", "--method", "offset.py:Offset", "--dataset", "tiny").code == 0
    return stored_run()


def test_the_same_again(vpr_bench, folder):
    done = vpr_bench("reproduce", folder.name[:6])
    assert done.code == 0
    assert "Identical: all 12 answers, bit by bit." in done.out
    assert "recall@1" in done.out and "not judged" in done.out
    assert "Machine, system, code and versions are as they were." in done.out
    assert (Path("reproduced") / folder.relative_to("runs") / "run.json").exists()


def test_as_json(vpr_bench, offset):
    done = vpr_bench("reproduce", str(offset), "-m", "offset.py:Offset", "--output", "twice", "--format", "json")
    assert done.code == 0
    content = json.loads(done.out)
    assert content["identical"] and content["same_file"] and content["environment"] == []
    assert content["recorded"] == str(offset) and content["again"].startswith("twice")
    assert all(one["recorded"] == one["again"] for one in content["metrics"].values())
    assert content["latency_ms"]["latency_total_p50"]["again"] > 0


def test_other_answers(vpr_bench, offset):
    Path("factor.txt").write_text("2")
    done = vpr_bench("reproduce", str(offset), "-m", "offset.py:Offset")
    assert done.code == 1
    assert "NOT identical" in done.out and "12 other scores" in done.out
    content = json.loads(vpr_bench("reproduce", str(offset), "-m", "offset.py:Offset", "-f", "json").out)
    assert (content["identical"], content["scores"], content["best"]) == (False, 12, 0)


def test_other_places(vpr_bench, folder):
    vpr_bench("reproduce", str(folder))
    record = json.loads((folder / "run.json").read_text())
    record["provenance"]["source"] = {"commit": "c0ffee", "changed": False}
    record["machine"]["libraries"]["numpy"] = "\x1b[31m1.0"
    record["machine"]["blas"] = None
    (folder / "run.json").write_text(json.dumps(record))
    done = vpr_bench("reproduce", str(folder))
    assert done.code == 0  # the environment is only told
    assert "c0ffee" in done.out and "[31m1.0" in done.out and "\x1b" not in done.out
    assert "Noted by one of the two only: BLAS." in done.out


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("0123456789ab",), 2, "no run begins with"),
        (("RUN", "--output", "runs"), 2, "Give another folder with --output"),
        (("RUN", "--method", "nothing"), 2, "There is no method 'nothing'"),
        (("RUN", "--dataset", "./nowhere"), 3, "There is no folder"),
        (("RUN", "--format", "csv"), 2, "csv"),
    ],
)
def test_errors(vpr_bench, folder, words, code, said):
    done = vpr_bench("reproduce", *(str(folder) if word == "RUN" else word for word in words))
    assert done.code == code
    assert said in done.err and "Traceback" not in done.err
    assert not Path("reproduced").exists()


def test_what_is_no_longer_as_it_was(vpr_bench, folder, tiny_dataset):
    image = next((tiny_dataset.folder / "day_right").iterdir())
    image.write_bytes((tiny_dataset.folder / "night_right" / image.name).read_bytes())
    done = vpr_bench("reproduce", str(folder))
    assert done.code == 3
    assert "digest of the images is not that of the run" in done.err
    tiny_dataset.without_images()
    assert vpr_bench("reproduce", str(folder)).code == 3


def test_no_run_but_a_reproduction_is_overwritten(vpr_bench, folder):
    assert vpr_bench(*TINY, "--output", "other").code == 0
    before = (Path("other") / folder.relative_to("runs") / "run.json").stat().st_mtime_ns
    done = vpr_bench("reproduce", str(folder), "--output", "other")
    assert done.code == 2
    assert "is no reproduction, and not overwritten" in done.err
    assert (Path("other") / folder.relative_to("runs") / "run.json").stat().st_mtime_ns == before
    assert [vpr_bench("reproduce", str(folder)).code for _ in range(2)] == [0, 0]


def test_a_damaged_run(vpr_bench, folder):
    (folder / "matches.npz").write_bytes(b"")
    assert vpr_bench("reproduce", str(folder)).code == 3
