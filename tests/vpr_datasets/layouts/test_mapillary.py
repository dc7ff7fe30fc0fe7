import json
import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.describe_own import describe_own
from vpr_bench.dataset.load import DatasetWarning
from vpr_bench.errors import DataError
from vpr_datasets.layouts.mapillary import load, recognise

CARD = TraverseCard(name="side_1")
KEY = "04FQ4NG5mYXOdbENCPup8w"


def fix(index, **changed):
    return {"skey": KEY, "key": f"k{index}", "lat": 52.5 + index / 1e4, "lon": 13.3, "ca": 10.0 * index, **changed}


def write(folder, numbers, **changed):
    folder.mkdir(parents=True, exist_ok=True)
    for number in numbers:
        image = folder / f"{KEY}-640-{number:05d}.jpg"
        image.write_bytes(b"x")
        image.with_name(f"{image.name}.json").write_text(json.dumps(fix(number, **changed)))
    return folder


@pytest.fixture
def folder(tmp_path):
    return write(tmp_path / "place_1", range(8))


def refused(folder, card=CARD):
    with pytest.raises(DataError) as caught:
        load(folder, card, "33U")
    message = str(caught.value)
    assert str(folder) in message and message.count("\n") <= 1
    return message


def test_images_come_in_order_with_metres_and_compass(folder):
    recording = load(folder, CARD, "33U")
    assert [source.name[-9:-4] for source in recording.traverse.sources] == [f"{n:05d}" for n in range(8)]
    assert recording.labels.shape == (8, 2) and recording.labels.dtype == np.float64
    np.testing.assert_allclose(np.linalg.norm(np.diff(recording.labels, axis=0), axis=1), 11.1, atol=0.1)
    np.testing.assert_allclose(recording.compass, np.arange(8) * 10.0)


def test_frame_numbers_are_numbers(tmp_path):
    for number in (2, 10, 1):
        (tmp_path / f"{KEY}-{number}.jpg").write_bytes(b"x")
        (tmp_path / f"{KEY}-{number}.jpg.json").write_text(json.dumps(fix(number)))
    recording = load(tmp_path, CARD, "33U")
    assert [source.stem[-2:] for source in recording.traverse.sources] == ["-1", "-2", "10"]


@given(st.integers(0, 2**32), st.integers(2, 9))
def test_the_order_in_which_files_are_written_changes_no_label(tmp_path_factory, seed, count):
    folder = tmp_path_factory.mktemp("place")
    order = list(range(count))
    random.Random(seed).shuffle(order)  # noqa: S311 - no secret
    recording = load(write(folder, order), CARD, "33U")
    labels = {source.name: label for source, label in zip(recording.traverse.sources, recording.labels, strict=True)}
    for number in order:
        alone = load(write(folder.with_name(f"{folder.name}-{number}"), [number]), CARD, "33U")
        np.testing.assert_array_equal(labels[alone.traverse.sources[0].name], alone.labels[0])


@pytest.mark.parametrize(("angle", "expected"), [(-90, 270), (360, 0), (725.5, 5.5), (-1e-300, 0)])
def test_the_compass_is_turned_into_one_circle(tmp_path, angle, expected):
    assert load(write(tmp_path / "a", [1], ca=angle), CARD, "33U").compass.tolist() == [expected]


def test_without_a_compass_there_is_none(tmp_path):
    assert load(write(tmp_path / "a", [1, 2], ca=None), CARD, "33U").compass is None


def test_a_compass_that_some_images_lack_is_left_out_with_a_warning(folder):
    write(folder, [3], ca=None)
    with pytest.warns(DatasetWarning, match="1 of the 8 images"):
        assert load(folder, CARD, "33U").compass is None


@pytest.mark.parametrize(
    "junk",
    [".DS_Store", "._a.jpg", "._a.jpg.json", "Thumbs.db", "gt.csv", "features.pkl", "list.json", "a.json", "notes"],
)
def test_what_is_no_image_is_passed_by(folder, junk):
    (folder / junk).write_bytes(b"\x80")
    assert len(load(folder, CARD, "33U")) == 8


def test_an_image_without_json_is_named(folder):
    for number in (2, 5, 6):
        (folder / f"{KEY}-640-{number:05d}.jpg.json").unlink()
    assert "00002.jpg has no" in refused(folder) and "(and 2 more with faults)" in refused(folder)


