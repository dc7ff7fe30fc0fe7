"""A section holds what can be shown of a protocol, and says what cannot."""

import pytest

from vpr_bench.leaderboard.machines import machine_letters
from vpr_bench.page.album import Album
from vpr_bench.page.gallery import Galleries
from vpr_bench.page.looks import looks
from vpr_bench.page.section import section

pytestmark = pytest.mark.usefixtures("tiny")


def sections(made, runs=None, warn=pytest.fail):
    """Return the sections of boards, and the album that holds their pictures."""
    entries = [one.entry for board in made.boards for one in board.standings]
    album = Album()
    known = made.runs if runs is None else runs
    drawn, letters, galleries = looks(one.method for one in entries), machine_letters(entries), Galleries(album, warn)
    return [section(board, known, letters, drawn, galleries) for board in made.boards], album


def test_every_chart_has_its_numbers(made):
    day = sections(made)[0][0]
    assert [chart.id for chart in day.charts] == ["curves", "radius", "recalls", "latency", "losses"]
    for chart in day.charts:
        assert chart.numbers.rows
        assert all(len(row) == len(chart.numbers.head) for row in chart.numbers.rows)


def test_the_numbers_are_those_of_the_metrics(made):
    grids = {chart.id: chart.numbers for chart in sections(made)[0][0].charts}
    assert grids["curves"].rows[0] == ["best", *["1.000"] * 5]
    assert grids["recalls"].rows[0][:2] == ["best", "0.917"]
    assert grids["radius"].rows[0][2].startswith("0.917 · ")
    assert [row[0] for row in grids["latency"].rows][-1] == "best"  # the slowest
    assert grids["latency"].rows[-1][-1] == "yes"
    assert grids["losses"].rows[0][:2] == ["best", "0.917"]


def test_partial_and_busy_rows_are_in_no_chart_that_would_compare_them(made):
    data = sections(made)[0][0].data
    assert "partial" not in [one["method"] for one in data["methods"]]
    points = [point["method"] for plot in data["scatters"] for point in plot["points"]]
    assert "best" in points and "busy" not in points and "partial" not in points


def test_simulated_images_are_named_so_and_credited_to_us(made):
    *real, simulated = sections(made)[0]
    assert simulated.simulated and not any(one.simulated for one in real)
    assert simulated.credit == ["Rendered by vpr-bench: these are not photographs."]
    assert real[0].credit == ["Images: Tiny. none.", "Licence: CC0."]


def test_it_says_what_was_asked(made):
    day, night, _ = sections(made)[0]
    assert day.facts[0] == "Map: 12 references of day_left."
    assert day.facts[2] == "Two images at most 1 frame apart show the same place."
    assert night.dataset == "Tiny"


def test_it_says_what_becomes_of_queries_without_a_match_where_that_matters(made):
    day, night, _ = sections(made)[0]
    assert night.protocol.unmatched == "miss"
    assert night.facts[-1] == "Queries whose place the map does not show count as not found."
    assert not [fact for fact in day.facts if "does not show" in fact]


def test_without_runs_there_are_tables_and_times_only(made):
    found, album = sections(made, runs={})
    assert [chart.id for chart in found[0].charts] == ["latency"]
    assert found[0].missing == "None of the runs is here, so that there are no curves and pictures of them."
    assert len(album) == 0


def test_runs_that_are_not_here_are_named(made):
    best = {name: run for name, run in made.runs.items() if run.record.label == "best"}
    found, _ = sections(made, runs=best)
    assert found[1].missing == "Not here: the runs of second, so that there are no curves and pictures of them."


def test_a_run_that_was_made_on_another_machine_is_not_the_one_of_the_row(made, make_run):
    other = make_run("second", seed=1, order="sequential", wrong=9, memory=64)
    found, _ = sections(made, runs={other.folder.name: other})
    assert other.folder.name in made.runs
    assert found[0].data["methods"] == []


def test_a_picture_that_several_protocols_show_is_embedded_once(made):
    found, album = sections(made)
    shown = [
        panel["picture"]
        for one in found[:2]
        for method in one.data["methods"]
        for example in method["gallery"]["failures"] + method["gallery"]["successes"]
        for panel in example
    ]
    assert None not in shown
    assert len(album) <= 12 * 4 < len(shown)  # three traverses, and the simulated one's share


def test_images_that_have_gone_are_missed_once_and_named_by_number(made, tiny, monkeypatch, tmp_path):
    monkeypatch.setenv("VPR_BENCH_DATA", str(tmp_path))
    said = []
    found, _ = sections(made, warn=said.append)
    assert len(said) == len(set(said)) == 2  # two pairings of the real edition
    assert not found[0].data["pictures"]
    panels = found[0].data["methods"][0]["gallery"]["failures"][0]
    assert [panel["name"] for panel in panels] == ["query 11", "reference 5", "reference 11"]
    assert [panel["picture"] for panel in panels] == [None] * 3
