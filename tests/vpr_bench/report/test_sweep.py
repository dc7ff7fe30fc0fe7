import io
from dataclasses import replace

import cv2
import numpy as np
import pytest
from rich.console import Console

from vpr_bench.errors import UsageError
from vpr_bench.report.radius_curve import draw_radius_curve
from vpr_bench.report.rows import score_run
from vpr_bench.report.sweep import sweep_grids

RADII = (2.0, 0.0, 1.0)


@pytest.fixture
def sweep(stored):
    def make(metrics=("recall@1", "pr_auc"), resamples=0, **options):
        run = stored(**options)
        return [score_run(run, metrics, run.protocol.with_radius(radius), resamples) for radius in RADII]

    return make


def test_a_table_per_metric_and_a_column_per_radius(sweep):
    grids = sweep_grids(sweep() + sweep(folder="second", label="sift"))
    assert [grid.title.split()[-1] for grid in grids] == ["recall@1", "pr_auc"]
    assert grids[0].head == ["radius (f)", "0", "1", "2"]
    assert grids[0].rows == [["hog", ".500", ".750", "1.00"], ["sift", ".500", ".750", "1.00"]]


def test_runs_of_one_name_are_told_apart_by_their_hash(sweep):
    assert [row[0] for row in sweep_grids(sweep() + sweep(folder="second"))[0].rows] == ["hog run", "hog second"]


def test_what_cannot_be_compared_is_in_tables_of_its_own(sweep):
    other = sweep(folder="second", protocol="gardens/day_left-day_right@0f")
    assert len(sweep_grids(sweep() + other)) == 4


def test_what_is_undefined_is_a_dash(sweep):
    assert sweep_grids(sweep(["roc_auc"]))[0].rows[0][-1] == "–"


def test_many_radii_fit_a_narrow_window(stored):
    run = stored()
    row = score_run(run, ["pr_auc_matched"], resamples=50)
    rows = [replace(row, protocol=row.protocol.with_radius(radius)) for radius in range(21)]
    for resampled in (rows, [replace(row, intervals={}) for row in rows]):
        console = Console(width=80, record=True, file=io.StringIO())
        for grid in sweep_grids(resampled):
            console.print(grid.rich())
        text = console.export_text()
        assert "…" not in text and text.split().count("1.00") == 21
        assert all(f" {radius}" in text for radius in range(21))


def test_intervals_stand_below_the_value(sweep):
    assert ".00–1.00" in sweep_grids(sweep(["recall@1"], resamples=100))[0].rows[0][1]


@pytest.mark.parametrize("resamples", [0, 20])
def test_picture_of_several_runs(sweep, tmp_path, resamples):
    rows = sweep(resamples=resamples) + sweep(folder="second", label="sift", resamples=resamples)
    file = draw_radius_curve(rows, ["recall@1", "pr_auc"], tmp_path / "radius.png")
    one = draw_radius_curve(rows[:3], ["recall@1"], tmp_path / "one.png")
    assert cv2.imread(str(file)).shape[1] > 1.2 * cv2.imread(str(one)).shape[1]
    assert len(np.unique(cv2.imread(str(file)).reshape(-1, 3), axis=0)) > 50


def test_units_do_not_mix(sweep, tmp_path):
    metres = [replace(row, protocol=replace(row.protocol, unit="m")) for row in sweep(folder="second")]
    with pytest.raises(UsageError, match="different units"):
        draw_radius_curve(sweep() + metres, ["recall@1"], tmp_path / "radius.png")


def test_one_radius_is_no_curve(sweep, tmp_path):
    with pytest.raises(UsageError, match="needs several radii"):
        draw_radius_curve(sweep()[:1], ["recall@1"], tmp_path / "radius.png")