def test_json_without_an_image_is_named(folder):
    (folder / f"{KEY}-640-00004.jpg").unlink()
    assert "00004.jpg.json has no image beside it" in refused(folder)


@pytest.mark.parametrize(
    ("content", "why"),
    [
        ("", "is not JSON"),
        ("{", "is not JSON"),
        ("[" * 100_000, "is not JSON"),
        ("[1]", "is not a JSON object"),
        ("null", "is not a JSON object"),
        ('{"lat": ' + "9" * 5000 + "}", "is not JSON"),
        ("{}", "'lat' must be a number of degrees, found None"),
        (json.dumps(fix(1, lat="52.5")), "'lat' must be a number of degrees, found '52.5'"),
        (json.dumps(fix(1, lon=None)), "'lon' must be a number"),
        (json.dumps(fix(1, lon=True)), "'lon' must be a number"),
        (json.dumps(fix(1, lat=float("nan"))), "'lat' must be a number of degrees, found nan"),
        (json.dumps(fix(1, lat=10**300)), "'lat' must be a number"),
        (json.dumps(fix(1, ca="north")), "'ca' must be a number"),
        (json.dumps(fix(1, lat=0, lon=0)), "no fix"),
        (json.dumps(fix(1, lat=-52.5)), "sign looks wrong"),
        (json.dumps(fix(1, lat=95)), "out of range"),
        (json.dumps(fix(1, lon=50)), "more than 6 degrees"),
    ],
)
def test_json_without_a_position_is_named(folder, content, why):
    for number in (3, 4):
        (folder / f"{KEY}-640-{number:05d}.jpg.json").write_text(content)
    message = refused(folder)
    assert why in message and "00003.jpg.json" in message and "(and 1 more with faults)" in message
    assert len(message) < 600


def test_the_card_may_say_how_many_there_are(folder):
    assert "must hold the 81 images of side_1: found 8" in refused(folder, TraverseCard(name="side_1", images=81))


def test_an_empty_and_a_missing_folder_are_refused(tmp_path):
    assert "holds no images" in refused(tmp_path)
    assert "is missing" in refused(tmp_path / "none")


@pytest.mark.parametrize("deeper", ["", "berlin_A100"])
def test_folders_are_recognised_one_and_two_levels_down(tmp_path, deeper):
    write(tmp_path / deeper / "berlin_A100_1", range(4))
    write(tmp_path / deeper / "berlin_A100_2", range(5))
    (tmp_path / "other").mkdir()
    card = describe_own(tmp_path, "mapillary").card
    assert card.loader.options == {"zone": "33U"} and card.unit == "m"
    assert [(one.name, one.images) for one in card.traverses] == [("berlin_a100_1", 4), ("berlin_a100_2", 5)]
    assert [(one.references, one.queries, one.radius) for one in card.protocols] == [
        ("berlin_a100_1", "berlin_a100_2", 25)
    ]
    assert len(load(tmp_path / card.traverses[1].path, card.traverses[1], **card.loader.options)) == 5


def test_places_are_not_looked_up_in_each_other(tmp_path):
    for place in ("a100", "kudamm"):
        for side in ("1", "2"):
            write(tmp_path / place / side, range(3))
    card = describe_own(tmp_path, "mapillary").card
    pairs = [(one.references, one.queries) for one in card.protocols]
    assert pairs == [("1", "2"), ("kudamm_1", "kudamm_2")]


def test_a_damaged_first_file_is_told_and_not_passed_over(tmp_path):
    for side in ("a", "b"):
        write(tmp_path / side, range(3))
    (tmp_path / "a" / f"{KEY}-640-00000.jpg.json").write_text("{")
    with pytest.raises(DataError, match=r"00000\.jpg\.json: it is not JSON"):
        recognise(tmp_path)


@pytest.mark.parametrize("content", ["{}", '{"objects": []}', '{"geoData": {"latitude": 1}}', "[]"])
def test_other_json_beside_images_is_not_this_layout(tmp_path, content):
    for side in ("a", "b"):
        (tmp_path / side).mkdir()
        (tmp_path / side / "1.jpg").write_bytes(b"x")
        (tmp_path / side / "1.jpg.json").write_text(content)
    assert recognise(tmp_path) is None


def test_one_folder_and_none_are_not_recognised(tmp_path):
    assert recognise(tmp_path) is None
    write(tmp_path / "a", [1])
    assert recognise(tmp_path) is None
    assert recognise(tmp_path / "missing") is None
