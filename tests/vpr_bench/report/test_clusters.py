import csv
import json

import numpy as np
import pytest
from PIL import Image

from vpr_bench.method.clustering import Clustered
from vpr_bench.report.cluster_sheet import draw_cluster_sheet
from vpr_bench.report.cluster_study import ClusterStudy
from vpr_bench.report.cluster_table import ClusterReport
from vpr_bench.types.clusters import Clusters
from vpr_bench.types.traverse import Traverse

ROWS = np.array([[0, 1], [0, 2], [5, 1], [6, 1], [5, 2]], np.float32)


def report(labels, cohesion=None, rows=ROWS):
    return ClusterReport("mine(n=2)", "walk/one", Clustered(Clusters(labels, cohesion), rows))


def test_the_table_has_a_line_for_each_cluster_and_one_for_all():
    grid = report([0, 0, 1, 1, 0], [0.5, 0.9]).grid()
    first, second, total = ([cell.strip() for cell in row] for row in grid.rows)
    assert first == ["0", "0", "5", "3", "no", "0.500", "1"]
    assert second == ["1", "2", "4", "2", "yes", "0.900", "2"]
    assert total == ["all 2", "0", "5", "2 / 2.5 / 3", "no", "0.700", ""]
    assert "silhouette" in grid.note and grid.title == "walk/one  mine(n=2)"


def test_programs_get_everything():
    content = json.loads(report([0, 0, 1, 1, 1], [1, 1]).json())
    assert content["labels"] == [0, 0, 1, 1, 1]
    assert content["clusters"][1]["start"] == 2 and content["clusters"][1]["stop"] == 5
    assert content["silhouette"] > 0.5 and content["contiguous"] is True
    lines = list(csv.DictReader(report([0, 0, 1, 1, 1]).csv().splitlines()))
    assert [line["size"] for line in lines] == ["2", "3"] and lines[0]["cohesion"] == ""


def test_what_is_not_known_is_none():
    content = json.loads(report([0, 0, 1, 1, 1], rows=None).json())
    assert content["mean_cohesion"] is content["silhouette"] is content["distortion"] is None
    assert content["clusters"][1]["central"] == 3
    assert json.loads(report([0] * 5).json())["silhouette"] is None


def test_a_study_has_a_line_for_each_value(tmp_path):
    reports = [report([0] * 5), report([0, 0, 1, 1, 1])]
    study = ClusterStudy("mine", "walk/one", "threshold", ["0.5", "0.7"], reports)
    assert [row[:2] for row in study.grid().rows] == [["0.5", "1"], ["0.7", "2"]]
    assert [line["n_clusters"] for line in json.loads(study.json())] == [1, 2]
    assert study.csv().splitlines()[0].startswith("parameter,value,n_references,n_clusters")
    with Image.open(study.draw(tmp_path / "study.png")) as picture:
        assert picture.width > picture.height


@pytest.mark.parametrize("values", [["hog", "sift"], ["nan", "2"], ["1", "2"]], ids=["words", "no number", "as asked"])
def test_a_study_of_anything_can_be_drawn(values, tmp_path):
    reports = [report([0] * 5, rows=None), report([0, 0, 1, 1, 1], rows=None)]
    assert ClusterStudy("a $b$ method", "w", "n_clusters", values, reports).draw(tmp_path / "a.svg").stat().st_size


@pytest.mark.parametrize(
    ("labels", "cohesion", "rows"),
    [
        ([0, 0, 1, 1, 2], [1, 0.9, 1], ROWS),
        ([0, 1, 0, 1, 0], None, ROWS),
        ([0, 0, 0, 1, 1], [1, 1], None),
        ([0, 0, 0, 0, 0], [0.5], np.zeros((5, 3), np.float32)),
        ([0], [1], np.ones((1, 3), np.float32)),
        (list(range(100)), None, np.random.default_rng(0).random((100, 4), dtype=np.float32)),
    ],
    ids=["stretches", "elsewhere", "not described", "identical", "one", "many"],
)
def test_clusters_of_every_kind_are_drawn_the_same_each_time(labels, cohesion, rows, tmp_path):
    images = Traverse("one", [np.full((24, 32, 3), place % 256, np.uint8) for place in range(len(labels))])
    drawn = [
        draw_cluster_sheet(report(labels, cohesion, rows), images, tmp_path / name).read_bytes()
        for name in ("a.png", "b.png")
    ]
    assert drawn[0] == drawn[1]
    with Image.open(tmp_path / "a.png") as picture:
        assert picture.format == "PNG" and picture.width == 1600
