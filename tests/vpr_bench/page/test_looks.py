"""Methods can be told apart without colours."""

from vpr_bench.page.embedding import as_json
from vpr_bench.page.looks import COLOURS, DASHES, MARKERS, displayed, looks
from vpr_bench.page.page import asset


def test_no_two_of_72_methods_look_alike():
    found = looks(map(str, range(72)))
    assert len(set(found.values())) == 72


def test_methods_of_one_colour_differ_in_dash_or_marker():
    found = list(looks(map(str, range(2 * COLOURS))).values())
    for one, other in zip(found[:COLOURS], found[COLOURS:], strict=True):
        assert one.colour == other.colour
        assert (one.dash, one.marker) != (other.dash, other.marker)


def test_a_name_that_would_turn_text_around_does_not():
    assert displayed("a\u202eb\nc") == "ab c"
    assert displayed("\u202e") == "?"


def test_the_style_sheets_and_the_script_know_every_look():
    for sheet in ("page.css", "dark.css"):
        assert [f"--method-{number}:" in asset(sheet) for number in range(COLOURS + 1)] == [True] * COLOURS + [False]
    script = asset("legend.js")
    for name, count in (("DASHES", DASHES), ("STROKES", DASHES), ("MARKERS", MARKERS), ("GLYPHS", MARKERS)):
        line = next(line for line in script.splitlines() if line.startswith(f"const {name} = "))
        assert line.count('"') == 2 * count, as_json(line)
