"""The page of results says what the tables of measurements say."""

import re
import sys
from importlib import import_module
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
MODULES = ("cells", "measure", "page", "plan", "tables")


@pytest.fixture
def script(monkeypatch):
    """Return a function that imports a script of docs/results, as if it lay in the folder of the one that is run."""
    monkeypatch.syspath_prepend(DOCS / "results")
    for name in MODULES:
        monkeypatch.delitem(sys.modules, name, raising=False)
    yield import_module
    for name in MODULES:
        sys.modules.pop(name, None)


def test_the_page_is_written_from_the_measurements(script):
    page = (DOCS / "results.md").read_text("utf-8")
    assert page == script("page").filled(page), "it is stale: python docs/results/page.py"


def test_every_table_has_its_place(script):
    places = re.findall(r"<!-- table: (\w+) -->", (DOCS / "results.md").read_text("utf-8"))
    assert sorted(places) == sorted(script("tables").TABLES)


@pytest.mark.parametrize("page", ["results.md", "twostage.md"])
def test_pictures_are_there(page):
    pictures = re.findall(r"!\[[^]]+]\(([^)]+)\)", (DOCS / page).read_text("utf-8"))
    assert pictures and all((DOCS / picture).is_file() for picture in pictures)


def test_times_are_left_out_until_they_are_measured(script, monkeypatch, tmp_path):
    page = script("page")
    monkeypatch.setattr(script("cells"), "HERE", tmp_path)
    place = "<!-- table: latency -->\n<!-- end -->\n"
    assert page.filled(place) == place
    (tmp_path / "latency.csv").write_text("what,ms\none component,21.5\n", encoding="utf-8")
    filled = page.filled(place)
    assert "## Time" in filled and "| one component | 21.5 |" in filled
    assert page.filled(filled) == filled


def test_what_was_measured_before_stays_unless_it_is_measured_again(script, monkeypatch, tmp_path):
    measure = script("measure")
    for name in ("cells", "measure"):
        monkeypatch.setattr(script(name), "HERE", tmp_path)
    first, second, *_ = script("plan").variants()

    def line(variant, value):
        facts = {"part": variant.part, "variant": variant.name, "protocol": "p@2f", "radius": 2.0}
        return {**facts, "recall@1": value}

    measure.write_lines("runs.csv", [line(second, 0.25)])
    measure.write_lines("runs.csv", [line(first, 0.5), line(second, 1 / 3)])
    measure.write_lines("runs.csv", [{**line(first, 0.9), "variant": "no longer in the plan"}])
    found = [(one["variant"], one["recall@1"]) for one in script("cells").read("runs.csv")]
    assert found == [(first.name, "0.5"), (second.name, "0.333333")]


def test_every_variant_has_a_name_of_its_own(script):
    names = [(one.part, one.name) for one in script("plan").variants()]
    assert len(set(names)) == len(names)
