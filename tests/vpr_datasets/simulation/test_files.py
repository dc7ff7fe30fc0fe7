from pathlib import Path

import pytest
from pydantic import ValidationError

from vpr_datasets.simulation.files import Files


def test_the_first_image_has_the_first_number() -> None:
    files = Files(pattern="{traverse}/images-{number:05d}.png", first=1)
    assert files.path(Path("x"), "winter", 9) == Path("x/winter/images-00010.png")
    assert Files().path(Path("x"), "day", 0) == Path("x/day/Image000.jpg")
    assert files.lossless and not Files().lossless


@pytest.mark.parametrize(
    ("pattern", "words"),
    [
        ("{traverse}.jpg", "must hold"),
        ("{traverse}/{number}.bmp", "must hold"),
        ("{traverse}/{index}.png", "not a pattern"),
        ("../{traverse}/{number}.jpg", "stay inside"),
        ("/{traverse}/{number}.jpg", "stay inside"),
        ("{traverse}/{number}/{more}.jpg", "not a pattern"),
    ],
)
def test_unusable_patterns_are_refused(pattern: str, words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        Files(pattern=pattern)


def test_traverses_may_be_named_each_in_its_way() -> None:
    files = Files(patterns={"old": "old/{number:04d}.jpg", "new": "new/{number:04d}.png"}, first=1, skipped=(1, 3))
    assert [str(files.name("old", index)) for index in range(3)] == ["old/0002.jpg", "old/0004.jpg", "old/0005.jpg"]
    assert str(files.name("new", 0)) == "new/0002.png"
    assert str(files.name("other", 0)) == "other/Image002.jpg"
    assert not files.lossless


@pytest.mark.parametrize(
    ("patterns", "words"),
    [
        ({"a": "a.jpg"}, "must hold"),
        ({"a": "../{number}.jpg"}, "stay inside"),
        ({"a": "x/{number}.jpg", "b": "x/{number}.jpg"}, "two traverses"),
    ],
)
def test_unusable_patterns_of_traverses_are_refused(patterns: dict[str, str], words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        Files(patterns=patterns)
