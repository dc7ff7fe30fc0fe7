import csv
import json
from pathlib import Path

import pytest
from PIL import Image

from vpr_bench.cli.clusters import parse_study
from vpr_bench.errors import UsageError

METHOD = '''
from dataclasses import dataclass
import numpy as np
from vpr_bench import Match
from vpr_bench.types.clusters import Clusters

@dataclass
class Even:
    """Cuts into even parts."""
    parts: int = 3
    seed: int = 0

    def fit(self, references): ...
    def match(self, image, k): return Match([], [])
    def describe_for_clusters(self, references):
        print("describing")
        return np.array([image.mean(axis=(0, 1)) for image in references], dtype=np.float32)
    def cluster_described(self, descriptors):
        if self.parts > len(descriptors):
            raise ValueError(f"{len(descriptors)} references make no {self.parts} parts")
        return Clusters.from_labels(np.arange(len(descriptors)) * self.parts // len(descriptors))
    def cluster(self, references): return self.cluster_described(self.describe_for_clusters(references))

class Other:
    def fit(self, references): ...
    def match(self, image, k): return Match([], [])
'''


@pytest.fixture
def even(vpr_bench, tiny_dataset):
    """Run the command on the tiny dataset of 12 images."""
    Path("even.py").write_text(METHOD)
    return lambda *words: vpr_bench("clusters", "tiny", "--method", "even.py:Even", *words)


def test_prints_the_clusters_and_where_the_images_are(even):
    done = even()
    assert done.code == 0
    assert "tiny/day_left  even.py:Even" in done.out and "all 3" in done.out and "describing" not in done.out
    assert "real images in" in done.err


def test_parameters_references_and_editions_can_be_chosen(even):
    content = json.loads(
        even("--param", "parts=4", "--references", "night_right.first8", "--edition", "simulated", "-f", "json").out
    )
    assert content["references"] == "tiny:simulated/night_right.first8"
    assert (content["n_references"], content["n_clusters"]) == (8, 4)
    assert content["labels"] == [0, 0, 1, 1, 2, 2, 3, 3]


@pytest.mark.parametrize("form", ["table", "json", "csv", "markdown"])
@pytest.mark.parametrize("study", [[], ["--study", "parts=1..3"]], ids=["clusters", "study"])
def test_every_format(even, form, study):
    done = even("--format", form, *study)
    assert done.code == 0
    if form == "csv":
        assert len(list(csv.DictReader(done.out.splitlines()))) == 3
    elif form == "json":
        json.loads(done.out)
    elif form == "markdown":
        assert "| --- |" in done.out


def test_draws_the_clusters_and_a_study(even):
    done = even("--plot", "clusters.png")
    assert done.code == 0 and "drawn: clusters.png" in done.err
    with Image.open("clusters.png") as picture:
        assert picture.format == "PNG"
    assert even("--study", "parts=1,2,5", "--plot", "study.svg").code == 0
    assert Path("study.svg").stat().st_size


def test_a_study_goes_on_where_one_value_does_not_do(even):
    done = even("--study", "parts=2,20,4", "--format", "json")
    assert done.code == 2
    assert [line["value"] for line in json.loads(done.out)] == ["2", "4"]
    assert "12 references make no 20 parts" in done.err


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--param", "parts=13"], 2, "cannot cluster day_left: 12 references make no 13 parts"),
        (["--param", "part=3"], 2, "Did you mean 'parts'?"),
        (["--study", "part=1,2"], 2, "Did you mean 'parts'?"),
        (["--study", "parts"], 2, "name=value,value"),
        (["--plot", "clusters.svg"], 2, "must end in .png"),
        (["--study", "parts=1,2", "--plot", "study.jpg"], 2, "must end in .png or .svg"),
        (["--references", "day_lift"], 2, "Did you mean 'day_left'?"),
        (["--references", "day_left", "--protocol", "day_left-day_right"], 2, "say it twice"),
        (["--method", "even.py:Other"], 2, "does not cluster references"),
        (["--edition", "64x32"], 2, "edition"),
    ],
)
def test_mistakes_are_told_in_one_line(even, words, code, said):
    done = even(*words)
    assert (done.code, done.out) == (code, "")
    assert said in " ".join(done.err.split()) and "Traceback" not in done.err


@pytest.mark.parametrize(
    "text", ["a", "=1", "a=", "a=1..", "a=1..x", "a=5..1", "a=1..5..0", "a=1..2..3..4", "a=0..1..0.00001", "a=1..nan"]
)
def test_studies_that_are_none(text):
    with pytest.raises(UsageError, match="is written"):
        parse_study(text)


def test_ranges_of_a_study_are_exact():
    assert parse_study("t=0.6..0.8..0.1,0.95") == ("t", ["0.6", "0.7", "0.8", "0.95"])
    assert parse_study("t=-1..1") == ("t", ["-1", "0", "1"])
