from vpr_bench.dataset.card import Published, find_card
from vpr_bench.report.published import published_for, with_sources
from vpr_bench.types.protocol import Protocol

PROTOCOL = Protocol.parse("own/a-b@25m")


def published(metric="pr_auc", source="Book", radius=None):
    return Published(
        references="a", queries="b", method="theirs", metric=metric, value=0.5, source=source, radius=radius
    )


def test_each_source_has_one_number_and_its_radius_a_unit():
    rows = [published(), published(radius=25), published("recall@1")]
    shown, sources = with_sources(rows, ("pr_auc", "recall@1"), PROTOCOL)
    assert shown == list(zip(rows, (1, 2, 1), strict=True))
    assert sources == ["Book, radius not stated", "Book, radius 25m"]


def test_sources_of_what_is_not_shown_are_not_listed():
    shown, sources = with_sources([published("roc_auc", "Other"), published()], ("pr_auc",), PROTOCOL)
    assert [(one.metric, number) for one, number in shown] == [("pr_auc", 1)]
    assert sources == ["Book, radius not stated"]


def test_a_source_is_on_one_line():
    assert with_sources([published(source="two\nlines\x1b[31m")], ("pr_auc",), PROTOCOL)[1] == [
        "two lines[31m, radius not stated"
    ]


def test_only_the_same_pairing_and_radius_of_the_real_edition():
    card = find_card("gardens")
    assert published_for(card, Protocol.parse("gardens/day_left-night_right@2f"))
    assert published_for(card, Protocol.parse("gardens/night_right-day_left@2f")) == []
    assert published_for(card, Protocol.parse("gardens:simulated/day_left-night_right@2f")) == []
    stated = [one.model_copy(update={"radius": 2.0}) for one in card.published]
    card = card.model_copy(update={"published": stated})
    assert published_for(card, Protocol.parse("gardens/day_left-night_right@2f")) == stated
    assert published_for(card, Protocol.parse("gardens/day_left-night_right@3f")) == []
