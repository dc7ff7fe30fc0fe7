import pytest
from vpr_datasets.loaders.numbered import load

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.errors import DataError

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


def refused(folder, card=CARD, **options):
    """Return the message of the error, one or two lines."""
    with pytest.raises(DataError) as caught:
        load(folder, card, PATTERN, **options)
    message = str(caught.value)
    assert str(folder) in message and message.count("\n") <= 1
    return message


def test_the_frames_come_in_the_order_of_their_numbers(folder):
    traverse, labels = load(folder, CARD, PATTERN)
    assert traverse.name == "day_left"
    assert [source.name for source in traverse.sources] == [f"Image{index:03d}.jpg" for index in range(200)]
    assert labels.tolist() == list(range(200)) and labels.dtype == float


def test_numbers_are_sorted_as_numbers(tmp_path):
    for index in range(1, 12):
        (tmp_path / f"{index}.png").write_bytes(b"x")
    traverse, labels = load(tmp_path, TraverseCard(name="walk", images=11), "{index}.png", first=1)
    assert [source.stem for source in traverse.sources] == [str(index) for index in range(1, 12)]
    assert labels.tolist() == list(range(1, 12))


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
    assert "of the traverse 'day_left' is missing" in refused(tmp_path / "day_left")


def test_a_file_in_place_of_the_folder_is_as_good_as_none(tmp_path):
    (tmp_path / "day_left").write_text("x")
    assert "is missing" in refused(tmp_path / "day_left")


@pytest.mark.parametrize("junk", [".DS_Store", "Thumbs.db", "._Image000.jpg", ".hidden.png", "readme.txt", "notes"])
def test_what_is_no_image_of_the_camera_is_passed_by(folder, junk):
    (folder / junk).write_bytes(b"x")
    assert len(load(folder, CARD, PATTERN)[0]) == 200
