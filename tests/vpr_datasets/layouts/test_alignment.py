from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import DataError
from vpr_datasets.layouts.alignment import aligned, choose, id_of, number_in


def files(*names):
    return [Path("walk") / str(name) for name in names]


def frames(numbers, pattern="img{}.jpg"):
    return files(*(pattern.format(number) for number in numbers))


@pytest.mark.parametrize(
    ("name", "number"),
    [
        ("images-00202.png", 202),
        ("04FQ4NG5mYXOdbENCPup8w-640-00080.jpg", 80),
        ("2024-01-31 12.jpg", 12),
        ("library.jp2", None),
        ("cam0_7x.jpg", 7),
        ("frame٣.jpg", None),  # digits of other scripts are letters here
    ],
)
def test_the_last_number_in_a_name_counts(name, number):
    assert number_in(Path(name)) == number


def test_by_order_a_label_is_the_position():
    images, labels = aligned(files("b.jpg", "a.jpg"), "order")
    assert images == files("b.jpg", "a.jpg") and labels.tolist() == [0, 1] and labels.dtype == np.float64


def test_by_number_images_are_sorted_by_number():
    images, labels = aligned(files("b-2.jpg", "a-10.jpg", "c-1.jpg"), "number")
    assert [file.name for file in images] == ["c-1.jpg", "b-2.jpg", "a-10.jpg"] and labels.tolist() == [1, 2, 10]


@pytest.mark.parametrize(
    ("names", "align", "words"),
    [
        (["a1.jpg", "library.jpg"], "number", "library.jpg has no number in its name"),
        (["a9007199254740993.jpg"], "number", "has a number above 9007199254740991"),
        (["a1_640.jpg", "a2_640.jpg"], "number", "a2_640.jpg have the same number"),
        (["a.jpg", "a.png"], "stem", "a.jpg and a.png have the same name"),
        (["1.jpg", "01.jpg"], "stem", "have the same name"),
    ],
)
def test_labels_that_would_mix_places_up_are_refused(names, align, words):
    with pytest.raises(DataError, match=words):
        aligned(files(*names), align)


names = st.text(st.characters(blacklist_characters="/\0."), min_size=1, max_size=8)


@given(names, names)
def test_names_are_the_same_place_if_they_are_the_same(one, other):
    assert id_of(Path(f"old/{one}.jpg")) == id_of(Path(f"new/{one}.png"))
    assert 0 <= id_of(Path(one)) < 2**53 and float(id_of(Path(one))) == id_of(Path(one))
    if one.isalpha() and other.isalpha() and one.isascii() and other.isascii():
        assert (id_of(Path(one)) == id_of(Path(other))) == (one == other)


def test_ids_of_names_stay_what_they_are():
    # Stored runs hold them.
    assert [id_of(Path(f"{name}.png")) for name in ("0042", "library", "9" * 30)] == [
        42,
        7020610709505841,
        6263933653549437,
    ]
    assert id_of(Path("cafe\N{COMBINING ACUTE ACCENT}.jpg")) == id_of(
        Path("caf\N{LATIN SMALL LETTER E WITH ACUTE}.jpg")
    )


SEQUENCE = range(200)
GAPS = [number for number in range(300) if number % 7 not in (3, 4)]


@pytest.mark.parametrize(
    ("folders", "chosen"),
    [
        # Gardens Point: as many images, counted alike.
        ([frames(SEQUENCE), frames(SEQUENCE), frames(SEQUENCE)], ("order", "f")),
        # Berlin: each part of its own sequence.
        ([frames(range(400, 467), "x-640-{}.jpg"), frames(range(136, 203), "y-640-{}.jpg")], ("order", "f")),
        # Every tenth frame of both: neighbours are neighbours in the folder.
        ([frames(range(10, 900, 10)), frames(range(10, 900, 10))], ("order", "f")),
        # Every tenth frame of the one is looked up in all of the other.
        ([frames(SEQUENCE), frames(range(0, 200, 10))], ("number", "f")),
        # A frame is lost.
        ([frames(SEQUENCE), frames([number for number in SEQUENCE if number != 37])], ("number", "f")),
        ([frames(SEQUENCE, "day{}.jpg"), frames(GAPS, "night{}.jpg")], ("number", "f")),
        # AmsterTime: numbers with gaps, partners missing.
        ([frames(GAPS, "{:04d}.png"), frames(GAPS[5:], "{:04d}.jpg")], ("stem", "pair")),
        ([frames(GAPS, "new{}.png"), frames(GAPS[5:], "old{}.jpg")], ("number", "pair")),
        # Names without numbers.
        ([files("cafe.jpg", "library.jpg"), files("cafe.png", "library.png", "pier.png")], ("stem", "pair")),
        # Two words of two folders: only the order is left.
        ([files("a.jpg", "b.jpg"), files("c.jpg", "d.jpg")], ("order", "f")),
        # Frames of two videos of different length: that both are counted from 0 says nothing.
        ([frames(SEQUENCE), frames(range(150))], None),
        ([frames(SEQUENCE), frames(range(1000, 1050))], None),
        ([frames(SEQUENCE), files("a.jpg", "b.jpg")], None),
        # One folder among three does not fit.
        ([frames(GAPS), frames(GAPS), files("a.jpg")], None),
        # The same name twice in a folder.
        ([files("a.jpg", "a.png", "b.jpg"), files("a.jpg", "b.jpg")], None),
    ],
)
def test_what_names_and_counts_speak_for(folders, chosen):
    assert choose(folders) == chosen


@given(st.lists(st.lists(st.integers(0, 30), unique=True, min_size=1, max_size=12), min_size=2, max_size=3))
def test_what_is_chosen_can_always_be_done(numbers):
    folders = [frames(sorted(one)) for one in numbers]
    chosen = choose(folders)
    if chosen is not None:
        labels = [aligned(one, chosen[0])[1] for one in folders]
        assert all(len(set(one)) == len(one) for one in labels)
        assert all(set(labels[0]) & set(one) for one in labels[1:])
