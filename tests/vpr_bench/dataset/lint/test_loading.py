import shutil
import warnings

import pytest

from vpr_bench.dataset.known import known_digest
from vpr_bench.dataset.lint import lint_source
from vpr_bench.dataset.request import Request
from vpr_bench.dataset.source import Source


def test_a_traverse_that_is_gone_is_one_error_for_all_its_protocols(made):
    shutil.rmtree(made.folder / "night")
    made.protocols += [{"references": "night", "queries": "day", "radius": 1}]
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("does-not-load", "error", "night")
    assert finding.message.endswith("night is missing.")


def test_what_else_there_is_is_looked_at(made):
    shutil.rmtree(made.folder / "night")
    made.image("day", 4).write_bytes(b"")
    assert [(one.check, one.where) for one in made.lint()] == [
        ("does-not-load", "night"),
        ("does-not-decode", "day/04.png"),
    ]


def test_a_protocol_that_makes_every_answer_right(made):
    made.protocols += [{"references": "night", "queries": "day", "radius": 50}]
    finding = made.only()
    assert (finding.check, finding.where) == ("does-not-load", "made/night-day@50f")
    assert "reaches over the whole map" in finding.message


def test_a_ground_truth_that_cannot_be_read(made):
    made.given = {"lists": [[99]] * 10}
    assert made.only().check == "does-not-load"


def test_references_past_the_end(made):
    made.given = {"lists": [[one] for one in range(10)], "warning": "references 10, 11 do not exist: clipped"}
    finding = made.only()
    assert (finding.check, finding.severity) == ("references-past-the-end", "warning")
    assert finding.message == "references 10, 11 do not exist: clipped"


def test_what_a_layout_warns_of_is_found_once(made):
    made.options["day"] = {"warning": "one place was spoilt"}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("layout-warning", "warning", "day")


def test_other_warnings_go_on(made, monkeypatch):
    from vpr_bench.dataset.lint import loading

    load = loading.load_traverse

    def deprecated(*arguments):
        warnings.warn("old", DeprecationWarning, stacklevel=2)
        return load(*arguments)

    monkeypatch.setattr(loading, "load_traverse", deprecated)
    with pytest.warns(DeprecationWarning, match="old"):
        assert made.lint() == []


def test_another_copy_than_the_card_knows(tiny_dataset):
    image = tiny_dataset.folder / "day_left" / "Image001.jpg"
    image.write_bytes(image.read_bytes() + b"\0")
    (finding,) = lint_source(Source.find(Request.parse("tiny")))
    assert (finding.check, finding.severity, finding.where) == ("another-copy", "warning", "day_left")


def test_to_look_is_not_to_meet(tiny_dataset, monkeypatch):
    source = Source.find(Request.parse("tiny"))
    unknown = [one.model_copy(update={"digest": None}) for one in source.card.traverses]
    card = source.card.model_copy(update={"traverses": unknown})
    assert lint_source(Source(card, "real", card)) == []
    assert known_digest("tiny/day_left") is None
