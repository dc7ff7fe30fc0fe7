import hashlib
from importlib.resources import files

import numpy as np
import pytest
from PIL import Image

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.errors import DataError
from vpr_datasets.layouts import numbered
from vpr_datasets.layouts.numbered import listed_frames, load

CARD = TraverseCard(name="day_left", images=200)
PATTERN = "Image{index:03d}.jpg"


@pytest.fixture
def folder(tmp_path):
    """Two hundred files; nothing decodes them."""
    folder = tmp_path / "day_left"
    folder.mkdir()
    for index in range(200):
        (folder / PATTERN.format(index=index)).write_bytes(b"x")
    return folder


def names(recording):
    return [source.name for source in recording.traverse.sources]


def refused(folder, card=CARD, **options):
    """Return the message of the error, one or two lines."""
    with pytest.raises(DataError) as caught:
        load(folder, card, PATTERN, **options)
    message = str(caught.value)
    assert str(folder) in message and message.count("\n") <= 1
    return message


def test_the_frames_come_in_the_order_of_their_numbers(folder):
    recording = load(folder, CARD, PATTERN)
    assert recording.traverse.name == "day_left"
    assert names(recording) == [f"Image{index:03d}.jpg" for index in range(200)]
    assert recording.labels.tolist() == list(range(200)) and recording.labels.dtype == float
    assert recording.compass is None


def test_numbers_are_sorted_as_numbers(tmp_path):
    for index in range(1, 12):
        (tmp_path / f"{index}.png").write_bytes(b"x")
    recording = load(tmp_path, TraverseCard(name="walk", images=11), "{index}.png", first=1)
    assert names(recording) == [f"{index}.png" for index in range(1, 12)]
    assert recording.labels.tolist() == list(range(1, 12))


def test_without_a_count_there_are_as_many_as_there_are(folder):
    card = TraverseCard(name="day_left")
    assert len(load(folder, card, PATTERN)) == 200
    (folder / "Image123.jpg").unlink()
    assert "Image123.jpg is missing; Image199.jpg is not of them." in refused(folder, card)


def test_a_missing_image_is_named(folder):
    (folder / "Image123.jpg").unlink()
    message = refused(folder)
    assert "must hold the 200 images Image000.jpg to Image199.jpg: found 199, Image123.jpg is missing." in message


def test_several_missing_images_are_counted(folder):
    for index in (7, 8, 150):
        (folder / f"Image{index:03d}.jpg").unlink()
    assert "found 197, Image007.jpg and 2 more are missing." in refused(folder)


def test_a_renamed_image_is_missing_and_one_too_many(folder):
    (folder / "Image050.jpg").rename(folder / "Copy of Image050.jpg")
    assert "found 200, Image050.jpg is missing; Copy of Image050.jpg is not of them." in refused(folder)


@pytest.mark.parametrize("name", ["Image200.jpg", "another.PNG", "Image1.tiff"])
def test_an_image_too_many_is_named(folder, name):
    (folder / name).write_bytes(b"x")
    assert f"found 201, {name} is not of them." in refused(folder)


def test_an_empty_folder_has_none(folder):
    for file in folder.iterdir():
        file.unlink()
    assert "found 0, Image000.jpg and 199 more are missing." in refused(folder)


def test_a_missing_folder_is_named(tmp_path):
    assert "is missing" in refused(tmp_path / "day_left")


def test_a_file_in_place_of_the_folder_is_as_good_as_none(tmp_path):
    (tmp_path / "day_left").write_text("x")
    assert "is missing" in refused(tmp_path / "day_left")


@pytest.mark.parametrize("junk", [".DS_Store", "Thumbs.db", "._Image000.jpg", ".hidden.png", "readme.txt", "notes"])
def test_what_is_no_image_of_the_camera_is_passed_by(folder, junk):
    (folder / junk).write_bytes(b"x")
    assert len(load(folder, CARD, PATTERN)) == 200


def test_a_step_is_kept_in_the_labels(tmp_path):
    for index in range(10, 100, 10):
        (tmp_path / f"images-{index:05d}.png").write_bytes(b"x")
    options = {"pattern": "images-{index:05d}.png", "first": 10, "step": 10}
    recording = load(tmp_path, TraverseCard(name="summer", images=9), **options)
    assert recording.labels.tolist() == list(range(10, 100, 10)) and names(recording)[1] == "images-00020.png"
    (tmp_path / "images-00050.png").rename(tmp_path / "images-00051.png")
    with pytest.raises(DataError, match=r"images-00050\.png is missing; images-00051\.png is not of them"):
        load(tmp_path, TraverseCard(name="summer", images=9), **options)


