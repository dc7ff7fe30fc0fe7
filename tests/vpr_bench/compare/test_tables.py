import io

from rich.console import Console

from vpr_bench.compare import compare_runs
from vpr_bench.compare.tables import MOST, comparison_grids
from vpr_bench.runner.provenance import Provenance


def name_of(query):
    return f"night_right/Image{query:03d}.jpg"


def test_the_runs_the_metrics_the_times_and_both_ways(pair_of_runs):
    grids = comparison_grids(compare_runs(*pair_of_runs, resamples=50), name_of)
    assert grids[0].title == "gardens/day_left-night_right@0f  8 queries"
    assert [row[0] for row in grids[0].rows] == ["A  hog", "B  sad"]
    assert [grid.title for grid in grids[1:]] == [
        "is B better?",
        "is B faster?",
        "2 queries that only A answers right",
        "3 queries that only B answers right",
    ]
    recall = next(row for row in grids[1].rows if row[0] == "recall@1")
    assert recall[1:4] == ["0.500", "0.625", "+0.125"] and recall[-1] == "unclear"
    assert "2 both, 2 only A, 3 only B, 1 neither; McNemar's exact test: p = 1.000" in grids[1].note
    assert "not adjusted" in grids[1].note
    assert "bench methods" in grids[2].note
    assert grids[3].rows[1][0] == "1  night_right/Image001.jpg"


def test_which_is_better(stored):
    good, bad = stored(), stored(first=[7 - place for place in range(8)], label="sad")
    for runs, better in (((bad, good), "B"), ((good, bad), "A")):
        grid = comparison_grids(compare_runs(*runs, ["recall@1"], resamples=300), name_of)[1]
        assert grid.rows[0][-1] == better and "not adjusted" not in grid.note


def test_names_with_markup_are_text(stored):
    runs = stored(label="[red]x\n\x1b[2J"), stored(label="<b>|y", first=[0] * 8)
    out = io.StringIO()
    grids = comparison_grids(compare_runs(*runs, ["recall@1"], resamples=5), lambda query: f"[bold]{query}")
    for grid in grids:
        Console(file=out, width=150).print(grid.rich())
    text = out.getvalue()
    assert "[red]x" in text and "\x1b[2J" not in text and "[bold]3" in text
    assert "&lt;b&gt;&#124;y" in grids[0].markdown()


def test_runs_of_one_name_are_told_apart(stored):
    found = compare_runs(stored(folder="before/run"), stored(folder="after/run"), ["recall@1"], resamples=5)
    rows = comparison_grids(found, name_of)[0].rows
    assert rows[0][1].endswith("before/run") and rows[1][1].endswith("after/run")


def test_a_very_long_label_is_cut(stored):
    seconds = {"x" * 3000: 0.1, "total": 0.2}
    found = compare_runs(
        stored(label="long" * 700, seconds=seconds), stored(seconds=seconds), ["recall@1"], resamples=5
    )
    grids = comparison_grids(found, name_of)
    assert "…" in grids[0].rows[0][0] and max(len(cell) for grid in grids for row in grid.rows for cell in row) < 100


def test_a_long_list_says_how_many_more(stored, monkeypatch):
    monkeypatch.setattr("vpr_bench.compare.tables.MOST", 2)
    grids = comparison_grids(compare_runs(stored(), stored(first=[-1] * 8, label="sad"), resamples=5), name_of)
    assert len(grids[-1].rows) == 2 and grids[-1].note.startswith("6 more") and MOST == 20
    assert grids[-1].rows[0][3:5] == ["none", ""]


def test_queries_without_a_name_are_numbered_once(pair_of_runs):
    grids = comparison_grids(compare_runs(*pair_of_runs, resamples=5), lambda query: f"query {query}")
    assert [row[0] for row in grids[3].rows] == ["query 0", "query 1"]


def test_simulated_images_are_named_everywhere(stored):
    protocol = "gardens:simulated/day_left-night_right@0f"
    runs = stored(protocol=protocol), stored(protocol=protocol, first=[1] * 8, label="sad")
    grids = comparison_grids(compare_runs(*runs, resamples=5), name_of)
    assert all(grid.title.startswith("SIMULATED") for grid in grids)


def test_times_of_two_machines_are_not_in_a_table(stored):
    first = stored()
    other = first.record.machine.model_copy(update={"processor": "Other"})
    grids = comparison_grids(compare_runs(first, stored(machine=other, label="sad"), resamples=5), name_of)
    assert not any("faster" in grid.title for grid in grids)
    assert "times are not compared: A ran on One" in grids[1].note


def test_what_to_be_careful_of(stored):
    busy = Provenance(elsewhere=0.5)
    runs = stored(), stored(label="sad", limit=None, provenance=busy, record={"order": "sequential", "partial": True})
    metrics, times = comparison_grids(compare_runs(*runs, ["recall@10", "recall@100p"], resamples=5), name_of)[1:3]
    assert "careful: other processes took 50%" in times.note
    for said in ("–: undefined", "B answered with the help of neighbouring frames", "do not trust its interval"):
        assert said in metrics.note
