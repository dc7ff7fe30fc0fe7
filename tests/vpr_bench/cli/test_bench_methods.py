import json
import sys

import pytest

METHOD = """
from dataclasses import dataclass
from vpr_bench import Match

@dataclass
class First:
    best: float = 0.5

    def fit(self, references):
        print("fitting")

    def match(self, image, k):
        return Match(range(k), [self.best] * k)
"""


@pytest.fixture
def bench(vpr_bench, tiny_dataset, colours, monkeypatch):
    monkeypatch.setattr(sys, "path", sys.path.copy())

    def call(*variants, options=("--limit", "3", "--rounds", "2")):
        words = [word for one in variants for word in ("--variant", one)]
        return vpr_bench("bench", "methods", "--dataset", "tiny", *words, *options)

    return call


def test_a_table_of_times_and_ratios(bench):
    done = bench("colours", "colours cells=2")
    assert done.code == 0
    assert "tiny/day_left-day_right  3 images × 2 rounds, 12 references" in done.out
    assert "colours cells=2" in done.out and "ratio" in done.out and "threads" in done.out


def test_the_same_as_json_and_markdown(bench):
    done = bench("colours", "colours cells=2", options=("--limit", "3", "--threads", "1", "--format", "json"))
    facts = json.loads(done.out)
    assert (facts["images"], facts["rounds"], facts["threads"]) == (3, 3, 1)
    assert [one["variant"] for one in facts["variants"]] == ["colours", "colours cells=2"]
    assert [one["method"] for one in facts["variants"]] == ["colours", "colours(cells=2)"]
    assert set(facts["variants"][1]["ratio_to_first"]) == {"encode", "match", "before_rerank", "total"}
    assert "| colours | " in bench("colours", options=("--limit", "3", "--format", "markdown")).out


def test_a_method_in_a_file_and_words_in_quotes(bench, tmp_path):
    (tmp_path / "here" / "my own.py").write_text(METHOD)
    done = bench("'my own.py:First' best=0.25", options=("--limit", "2", "--format", "json"))
    assert done.code == 0 and json.loads(done.out)["variants"][0]["method"] == "my own.py:First(best=0.25)"
    assert "fitting" in done.err


def test_a_map_that_was_kept(bench, vpr_bench, colours):
    vpr_bench("fit", "--method", "colours", "--dataset", "tiny", "-o", "tiny.map")
    colours.done.clear()
    done = bench("tiny.map", "tiny.map seed=3", options=("--limit", "2", "--format", "json"))
    assert done.code == 0 and not colours.done
    assert [one["map"] for one in json.loads(done.out)["variants"]] == ["tiny.map"] * 2


@pytest.mark.parametrize(
    ("variant", "said"),
    [
        ("colour", "Did you mean 'colours'"),
        ("colours cell=2", "no parameter 'cell'"),
        ("colours 2", "written name=value"),
        ("colours 'cells", "A variant is written"),
        ("", "A variant is written"),
        ("nowhere.map", "nowhere.map"),
    ],
)
def test_typing_errors_cost_no_time(bench, colours, variant, said):
    colours.done.clear()
    done = bench("colours", variant)
    assert done.code == 2 and said in done.err and "Traceback" not in done.err
    assert not colours.done and not done.out


def test_a_damaged_map_is_refused(bench, vpr_bench, tmp_path):
    vpr_bench("fit", "--method", "colours", "--dataset", "tiny", "-o", "tiny.map")
    (tmp_path / "here" / "tiny.map" / "map.json").write_text("{")
    done = bench("tiny.map")
    assert done.code == 3 and "damaged" in done.err
