import numpy as np
import pytest
from PIL import Image

from vpr_bench.errors import DataError
from vpr_bench.report.ink import BLUE
from vpr_bench.report.panel import Panel
from vpr_bench.report.panel_sheet import draw_panel_sheet
from vpr_bench.report.places import place_text

IMAGE = np.full((30, 40, 3), 200, np.uint8)


def test_rows_below_each_other_and_panels_side_by_side(tmp_path):
    sizes = []
    for rows in ([[1]], [[1, 2, 3]], [[1, 2, 3], [1]]):
        panels = [[Panel(str(one), BLUE, IMAGE, "", ("a line", "another")) for one in row] for row in rows]
        with Image.open(draw_panel_sheet(tmp_path / "a.png", "Title", "said", panels, warning="SIMULATED")) as drawn:
            sizes.append(drawn.size)
    assert sizes[0][0] < sizes[1][0] == sizes[2][0]
    assert sizes[0][1] == sizes[1][1] < sizes[2][1]


def test_a_sheet_without_a_single_picture(tmp_path):
    with Image.open(draw_panel_sheet(tmp_path / "a.png", "T", "s", [[Panel("empty", BLUE, None, "nothing")]])) as drawn:
        assert drawn.height > 100


def test_a_place_that_cannot_be_written(tmp_path):
    with pytest.raises(DataError, match="Cannot write"):
        draw_panel_sheet(tmp_path / "nowhere" / "a.png", "T", "s", [[Panel("a", BLUE, IMAGE)]])


def test_places_in_words():
    assert [place_text(one) for one in (None, 12.0, 12.5, (1.0, 2.25))] == ["", "12", "12.5", "1.0, 2.2"]
