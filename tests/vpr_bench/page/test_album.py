"""Pictures are embedded once each, and as large as the room lets them be."""

from base64 import b64decode
from io import BytesIO

import numpy as np
import pytest
from PIL import Image

from vpr_bench.page.album import Album


def photo(number, width=960, height=540):
    """Return a picture that does not compress away."""
    coarse = np.random.default_rng(number).integers(0, 256, (height // 12, width // 12, 3), dtype=np.uint8)
    return np.asarray(Image.fromarray(coarse).resize((width, height), Image.Resampling.BICUBIC))


def total(pictures):
    return sum(len(one.content) for one in pictures.values())


@pytest.fixture
def album():
    made = Album()
    for number in range(12):
        made.add(number, lambda number=number: photo(number))
    return made


def test_the_same_picture_has_one_number_and_is_embedded_once():
    album = Album()
    assert [album.add(name, lambda: photo(0, 64, 48)) for name in "abab"] == [0, 1, 0, 1]
    assert list(album.embedded(10**6)) == [0, 1]


@pytest.mark.parametrize("room", [600_000, 200_000, 60_000, 30_000])
def test_all_pictures_fit_into_the_room(album, room):
    pictures = album.embedded(room)
    assert len(pictures) == 12
    assert total(pictures) <= room


def test_more_room_makes_larger_pictures(album):
    widths = [album.embedded(room)[0].width for room in (30_000, 120_000, 10**7)]
    assert widths == sorted(set(widths))
    assert widths[-1] == 480


def test_where_not_even_the_smallest_fit_the_last_are_left_out(album):
    pictures = album.embedded(5_000)
    assert 0 < len(pictures) < 12
    assert list(pictures) == list(range(len(pictures)))
    assert total(pictures) <= 5_000


def test_a_picture_says_its_size_and_is_never_enlarged():
    album = Album()
    album.add("small", lambda: photo(0, 60, 36))
    [one] = album.embedded(10**6).values()
    with Image.open(BytesIO(b64decode(one.content))) as picture:
        assert (picture.format, picture.size) == ("WEBP", (60, 36))
    assert (one.width, one.height) == (60, 36)


def test_a_picture_that_is_not_here_is_left_out():
    album = Album()
    album.add("gone", lambda: None)
    album.add("here", lambda: photo(0, 64, 48))
    assert list(album.embedded(10**6)) == [1]
    assert Album().embedded(10**6) == {}
