from contextlib import contextmanager

import numpy as np
import pytest

from vpr_bench.dataset.lint import inspect_source
from vpr_bench.dataset.request import Request
from vpr_bench.dataset.source import Source
from vpr_bench.progress import listen
from vpr_bench.types import traverse


def test_nothing_is_wrong_with_a_clean_dataset(made):
    assert made.lint() == []


@pytest.mark.parametrize("edition", ["real", "simulated"])
def test_nothing_is_wrong_with_the_tiny_dataset(tiny_dataset, edition):
    found = inspect_source(Source.find(Request.parse("tiny", edition=edition)))
    assert (found.findings, found.images, found.traverses, len(found.protocols)) == ([], 36, 3, 2)


def test_only_what_the_protocols_use_is_looked_at(tiny_dataset):
    (tiny_dataset.folder / "night_right" / "Image001.jpg").write_bytes(b"")
    source = Source.find(Request.parse("tiny"))
    found = inspect_source(source, [source.card.protocol("day_left-day_right")])
    assert (found.findings, found.images) == ([], 24)


def test_parts_and_joined_traverses(made):
    made.protocols = [{"references": "day.every2+night", "queries": "night.first3", "radius": 1}]
    assert [one.check for one in made.lint()] == ["duplicate", "reference-never-matched"]


def test_every_image_is_decoded_once(made, monkeypatch):
    decoded, decode = [], traverse.decode_image
    monkeypatch.setattr(traverse, "decode_image", lambda file: decoded.append(file) or decode(file))
    made.protocols += [{"references": "night", "queries": "day", "radius": 2}]
    assert made.lint() == []
    assert len(decoded) == len(set(decoded)) == 20


def test_the_worst_comes_first(made):
    (made.folder / ".DS_Store").touch()
    made.paint("day", 3, np.zeros((24, 32, 3), np.uint8))
    made.image("night", 3).write_bytes(b"")
    assert [one.severity for one in made.lint()] == ["error", "warning", "note"]


def test_progress_is_told(made):
    bars = {}

    @contextmanager
    def listener(description, total):
        bars[description] = [total, 0]

        def advance(steps):
            bars[description][1] += steps

        yield advance

    with listen(listener):
        made.lint()
    assert bars == {"Decoding day": [10, 10], "Decoding night": [10, 10]}


def test_real_gardens_repeats_one_image(real_gardens):
    found = inspect_source(Source.find(Request.parse("gardens")))
    assert [(one.check, one.where) for one in found.findings] == [("duplicate", "night_right")]
    assert "night_right/Image183.jpg is night_right/Image179.jpg" in found.findings[0].message
