import sys

import numpy as np
import pytest
from PIL import Image

from vpr_bench.check import Examination
from vpr_bench.check.dataset import DATASET_CHECKS, DatasetSubject, contents
from vpr_bench.dataset.card import Card
from vpr_bench.dataset.request import Request
from vpr_bench.dataset.source import Source
from vpr_bench.types.ground_truth import GroundTruth


def results(name, card=None, checks=None):
    source = Source.find(Request.parse(name))
    if card is not None:
        source = Source(card, source.edition, card)
    examination = Examination(DATASET_CHECKS, DatasetSubject(source), checks)
    return {check.id: examination.outcome(check.id) for check in examination.checks}


def not_passed(found):
    return {name: (one.result, one.reason) for name, one in found.items() if one.result != "pass"}


def test_the_real_edition(tiny_dataset):
    assert not_passed(results("tiny")) == {"renders-the-same": ("skip", "these images are not simulated")}


def test_the_simulated_edition_is_rendered_again(tiny_dataset):
    found = results("tiny:simulated")
    assert not_passed(found) == {}
    assert len(tiny_dataset.rendered) == 2


def test_a_folder_of_ones_own(tiny_images, data_folder):
    found = results(str(tiny_images))
    assert not_passed(found)["card-says-whose"] == ("skip", "it is a folder of one's own, without a card")
    assert {one.result for one in found.values()} == {"pass", "skip"}


def changed(card, **fields):
    return Card.model_validate({**card.model_dump(), **fields})


def test_a_card_that_does_not_say_whose_it_is(tiny_dataset):
    found = results("tiny", changed(tiny_dataset.card, licence=" ", citation=""))
    assert found["card-says-whose"].reason == "the card says nothing about: citation, licence"


@pytest.mark.parametrize(
    ("check", "reason"),
    [
        ("protocols-load", "DataError: "),
        ("ends-decode", "DataError: "),
    ],
)
def test_missing_images(tiny_dataset, check, reason):
    (tiny_dataset.folder / "day_left" / "Image011.jpg").unlink()
    found = results("tiny")
    assert found[check].result == "fail"
    assert found[check].reason.startswith(reason)
    assert {one.result for one in found.values()} == {"pass", "fail", "skip"}
    assert found["places-make-sense"].reason == "it builds on protocols-load, which fails"


def test_the_last_image_is_cut_off(tiny_dataset):
    file = tiny_dataset.folder / "night_right" / "Image011.jpg"
    file.write_bytes(file.read_bytes()[:500])
    found = results("tiny")
    assert found["ends-decode"].result == "fail"
    assert "Image011.jpg cannot be decoded" in found["ends-decode"].reason
    assert found["lint-finds-no-errors"].result == "skip"


def test_lint(tiny_dataset):
    for number in (4, 5):
        (tiny_dataset.folder / "day_left" / f"Image00{number}.jpg").write_bytes(b"")
    found = results("tiny")["lint-finds-no-errors"]
    assert found.result == "fail"
    assert found.reason.startswith("does-not-decode in day_left/Image004.jpg: ")


def test_no_query_has_a_match(tiny_dataset, monkeypatch):
    monkeypatch.setattr("vpr_bench.types.places.Places.ground_truth", lambda self, _: empty())
    found = results("tiny")["places-make-sense"]
    assert (found.result, found.reason) == ("fail", "tiny/day_left-day_right@1f: no query has a true match")


def empty():
    return GroundTruth.from_pairs([], [], 12, 12)


def test_files_that_are_not_what_they_were(tiny_dataset, monkeypatch):
    plain = contents.traverse_digest
    monkeypatch.setattr(
        contents, "traverse_digest", lambda one, afresh=False: "another" if afresh else plain(one, afresh=afresh)
    )
    found = not_passed(results("tiny"))["digests-repeat"]
    assert found == ("fail", "the files of day_left are not what they were when they were read last")


def test_places_that_change_from_one_time_to_the_next(tiny_dataset, monkeypatch):
    digests = iter("abcd")
    monkeypatch.setattr("vpr_bench.dataset.load.case_digest", lambda *arguments: next(digests))
    found = not_passed(results("tiny", checks=["digests-repeat"]))["digests-repeat"]
    assert found == ("fail", "tiny/day_left-day_right@1f is a… the first time and c… the second")


def test_a_protocol_that_is_not_found_by_its_id(tiny_dataset, monkeypatch):
    monkeypatch.setattr(Card, "protocol", lambda card, *arguments: card.listed_protocols()[0])
    found = results("tiny", checks=["protocol-ids-round-trip"])["protocol-ids-round-trip"]
    assert found.reason == ("who asks for tiny/day_left-night_right@1f~miss gets tiny/day_left-day_right@1f")


def test_a_renderer_that_draws_lots(tiny_dataset, monkeypatch):
    renderer = sys.modules["tiny_plugin"].Renderer

    def with_noise(self, folder):
        renderer.plain(self, folder)
        noise = np.random.default_rng().integers(0, 256, (48, 64, 3), dtype=np.uint8)
        Image.fromarray(noise).save(folder / "day_right" / "Image004.jpg")

    monkeypatch.setattr(renderer, "plain", renderer.render, raising=False)
    monkeypatch.setattr(renderer, "render", with_noise)
    found = results("tiny:simulated")
    assert not_passed(found) == {"renders-the-same": ("fail", "day_right is another one when it is rendered again")}
