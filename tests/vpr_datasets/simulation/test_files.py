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
