import csv
import io
import json

import cv2
import numpy as np
import pytest

from vpr_bench.errors import UsageError
from vpr_bench.report.losses import losses_grid, losses_line
from vpr_bench.report.markdown import to_markdown
from vpr_bench.report.rows import score_run
from vpr_bench.report.table import render_tables, to_csv, to_json
from vpr_bench.report.waterfall import draw_waterfall
from vpr_bench.types.survivors import gathered


@pytest.fixture
def narrowed(stored):
    """A run whose steps lose the last place, then the third; it finds the first two."""

    def make(**options):
        run = stored(**options)
        coarse, fine = [[0, 1], [1, 2], [2, 3], [1, 2]], [[0], [1], [3], [1]]
        rows = [
            {"coarse": np.array(first, np.int32), "fine": np.array(second, np.int32)}
            for first, second in zip(coarse, fine, strict=True)
        ]
        run.__dict__["survivors"] = gathered(rows)
        return run

    return make


def test_line(narrowed):
    assert losses_line(score_run(narrowed())) == "run lost the right place by: coarse .250, fine .250, ranking .000"


def test_the_run_table_grows_by_one_line_only(narrowed, stored):
    from rich.console import Console

    console = Console(width=80, record=True, file=io.StringIO())
    console.print(render_tables([score_run(narrowed()), score_run(stored(folder="other"))], {}))
    text = console.export_text()
    assert text.count("lost the right place") == 1
    assert "coarse .250, fine .250, ranking .000" in text


def test_grid(narrowed):
    grid = losses_grid(score_run(narrowed()))
    assert [list(row) for row in grid.rows] == [
        ["coarse", "2.0", "0.750", "0.250"],
        ["fine", "1.0", "0.500", "0.250"],
        ["ranking", "1.0", "0.500", "0.000"],
    ]
    with_intervals = losses_grid(score_run(narrowed(folder="again"), resamples=100))
    assert {len(row) for row in with_intervals.rows} == {len(with_intervals.head)} == {6}


def test_another_radius_loses_less(narrowed):
    run = narrowed()
    steps = score_run(run, protocol=run.protocol.with_radius(1)).steps
    assert [step.lost.value for step in steps] == [0, 0.25, 0]


def test_for_programs(narrowed, stored):
    rows = [score_run(narrowed(), ["recall@1"], resamples=50), score_run(stored(folder="other"), ["recall@1"])]
    first, second = json.loads(to_json(rows))
    assert first["steps"][0]["step"] == "coarse" and first["steps"][0]["lost"] == 0.25
    assert first["steps"][1]["lost_interval"][0] <= 0.25 <= first["steps"][1]["lost_interval"][1]
    assert second["steps"] == []
    lines = list(csv.DictReader(io.StringIO(to_csv(rows))))
    assert (lines[0]["lost_by_coarse"], lines[0]["recall_after_fine"]) == ("0.25", "0.5")
    assert float(lines[0]["lost_by_fine_low"]) <= 0.25 and lines[1]["lost_by_coarse"] == ""


def test_markdown(narrowed, stored):
    text = to_markdown([score_run(narrowed(label="a|b")), score_run(stored(folder="other"))])
    assert "| a&#124;b | run | gardens/day_left-night_right@0f | 0.500 |" in text
    assert "| coarse | 2.0 | 0.750 | 0.250 |" in text
    assert text.count("where the right place was lost") == 1


@pytest.mark.parametrize("name", ["lost.png", "lost.svg"])
def test_picture(narrowed, stored, tmp_path, name):
    rows = [score_run(narrowed(label="costs $5, $6")), score_run(stored(folder="other"))]
    file = draw_waterfall(rows, tmp_path / name)
    content = file.read_bytes()
    assert draw_waterfall(rows, tmp_path / name).read_bytes() == content
    if name.endswith("png"):
        colours = {tuple(pixel) for pixel in cv2.imread(str(file))[..., ::-1].reshape(-1, 3)}
        assert {(0, 158, 115), (230, 159, 0), (0, 114, 178)} <= colours  # found, coarse, fine


def test_no_picture_of_nothing(stored, tmp_path):
    with pytest.raises(UsageError, match="nothing to draw"):
        draw_waterfall([score_run(stored())], tmp_path / "lost.png")
