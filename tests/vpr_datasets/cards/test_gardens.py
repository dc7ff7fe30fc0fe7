import pytest

import vpr_datasets.cards
from vpr_bench.dataset.card import DATASETS, Card, find_card


@pytest.fixture(scope="module")
def card():
    return find_card("gardens")


def test_it_is_the_registered_dataset(card):
    assert isinstance(card, Card) and card == vpr_datasets.cards.gardens
    assert DATASETS.entry("gardens").origin.startswith("vpr-bench ")


def test_it_has_three_protocols_the_hard_one_first(card):
    pairings = [f"{one.references}-{one.queries}" for one in card.protocols]
    assert pairings == ["day_left-night_right", "day_right-night_right", "day_left-day_right"]
    assert str(card.protocol()) == "gardens/day_left-night_right@2f"
    assert {card.protocol(pairing).radius for pairing in pairings} == {2}


def test_it_knows_three_traverses_of_200_images_by_their_digests(card):
    assert [one.name for one in card.traverses] == ["day_left", "day_right", "night_right"]
    assert {one.images for one in card.traverses} == {200}
    assert len({one.digest for one in card.traverses} - {None}) == 3


def test_it_has_the_published_numbers_of_the_default_protocol(card):
    numbers = {one.method: (one.metric, one.value) for one in card.published}
    assert numbers["two-stage, 7 components"] == ("pr_auc_matched", 0.85)
    assert numbers["two-stage, 1 component"] == ("pr_auc_matched", 0.64)
    assert {value for method, (_, value) in numbers.items() if method.startswith("Region-VLAD")} == {0.654, 0.7225}
    for one in card.published:
        assert (one.references, one.queries) == ("day_left", "night_right") and one.source


def test_it_says_where_the_images_come_from(card):
    assert card.citation and card.licence and card.homepage.startswith("https://doi.org/")
    assert card.download.url.endswith(".zip")
    assert "GardensPoint_Walking" in card.folders


def test_there_is_no_card_of_another_name():
    with pytest.raises(AttributeError, match="there is no card 'nowhere'"):
        vpr_datasets.cards.nowhere  # noqa: B018
