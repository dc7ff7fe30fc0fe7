import json

import pytest

METHOD = """
import numpy as np
from vpr_bench import Match


class Mine:
    def __init__(self, shy: bool = False):
        self.shy = shy

    def fit(self, references):
        print("fitting")
        if self.shy and len(references) == 1:
            raise ValueError("[red]too\\x1b[31m small")
        self.count = len(references)
        self.images = [image[::16, ::16].astype(int) for image in references]

    def match(self, image, k):
        return Match.from_scores([-np.abs(image[::16, ::16].astype(int) - one).mean() for one in self.images], k)
"""


@pytest.fixture
def mine(tmp_path, monkeypatch):
    (tmp_path / "my_file.py").write_text(METHOD)
    return str(tmp_path / "my_file.py") + ":Mine"


def test_a_method(vpr_bench):
    done = vpr_bench("check", "method", "random", "--only", "map-of-one", "--only", "finds-the-same-image")
    assert (done.code, done.err) == (0, "")
    assert done.out.splitlines()[1].split() == ["map-of-one", "pass"]
    assert "finds-the-same-image  expected failure  answers have nothing to do with what is seen" in done.out
    assert done.out.endswith("random: 1 passed, 1 failed as expected\n")


def test_json(vpr_bench):
    done = vpr_bench("check", "method", "hog", "--param", "cell=32", "--only", "reset-forgets", "-f", "json")
    content = json.loads(done.out)
    assert content["method"] == "hog(cell=32)"
    (only,) = content["checks"]
    assert only.pop("seconds") >= 0
    assert only == {"check": "reset-forgets", "result": "skip", "reason": "it is not sequential"}


def test_a_method_of_ones_own_that_fails(vpr_bench, mine):
    done = vpr_bench("check", "method", mine, "--param", "shy=true", "--only", "map-of-one")
    assert done.code == 1
    assert "fit on a map of one raises ValueError: [red]too[31m small (my_file.py, line 13)" in done.out
    assert done.out.endswith("my_file.py:Mine(shy=True): 1 failed\n")
    assert "fitting" in done.err and "fitting" not in done.out


def test_all_checks_of_a_method_of_ones_own(vpr_bench, mine):
    done = vpr_bench("check", "method", mine, "--format", "json")
    content = json.loads(done.out)
    failed = {one["check"] for one in content["checks"] if one["result"] == "fail"}
    assert (done.code, failed) == (1, {"odd-sizes"})


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (("method", "hgo"), 2, "Did you mean 'hog'?"),
        (("method", "hog", "--only", "map-of-two"), 2, "Did you mean 'map-of-one'?"),
        (("method", "hog", "--param", "cel=8"), 2, "Did you mean 'cell'?"),
        (("method", "hog", "--param", "cell"), 2, "written name=value"),
        (("method", "resnet18"), 3, "vpr-bench weights fetch resnet18-imagenet"),
        (("dataset", "garden"), 2, "Did you mean 'gardens'?"),
        (("dataset", "gardens", "--only", "x"), 2, "There is no check 'x'"),
        (("dataset", "gardens:real"), 3, "vpr-bench data fetch gardens"),
        (("env", "vpr_bench/Gardns-v0"), 2, "Did you mean 'vpr_bench/Gardens-v0'?"),
        (("env", "garden"), 2, "Did you mean 'gardens'?"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_what_cannot_be_checked(vpr_bench, data_folder, words, code, message):
    done = vpr_bench("check", *words)
    assert (done.code, done.out) == (code, "")
    assert message in done.err


def test_a_dataset(vpr_bench, tiny_dataset):
    done = vpr_bench("check", "dataset", "tiny")
    assert (done.code, done.err) == (0, "")
    assert done.out.endswith("tiny: 7 passed, 1 skipped\n")


def test_a_dataset_that_fails(vpr_bench, tiny_dataset):
    (tiny_dataset.folder / "day_left" / "Image000.jpg").write_bytes(b"")
    done = vpr_bench("check", "dataset", "tiny:real", "--only", "ends-decode", "--format", "json")
    assert done.code == 1
    content = json.loads(done.out)
    assert content["dataset"] == "tiny"
    assert "Image000.jpg is empty" in content["checks"][0]["reason"]


def test_an_environment(vpr_bench, tiny_dataset):
    done = vpr_bench("check", "env", "tiny", "--param", "order=sequential", "--param", "k=3")
    assert done.code == 0
    assert done.out.endswith("tiny: 5 passed\n")
