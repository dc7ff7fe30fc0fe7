import numpy as np
import pytest
from PIL import Image

from vpr_bench.compare import compare_runs, flip_sheet
from vpr_bench.compare.flip_sheet import draw_flips
from vpr_bench.report.ink import BLUE, GREEN, GREY, INK, RED


class Pictures:
    """Images of one colour, as far as there are any."""

    def __init__(self, here=True):
        self.case = here or None
        self.asked = []

    def query_name(self, query):
        return f"query{query}.jpg"

    def reference_name(self, reference):
        return f"reference{reference}.jpg"

    def query_image(self, query):
        self.asked.append(("query", query))
        return np.full((6, 8, 3), query, np.uint8) if self.case else None

    def reference_image(self, reference):
        self.asked.append(("reference", reference))
        return np.full((6, 8, 3), reference, np.uint8) if self.case else None


@pytest.fixture
def drawn(monkeypatch, tmp_path):
    """Draw, and return what the sheet was given."""

    def draw(comparison, pictures):
        given = {}
        real = flip_sheet.draw_panel_sheet

        def watch(file, title, said, rows, *, warning=""):
            given.update(title=title, said=said, rows=rows, warning=warning)
            return real(file, title, said, rows, warning=warning)

        monkeypatch.setattr(flip_sheet, "draw_panel_sheet", watch)
        with Image.open(draw_flips(comparison, pictures, tmp_path / "flips.png")) as sheet:
            assert sheet.format == "PNG"
        return given

    return draw


def test_a_row_per_query_with_both_answers_and_the_true_place(pair_of_runs, drawn):
    given = drawn(compare_runs(*pair_of_runs, resamples=5), Pictures())
    assert [row[0].title for row in given["rows"]] == [
        "Query 0: only A is right",
        "Query 1: only A is right",
        "Query 4: only B is right",
        "Query 5: only B is right",
        "Query 6: only B is right",
    ]
    assert [panel.colour for panel in given["rows"][0]] == [BLUE, GREEN, RED, INK]
    assert [panel.title for panel in given["rows"][2][1:]] == ["A: wrong", "B: right", "True place"]
    assert [panel.pixels[0, 0, 0] for panel in given["rows"][1]] == [1, 1, 5, 1]
    assert given["rows"][1][2].lines[1] == "reference5.jpg"
    assert given["title"] == "A  hog   ·   B  sad" and given["warning"] == ""
    assert "only by A 2, only by B 3" in given["said"] and "shown" not in given["said"]


def test_runs_of_one_label_are_named_by_their_folders(stored, drawn):
    runs = stored(folder="old"), stored(folder="new", first=[1] * 8)
    assert drawn(compare_runs(*runs, resamples=5), Pictures())["title"] == "A  hog (old)   ·   B  hog (new)"


def test_images_that_are_not_here_leave_spaces(pair_of_runs, drawn):
    given = drawn(compare_runs(*pair_of_runs, resamples=5), Pictures(here=False))
    assert all(panel.pixels is None and panel.empty == "image not here" for row in given["rows"] for panel in row)
    assert given["rows"][0][0].lines == ("", "") and given["rows"][0][1].lines[1] == ""


def test_no_answer(stored, drawn):
    given = drawn(compare_runs(stored(), stored(first=[-1, *range(1, 8)], label="sad"), resamples=5), Pictures())
    assert (given["rows"][0][2].title, given["rows"][0][2].colour) == ("B: no answer", GREY)


def test_of_many_some_are_shown_from_first_to_last(stored, drawn, monkeypatch):
    monkeypatch.setattr(flip_sheet, "MOST", 3)
    pictures = Pictures()
    given = drawn(compare_runs(stored(), stored(first=[-1] * 8, label="sad"), resamples=5), pictures)
    assert [number for kind, number in pictures.asked if kind == "query"] == [0, 4, 7]
    assert "up to 3 of each are shown" in given["said"]


def test_simulated_images_are_named(stored, drawn):
    protocol = "gardens:simulated/day_left-night_right@0f"
    runs = stored(protocol=protocol), stored(protocol=protocol, first=[1] * 8, label="sad")
    assert drawn(compare_runs(*runs, resamples=5), Pictures())["warning"] == "SIMULATED"
