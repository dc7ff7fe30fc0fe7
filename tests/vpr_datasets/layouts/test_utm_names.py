import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.describe_own import describe_own
from vpr_bench.dataset.load import DatasetWarning
from vpr_bench.errors import DataError
from vpr_datasets.layouts.utm_name import Name, parse_name
from vpr_datasets.layouts.utm_names import load, recognise

CARD = TraverseCard(name="database")
FULL = "@0500987.81@6959290.81@56@J@-27.50000@0153.01000@p{}@00@090@@@@20100909_084500@@.jpg"


def write(folder, *names):
    for name in names:
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(b"x")
    return folder


def refused(folder, **options):
    with pytest.raises(DataError) as caught:
        load(folder, CARD, **options)
    message = str(caught.value)
    assert str(folder) in message and message.count("\n") <= 1
    return message


def test_a_full_name_is_read():
    assert parse_name(FULL.format(1)) == Name(500987.81, 6959290.81, "56S", 90.0)


@pytest.mark.parametrize("name", ["@0@00002.3@@@@@1@@@@@@@@.jpg", "@0@2.3@.jpg", "@0.0@ 2.3@@.png", "@0@2.3@rest"])
def test_only_two_fields_are_needed(name):
    assert parse_name(name) == Name(0.0, 2.3, heading=pytest.approx(np.nan, nan_ok=True))


@given(st.floats(-1e7, 1e7), st.floats(-1e7, 1e7), st.floats(0, 359))
def test_what_is_written_into_a_name_is_read(east, north, heading):
    name = parse_name(f"@{east!r}@{north!r}@33@U@@@@@{heading!r}@@@@@@.jpg")
    assert (name.east, name.north, name.heading, name.zone) == (east, north, heading, "33N")


@pytest.mark.parametrize(
    "name", ["a.jpg", "", "@.jpg", "@1@.jpg", "@1@2.jpg", "x@1@2@.jpg", "@@@@.jpg", "@nan@1@.jpg", "@1@1e999@.jpg"]
)
def test_what_is_no_such_name_is_refused(name):
    with pytest.raises(ValueError, match="is not"):
        parse_name(name)


def test_images_lie_at_any_depth_and_are_sorted_by_path(tmp_path):
    names = ["b/@1@1@.jpg", "@9@9@.jpg", "b/c/d/@3@3@.JPG", "b-a/@2@2@.png"]
    recording = load(write(tmp_path / "database", *names), CARD)
    order = [source.relative_to(tmp_path / "database").as_posix() for source in recording.traverse.sources]
    assert order == sorted(names)
    assert recording.labels.tolist() == [[9, 9], [2, 2], [1, 1], [3, 3]] and recording.labels.dtype == np.float64
    assert recording.compass is None


@given(st.integers(0, 2**32))
def test_the_order_in_which_files_are_written_changes_nothing(tmp_path_factory, seed):
    names = [f"{index % 2}/@{index}@{index / 2}@.jpg" for index in range(6)]
    shuffled = list(names)
    random.Random(seed).shuffle(shuffled)  # noqa: S311 - no secret
    recording = load(write(tmp_path_factory.mktemp("database"), *shuffled), CARD)
    east = [float(source.name.split("@")[1]) for source in recording.traverse.sources]
    assert recording.labels.tolist() == [[value, value / 2] for value in east]
    assert [source.name for source in recording.traverse.sources] == [name[2:] for name in sorted(names)]


def test_a_folder_with_the_separator_in_its_name_does_no_harm(tmp_path):
    recording = load(write(tmp_path / "me@home" / "@7@7@", "@1@2@.jpg"), CARD)
    assert recording.labels.tolist() == [[1, 2]]


def test_headings_are_the_compass(tmp_path):
    write(tmp_path, FULL.format(1), FULL.format(2).replace("@090@", "@450@"))
    assert load(tmp_path, CARD).compass.tolist() == [90, 90]


@pytest.mark.parametrize("heading", ["", "None"])
def test_a_heading_that_some_lack_is_left_out_with_a_warning(tmp_path, heading):
    write(tmp_path, FULL.format(1), FULL.format(2).replace("@090@", f"@{heading}@"))
    with pytest.warns(DatasetWarning, match="1 of the 2 images"):
        assert load(tmp_path, CARD).compass is None


