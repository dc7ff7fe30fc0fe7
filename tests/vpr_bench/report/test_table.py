import csv
import io
import json

from rich.console import Console

from vpr_bench.dataset.card import find_card
from vpr_bench.report.markdown import to_markdown
from vpr_bench.report.published import published_for
from vpr_bench.report.rows import score_run
from vpr_bench.report.table import render_tables, to_csv, to_json
from vpr_bench.types.protocol import Protocol


def _text(rows):
    console = Console(width=200, record=True, file=io.StringIO())
    console.print(render_tables(rows, {"gardens": find_card("gardens")}))
    return console.export_text()


def test_shows_measured_and_published_numbers_apart(stored):
    text = _text([score_run(stored())])
    assert "gardens/day_left-night_right@0f" in text
    assert "0.500" in text
    assert "two-stage, 7 components [1]" in text
    assert "radius not stated" in text


def test_one_table_per_protocol(stored):
    run = stored()
    text = _text([score_run(run, protocol=run.protocol.with_radius(radius)) for radius in (0, 2)])
    assert text.index("night_right@0f") < text.index("night_right@2f")


def test_published_numbers_never_stand_beside_simulated_ones(stored):
    simulated = "gardens:simulated/day_left-night_right@2f"
    assert "published" not in _text([score_run(stored(simulated))])
    assert published_for(find_card("gardens"), Protocol.parse(simulated)) == []


def test_partial_run_says_so(stored):
    assert "hog (partial)" in _text([score_run(stored(limit=4))])


def test_undefined_is_a_dash(stored):
    run = stored()
    assert "–" in _text([score_run(run, ["recall@1", "roc_auc"], run.protocol.with_radius(2))])


def test_intervals_stand_below_the_value(stored):
    assert "0.500" in (text := _text([score_run(stored(), ["recall@1"], resamples=100)]))
    assert ".00–1.00" in text


def test_markup_in_a_name_is_text(stored):
    assert "[bold]x[/bold]" in _text([score_run(stored(label="[bold]x[/bold]"))])


def test_json(stored):
    content = json.loads(to_json([score_run(stored())]))
    assert content[0]["method"] == "hog"
    assert content[0]["metrics"]["recall@1"] == 0.5


def test_csv_has_one_column_per_number(stored):
    rows = [score_run(stored(), ["recall@1"], resamples=50), score_run(stored(folder="b"), ["roc_auc"])]
    lines = list(csv.DictReader(io.StringIO(to_csv(rows))))
    assert lines[0]["recall@1"] == "0.5"
    assert float(lines[0]["recall@1_low"]) < 0.5
    assert lines[1]["recall@1"] == ""
    assert float(lines[0]["latency_total_p50"]) == 30.0


def test_foreign_labels_are_no_formulas_and_no_markup(stored):
    row = score_run(stored(label='=HYPERLINK("http://x") <b>|[a](b)'))
    line = next(csv.DictReader(io.StringIO(to_csv([row]))))
    assert line["method"].startswith("'=") and line["recall@1"] == "0.5"
    table = to_markdown([row])
    assert "<b>" not in table and "[a](" not in table and "recall@1" in table
    assert len({text.count("|") for text in table.splitlines()}) == 1


def test_fits_a_narrow_window(stored):
    console = Console(width=80, record=True, file=io.StringIO())
    console.print(render_tables([score_run(stored())], {"gardens": find_card("gardens")}))
    text = console.export_text()
    for whole in ("recall", "_matched", "0.500", "30.0", "two-stage"):
        assert whole in text
    assert "…" not in text


def test_no_rows():
    assert json.loads(to_json([])) == []


def test_images_that_differ_are_never_in_one_table(stored, monkeypatch):
    first, second = score_run(stored()), score_run(stored(folder="b"))
    assert _text([first, second]).count("4 references") == 1
    other = second.run.record.key.model_copy(update={"dataset_digest": "sha256:" + "1" * 64})
    object.__setattr__(second.run, "record", second.run.record.model_copy(update={"key": other}))
    assert _text([first, second]).count("4 references") == 2


def test_an_interval_that_is_undefined_is_left_out(stored):
    assert "nan" not in _text([score_run(stored(), ["pr_auc_pairs"], resamples=20)])
