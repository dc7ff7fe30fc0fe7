"""Methods in files, and methods inside methods, on the command line."""

import json
import re
from pathlib import Path

import pytest

MINE = '''
from dataclasses import dataclass
import numpy as np
from vpr_bench import Match

@dataclass
class Mine:
    """Compares mean colours."""

    size: int = 2

    def fit(self, references):
        self.database_ = np.stack([image.mean(axis=(0, 1)) for image in references])

    def match(self, image, k):
        return Match.from_scores(-np.linalg.norm(self.database_ - image.mean(axis=(0, 1)), axis=1), k)
'''
RUN = ("run", "--dataset", "tiny", "--format", "json")


def one_line(text):
    return re.sub(r"\s+", " ", text)


@pytest.fixture(autouse=True)
def _no_pictures(monkeypatch):
    monkeypatch.setattr("vpr_bench.report.curve.draw_curve", lambda *words: None)


@pytest.fixture
def mine(vpr_bench):
    path = Path("methods") / "mine.py"
    path.parent.mkdir()
    path.write_text(MINE)
    return path


def test_a_method_in_a_file_is_run_and_described(vpr_bench, tiny_dataset, mine):
    for name in (f"{mine}:Mine", f"{mine.absolute()}:Mine"):
        done = vpr_bench(*RUN, "--method", name, "--param", f"{name}.size=3")
        assert [row["method"] for row in json.loads(done.out)] == ["mine.py:Mine(size=3)"]
    assert len(list(Path("runs").rglob("run.json"))) == 1  # however the file is named, it is the same method
    facts = json.loads(vpr_bench("info", f"{mine}:Mine", "--format", "json").out)
    assert facts["summary"] == "Compares mean colours."
    assert facts["parameters"] == [{"parameter": "size", "default": "2"}]


def test_an_edited_file_is_another_method(vpr_bench, tiny_dataset, mine):
    vpr_bench(*RUN, "--method", f"{mine}:Mine")
    mine.write_text(MINE + "# edited")
    assert "running" in vpr_bench(*RUN, "--method", f"{mine}:Mine").err
    assert len(list(Path("runs").rglob("run.json"))) == 2


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("methods/mien.py:Mine", "mien.py:Mine: there is no such file"),
        ("methods/mine.py:Mien", "there is no 'Mien' in it. Did you mean 'Mine'?"),
        ("methods/mine.py", "Which class of that file is the method? Write methods/mine.py:Class."),
        ("methods/broken.py:Mine", "broken.py, line 3: NameError: name 'nonsense' is not defined"),
        ("methods/mine.py:np", "must be a class with fit and match"),
    ],
)
def test_what_is_wrong_with_a_file_is_said(vpr_bench, tiny_dataset, mine, name, said):
    mine.with_name("broken.py").write_text("import math\n\nnonsense\n")
    done = vpr_bench(*RUN, "--method", name)
    assert done.code == 2
    assert said in one_line(done.err)
    assert "Traceback" not in done.err


def test_parameters_of_the_method_inside(vpr_bench, tiny_dataset):
    small = ("inner.width=32", "inner.height=32", "inner.cell=8", "past=3")
    words = [word for one in small for word in ("--param", one)]
    done = vpr_bench(*RUN, "--method", "seqslam", *words)
    label = "seqslam(inner=hog(width=32, height=32, cell=8), past=3)"
    assert [row["method"] for row in json.loads(done.out)] == [label]
    record = json.loads(next(Path("runs").rglob("run.json")).read_text())
    assert record["order"] == "sequential"
    assert record["key"]["parameters"]["inner"]["parameters"]["width"] == 32
    shown = one_line(
        vpr_bench("show", record["key"]["method"] and next(Path("runs").rglob("run.json")).parent.name).out
    )
    assert "in their order" in shown


def test_several_sequence_methods_share_or_own_what_is_inside(vpr_bench, tiny_dataset, mine):
    words = ("--method", "seqslam", "--method", "hmm", "--param", f"inner={mine}:Mine", "--param", "hmm.inner.size=5")
    done = vpr_bench(*RUN, *words)
    assert [row["method"] for row in json.loads(done.out)] == [
        "seqslam(inner=mine.py:Mine)",
        "hmm(inner=mine.py:Mine(size=5))",
    ]


@pytest.mark.parametrize(
    ("parameter", "said"),
    [
        ("inner.size=3", "The method 'hog' has no parameter 'size'"),
        ("outer.size=3", "'outer.size=3' is for the method 'outer', which is not run"),
        ("seqslam.outer.size=3", "The method 'seqslam' has no parameter 'outer.size'"),
        ("inner=hogg", "There is no method 'hogg'. Did you mean 'hog'?"),
    ],
)
def test_what_is_wrong_inside_is_said(vpr_bench, tiny_dataset, parameter, said):
    done = vpr_bench(*RUN, "--method", "seqslam", "--param", parameter)
    assert done.code == 2
    assert said in one_line(done.err)