@pytest.fixture
def _listed(monkeypatch):
    """A list of five frames in two ranges, in place of Nordland's."""
    monkeypatch.setattr(numbered, "listed_frames", lambda name: {"some.txt": [2, 3, 4, 50, 51]}[name])


@pytest.mark.usefixtures("_listed")
def test_of_a_list_only_its_frames_are_used_and_labels_count_in_it(folder):
    recording = load(folder, CARD, PATTERN, frames="some.txt")
    assert names(recording) == [PATTERN.format(index=index) for index in (2, 3, 4, 50, 51)]
    assert recording.labels.tolist() == [0, 1, 2, 3, 4]  # 4 and 50 are neighbours: the train stood still between


@pytest.mark.usefixtures("_listed")
def test_a_listed_frame_that_is_missing_is_named(folder):
    (folder / "Image050.jpg").unlink()
    assert "the 5 images Image002.jpg to Image051.jpg: found 199, Image050.jpg is missing." in refused(
        folder, frames="some.txt"
    )


def test_nordlands_clean_list():
    frames = listed_frames("nordland_clean.txt")
    assert len(frames) == 27_592 and (frames[0], frames[-1]) == (202, 35_582)
    assert np.diff(frames).min() == 1 and (np.diff(frames) > 1).sum() + 1 == 182
    content = files("vpr_datasets.frames").joinpath("nordland_clean.txt").read_bytes()
    assert len(content.split()) == 182 and hashlib.sha256(content).hexdigest().startswith("573803f2d5b628f1")


@pytest.fixture
def tunnel(tmp_path, data_folder):
    """Four frames; the second is in a tunnel."""
    folder = tmp_path / "winter"
    folder.mkdir()
    for index, grey in enumerate((90, 3, 10, 200)):
        Image.new("RGB", (6, 4), (grey, grey, grey)).save(folder / f"{index}.png")
    return folder


def test_dark_frames_are_left_out_and_the_others_keep_their_labels(tunnel):
    card = TraverseCard(name="winter", images=4)
    recording = load(tunnel, card, "{index}.png", darkest=10)
    assert names(recording) == ["0.png", "2.png", "3.png"] and recording.labels.tolist() == [0, 2, 3]
    assert len(load(tunnel, card, "{index}.png")) == 4


def test_frames_are_decoded_once_to_find_the_dark_ones(tunnel, monkeypatch):
    card = TraverseCard(name="winter", images=4)
    first = load(tunnel, card, "{index}.png", darkest=10)
    monkeypatch.setattr("vpr_bench.types.traverse.decode_image", None)
    assert names(load(tunnel, card, "{index}.png", darkest=10)) == names(first)
    assert len(load(tunnel, card, "{index}.png", darkest=100)) == 1


def test_nothing_but_dark_frames_is_an_error(tunnel):
    with pytest.raises(DataError, match="All 4 images of winter are darker than 201 of 255"):
        load(tunnel, TraverseCard(name="winter", images=4), "{index}.png", darkest=201)


@pytest.mark.parametrize(
    "pattern",
    ["Image.jpg", "{index}/{index}.jpg", "../{index}.jpg", "{index:0300000000d}.jpg", "{index!r}", "{number}.png"],
)
def test_a_pattern_that_is_none_is_refused(folder, pattern):
    with pytest.raises(DataError, match="The pattern must be a file name"):
        load(folder, CARD, pattern)


@pytest.mark.parametrize("name", ["../../secret.txt", "/etc/passwd", "no_such.txt", "a/b.txt", ""])
def test_a_list_of_frames_is_one_of_ours(folder, name):
    with pytest.raises(DataError, match="There is no list of frames"):
        load(folder, CARD, PATTERN, frames=name)


def test_an_empty_folder_is_refused_however_many_there_may_be(tmp_path):
    with pytest.raises(DataError, match="holds no images"):
        load(tmp_path, TraverseCard(name="walk"), PATTERN)
