import pytest

from vpr_bench.dataset.card import Card
from vpr_bench.dataset.describe_own import card_content
from vpr_bench.errors import DataError
from vpr_datasets.layouts.positioned import Found, positioned


def card(tmp_path, *traverses):
    return Card.model_validate(card_content(tmp_path, "utm", positioned("positions", traverses)))


def test_every_traverse_gets_a_name_of_its_own(tmp_path):
    labels = ["Day 1", "day_1", "DAY-1", "日本", "中国"]
    made = card(tmp_path, *(Found(label, label, 3) for label in labels))
    assert [one.name for one in made.traverses] == ["day_1", "day_1_2", "day_1_3", "traverse", "traverse_2"]
    assert [one.folder for one in made.traverses] == labels


def test_the_map_is_found_by_what_its_owner_calls_it(tmp_path):
    made = card(tmp_path, Found("Queries", "Queries", 2), Found("Database", "Database", 3))
    assert [str(one) for one in made.listed_protocols()] == [f"{made.id}/database-queries@25m"]


@pytest.mark.parametrize("names", [[], ["alone"]])
def test_too_few_traverses_are_none(names):
    assert positioned("positions", [Found(name, name, 1) for name in names]) is None


@pytest.mark.parametrize("name", ["a:b", "a\\b", "a\udcff"])
def test_a_name_that_no_card_can_hold_is_told(name):
    with pytest.raises(DataError, match="rename it"):
        positioned("positions", [Found("x", "x", 1), Found(name, name, 1)])
