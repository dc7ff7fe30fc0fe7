"""Methods that fail on the command line: the others go on, and what was done is kept."""

import json
import re
from pathlib import Path

import pytest

FAULTY = """
import time
import numpy as np
from vpr_bench import Match

class Faulty:
    version = "1"

    def __init__(self, fault: str = "none"):
        self.fault, self.count = fault, 0

    def fit(self, references):
        self.dark = float(references[0].mean()) < 90
        self.size = len(references)

    def match(self, image, k):
        self.count += 1
        if self.count > 7 and image.mean() < 90:  # at night only
            if self.fault == "raises":
                raise RuntimeError("no light")
            if self.fault == "nan":
                return Match([0], [float("nan")])
            if self.fault == "twice":
                return Match([0, 0], [1.0, 1.0])
            if self.fault == "outside":
                return Match([self.size], [1.0])
            if self.fault == "many":
                return Match(range(k + 1), np.zeros(k + 1))
            while self.fault == "hangs":
                time.sleep(0.001)
            if self.fault == "few":
                return Match([0], [1.0])
        return Match((self.count + np.arange(k)) % self.size, np.zeros(k))
"""
SAID = {
    "raises": "RuntimeError: no light",
    "nan": "the scores of a match must be finite",
    "twice": "the indices of a match must be unique",
    "outside": "with reference 12 of a map of 12",
    "many": "references where 5 were asked for",
    "few": "1 reference where 5 were asked for",
    "hangs": "TimeoutError: no answer within 0.1 s",
}


@pytest.fixture(autouse=True)
def _no_pictures(monkeypatch):
    monkeypatch.setattr("vpr_bench.report.curve.draw_curve", lambda *words: None)


@pytest.mark.parametrize("fault", SAID)
def test_the_other_cells_go_on(vpr_bench, tiny_dataset, fault):
    Path("faulty.py").write_text(FAULTY)
    words = ("run", "--method", "faulty.py:Faulty", "--dataset", "tiny", "--protocol", "all", "--format", "json")
    words = (*words, "--method", "hog", "--param", "hog.width=32", "--param", "hog.height=32", "--param", "hog.cell=8")
    asked = (*words, "--k", "5", "--timeout", "0.1", "--param", f"faulty.py:Faulty.fault={fault}")
    done = vpr_bench(*asked)
    assert done.code == 1
    label = f"faulty.py:Faulty(fault={fault})"
    assert [(row["method"].partition("(")[0], row["protocol"]) for row in json.loads(done.out)] == [
        ("faulty.py:Faulty", "tiny/day_left-day_right@1f"),
        ("hog", "tiny/day_left-day_right@1f"),
        ("hog", "tiny/day_left-night_right@1f~miss"),
    ]
    said = [line for line in done.err.replace("\n", " ").split("error: ") if "failed" in line or "answered" in line]
    assert len(said) == 1 and SAID[fault] in re.sub(r"\s+", " ", said[0])
    assert "'faulty.py:Faulty'" in said[0] and re.search(r"night_right/Image\d{3}.jpg", said[0])
    assert "Traceback" not in done.err
    assert list(Path("runs").rglob("answers.npz"))  # to go on from

    Path("faulty.py").write_text(FAULTY.replace("at night only", "healed").replace("> 7", "> 7000"))
    again = vpr_bench(*asked)
    assert again.code == 0
    assert f"{label} on tiny/day_left-night_right: running" in re.sub(r"\s+", " ", again.err)
    records = [json.loads(path.read_text()) for path in Path("runs").rglob("run.json")]
    assert len(records) == 4
    assert [record["label"] for record in records if record["resumed"]] == [label]


@pytest.mark.parametrize("seconds", ["0", "-1", "nan"])
def test_a_time_limit_must_be_positive(vpr_bench, tiny_dataset, seconds):
    done = vpr_bench("run", "--method", "hog", "--dataset", "tiny", "--timeout", seconds)
    assert done.code == 2
    assert seconds in done.err.replace("0.0", "0").replace("-1.0", "-1")
