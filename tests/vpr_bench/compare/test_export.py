import csv
import io
import json

import pytest

from vpr_bench.compare import compare_runs
from vpr_bench.compare.export import to_csv, to_json


@pytest.fixture
def comparison(stored):
    return compare_runs(
        stored(), stored(label="sad", first=[0, 1, 2, 3, 4, 5, -1, 0]), ["recall@1", "recall@20"], resamples=20
    )


def test_json_has_everything(comparison):
    content = json.loads(to_json(comparison, lambda query: f"{query}.jpg" if query == 6 else None))
    assert content["metrics"]["recall@1"]["b_minus_a"] == -0.25
    assert content["metrics"]["recall@20"]["a"] is None and content["metrics"]["recall@20"]["low"] is None
    assert content["right_answers"] == {"both": 6, "only_a": 2, "only_b": 0, "neither": 0, "mcnemar_p_value": 0.5}
    assert content["latency"]["stages"]["total"]["b_over_a"] == 1 and content["latency"]["refused"] is None
    assert content["gained"] == [] and [flip["query"] for flip in content["lost"]] == [6, 7]
    assert content["lost"][0]["file"] == "6.jpg" and content["lost"][0]["b_reference"] is None
    assert content["lost"][1]["file"] is None and content["lost"][1]["true_reference"] == 7
    assert content["a"]["method"] == "hog" and content["protocol"] == "gardens/day_left-night_right@0f"
    assert any("bench methods" in note for note in content["notes"])


def test_csv_has_a_line_for_each(comparison):
    lines = list(csv.DictReader(io.StringIO(to_csv(comparison, lambda query: 'a "comma", \n and more'))))
    assert [(line["part"], line["name"]) for line in lines] == [
        ("metric", "recall@1"),
        ("metric", "recall@20"),
        ("mcnemar", "only one right"),
        ("latency_ms", "encode"),
        ("latency_ms", "total"),
        ("lost", "6"),
        ("lost", "7"),
    ]
    assert float(lines[0]["b_minus_a"]) == -0.25 and lines[1]["a"] == ""
    assert float(lines[4]["a"]) == 30 and lines[4]["b_over_a"] == "1.0"
    assert lines[5]["file"] == 'a "comma", \n and more' and lines[5]["b_reference"] == ""
    assert lines[3]["name"] == "encode" and lines[3]["low"] == "1.0"
    assert {line["protocol"] for line in lines} == {"gardens/day_left-night_right@0f"}


def test_runs_of_one_name_are_told_apart(stored):
    found = compare_runs(stored(folder="before/run"), stored(folder="after/run"), ["recall@1"], resamples=20)
    line = next(csv.DictReader(io.StringIO(to_csv(found, str))))
    assert line["run_a"].endswith("before/run") and line["run_b"].endswith("after/run")


def test_no_text_in_csv_is_a_formula(stored):
    seconds = {"decode": 0.5, '=HYPERLINK("http://x")': 0.02, "total": 0.03}
    found = compare_runs(
        stored(seconds=seconds), stored(seconds=seconds, label="sad", first=[0] * 8), ["recall@1"], resamples=20
    )
    text = to_csv(found, lambda query: "@SUM(1)")
    lines = list(csv.DictReader(io.StringIO(text)))
    assert '\'=HYPERLINK("http://x")' in {line["name"] for line in lines}
    assert {line["file"] for line in lines if line["part"] == "lost"} == {"'@SUM(1)"}
    assert lines[0]["b_minus_a"].startswith("-")