def test_a_name_without_a_position_is_told(tmp_path):
    write(tmp_path, "@1@1@.jpg", "a/map.png", "b/@x@1@.jpg", ".thumbs/t.jpg", "._@1@1@.jpg", "notes.txt")
    assert "a/map.png: the name is not like @UTM_east@UTM_north@.jpg (and 1 more with faults)" in refused(tmp_path)


def test_two_zones_cannot_be_compared(tmp_path):
    write(tmp_path, "@1@1@32@U@@.jpg", "@1@2@33@U@@.jpg")
    assert "different UTM zones, 32N and 33N" in refused(tmp_path)


def test_two_hemispheres_cannot_be_compared_but_two_bands_can(tmp_path):
    write(tmp_path, "@1@1@17@S@@.jpg", "@1@2@17@T@@.jpg", "@1@3@@@@.jpg")
    assert len(load(tmp_path, CARD)) == 3
    write(tmp_path, "@1@9@17@M@@.jpg")
    assert "17N and 17S" in refused(tmp_path)


def test_the_other_traverses_zone_counts_too(tmp_path):
    write(tmp_path, "@1@1@17@T@@.jpg")
    assert len(load(tmp_path, CARD, zone="17N")) == 1
    assert "17N and 18N" in refused(tmp_path, zone="18N")


def test_missing_and_empty_folders_and_too_few_images_are_told(tmp_path):
    assert "is missing" in refused(tmp_path / "none")
    assert "holds no images" in refused(tmp_path)
    write(tmp_path, "@1@1@.jpg")
    with pytest.raises(DataError, match="must hold the 7 images of database: found 1"):
        load(tmp_path, TraverseCard(name="database", images=7))


def test_links_to_folders_are_not_followed(tmp_path):
    write(tmp_path, "a/@1@1@.jpg")
    (tmp_path / "a" / "loop").symlink_to(tmp_path)
    assert len(load(tmp_path, CARD)) == 1


@pytest.mark.parametrize("place", ["", "images/test", "test"])
def test_database_and_queries_are_recognised(tmp_path, place):
    write(tmp_path / place / "queries", "@0@2.3@@@@@1@@@@@@@@.jpg")
    write(tmp_path / place / "database", "x/@0@1@.jpg", "y/@0@2@.jpg")
    if place:
        write(tmp_path / place / ".." / "train" / "database", "@5@5@.jpg")
    card = describe_own(tmp_path, "utm").card
    assert [(one.references, one.queries, one.radius) for one in card.protocols] == [("database", "queries", 25)]
    assert {one.name: one.images for one in card.traverses} == {"database": 2, "queries": 1}
    for one in card.traverses:
        assert len(load(tmp_path / one.path, one, **card.loader.options)) == one.images


def test_a_dataset_in_two_zones_is_told_where_it_is_recognised(tmp_path):
    write(tmp_path / "database", "@1@1@17@T@@.jpg")
    write(tmp_path / "queries", "@1@1@18@T@@.jpg")
    with pytest.raises(DataError, match="17N and 18N"):
        recognise(tmp_path)


def test_a_stray_image_does_not_hide_the_others(tmp_path):
    for side in ("database", "queries"):
        write(tmp_path / side, "map.png", "a/@1@1@.jpg", "a/@1@2@.jpg")
    traverse = recognise(tmp_path).traverses[0]
    with pytest.raises(DataError, match=r"map\.png: the name is not"):
        load(tmp_path / traverse["folder"], TraverseCard(**traverse))


def test_the_zone_is_remembered(tmp_path):
    for side in ("database", "queries"):
        write(tmp_path / side, FULL.format(1))
    assert recognise(tmp_path).options == {"zone": "56S"}


def test_other_folders_are_not_recognised(tmp_path):
    assert recognise(tmp_path) is None
    assert recognise(tmp_path / "missing") is None
    write(tmp_path, "database/1.jpg", "queries/@1@1@.jpg", "docs/me@home.txt")
    assert recognise(tmp_path) is None
