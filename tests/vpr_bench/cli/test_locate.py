import csv
import io
import json
import re
import shutil
import sys
from pathlib import Path

import pytest
from PIL import Image


def one_line(text):
    return re.sub(r"\s+", " ", text)


@pytest.fixture
def locate(vpr_bench, tiny_dataset, colours):
    """Ask a map of day_left, after it was fitted."""
    vpr_bench("fit", "--method", "colours", "--dataset", "tiny", "-o", "tiny.map")
    return lambda *words: vpr_bench("locate", "tiny.map", *map(str, words))


@pytest.fixture
def photos(tiny_images):
    return [tiny_images / "day_right" / f"Image{number:03d}.jpg" for number in (2, 7)]


def test_ranked_places_with_scores_and_times(locate, photos):
    done = locate(*photos, "-k", 3, "--format", "json")
    assert done.code == 0
    said = json.loads(done.out)
    assert (said["map"], said["method"], said["n_references"]) == ("tiny.map", "colours", 12)
    assert said["load_ms"] > 0
    for answer, photo, number in zip(said["photos"], photos, (2, 7), strict=True):
        assert answer["photo"] == str(photo)
        assert answer["places"][0] == {
            "rank": 1,
            "reference": number,
            "file": f"day_left/Image{number:03d}.jpg",
            "place": number,
            "score": pytest.approx(answer["places"][0]["score"]),
        }
        assert len(answer["places"]) == 3
        assert answer["milliseconds"].keys() == {"decode", "encode", "match", "total"}


def test_as_a_table_and_as_csv(locate, photos):
    shown = locate(*photos)
    assert "Image007.jpg" in shown.out
    assert "encode ms" in shown.out
    assert "The map was ready after" in shown.out
    rows = list(csv.DictReader(io.StringIO(locate(*photos, "-k", 2, "-f", "csv").out)))
    assert [(row["rank"], row["reference"]) for row in rows][::2] == [("1", "2"), ("1", "7")]
    assert len(rows) == 4
    assert float(rows[0]["total_ms"]) > 0


def test_a_folder_of_photos(locate, tiny_images):
    done = locate(tiny_images / "day_right", tiny_images / "night_right", "-k", 1, "-f", "json")
    found = [answer["places"][0]["reference"] for answer in json.loads(done.out)["photos"]]
    assert found == [*range(12), *range(12)]


def test_what_is_no_photo_does_not_stop_the_others(locate, photos):
    Path("note.jpg").write_text("no image")
    Path("empty").mkdir()
    done = locate("note.jpg", photos[0], "nowhere.jpg", "empty", photos[1], "tiny.map/map.json", "-f", "json")
    assert done.code == 3
    assert [answer["photo"] for answer in json.loads(done.out)["photos"]] == list(map(str, photos))
    errors = [line for line in done.err.splitlines() if line.startswith("error:")]
    said = ("empty holds no images", "note.jpg is not an image", "nowhere.jpg cannot be read", "map.json is not an")
    assert len(errors) == 4
    for error, expected in zip(errors, said, strict=True):
        assert expected in error


@pytest.mark.parametrize("form", ["table", "csv", "json"])
def test_no_photo_at_all(locate, form):
    done = locate("nowhere.jpg", "-f", form, "--show", "a.png")
    assert done.code == 3
    assert not Path("a.png").exists()
    if form == "json":
        assert json.loads(done.out)["photos"] == []


def test_a_photo_that_the_method_stumbles_over_keeps_those_before(locate, photos, colours, monkeypatch):
    usual = colours.Colours.match

    def match(self, image, k):
        if image.shape == (5, 5, 3):
            raise RuntimeError("too small")
        return usual(self, image, k)

    monkeypatch.setattr(colours.Colours, "match", match)
    Image.new("RGB", (5, 5)).save("small.png")
    done = locate(photos[0], "small.png", photos[1], "-f", "json")
    assert done.code == 1
    assert "failed while answering small.png: RuntimeError: too small" in one_line(done.err)
    assert len(json.loads(done.out)["photos"]) == 1


def test_what_a_method_prints_is_no_result(locate, photos, colours, monkeypatch):
    usual = colours.Colours.describe
    monkeypatch.setattr(colours.Colours, "describe", lambda *words: sys.stdout.write("hello") and usual(*words))
    json.loads(locate(*photos, "-f", "json").out)


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("photo.jpg", "-k", "0"), 2, "between 1 and 12"),
        (("photo.jpg", "-k", "13"), 2, "between 1 and 12"),
        (("photo.jpg", "--show", "a.jpg"), 2, "must end in .png"),
        (("photo.jpg", "-p", "cells"), 2, "is written name=value"),
        (("photo.jpg", "-p", "sed=1"), 2, "Did you mean 'seed'"),
        (("photo.jpg", "--method", "hogg"), 2, "There is no method 'hogg'"),
        (("photo.jpg", "--method", "hog"), 3, "was made by version 1 of hog"),
        (("photo.jpg", "--threads", "0"), 2, "threads"),
        ((), 2, "PHOTO"),
    ],
)
def test_what_is_wrong_is_said(locate, words, code, said, colours, monkeypatch):
    if "hog" in words:
        monkeypatch.setattr("vpr_baselines.hog.Hog.version", "2")
    done = locate(*words)
    assert done.code == code
    assert said in one_line(done.err)
    assert "Traceback" not in done.err


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        (lambda folder: shutil.rmtree(folder), "There is no map tiny.map"),
        (lambda folder: (folder / "map.json").unlink(), "is not a map"),
        (lambda folder: (folder / "map.json").write_bytes(b"{"), "is damaged"),
        (lambda folder: (folder / "state" / "map.npy").write_bytes(b""), "were written, 0 are there"),
        (lambda folder: shutil.rmtree(folder / "state"), "map.npy is missing"),
    ],
)
def test_a_map_that_is_damaged(locate, photos, damage, said):
    damage(Path("tiny.map"))
    for words in ((), ("--verify",)):
        done = locate(*photos, *words)
        assert done.code == 3
        assert said in one_line(done.err)
        assert done.out == ""


def test_a_picture_of_the_answers(locate, photos):
    done = locate(*photos, "-k", 3, "--show", "a.png")
    assert done.code == 0
    assert "a.png" in done.err
    with Image.open("a.png") as picture:
        assert picture.format == "PNG"
        colours = {colour for _, colour in picture.getcolors(1 << 24)}
    assert len(colours) > 1000  # photos, not only frames
    before = Path("a.png").read_bytes()
    assert locate(*photos[:1], "-k", 3, "--show", "a.png").code == 0
    assert Path("a.png").read_bytes() != before


def test_references_that_are_gone_leave_a_space(locate, photos, tiny_dataset):
    tiny_dataset.without_images()
    done = locate(photos[0], "--show", "a.png")
    assert done.code == 0
    assert "warning: The images of tiny/day_left cannot be shown" in one_line(done.err)
    assert len([line for line in done.err.splitlines() if "warning" in line]) == 1
    assert Path("a.png").exists()


def test_one_reference_that_is_damaged_leaves_a_space(locate, photos, tiny_dataset):
    (tiny_dataset.folder / "day_left" / "Image002.jpg").write_bytes(b"no image")
    done = locate(photos[0], "-k", 2, "--show", "a.png")
    assert done.code == 0
    assert "Image002.jpg is not an image" in one_line(done.err)


def test_many_photos_are_not_all_drawn(locate, photos, monkeypatch):
    monkeypatch.setattr("vpr_bench.report.answer_sheet.MOST", 1)
    assert "a.png shows the first 1 of 2 photos" in one_line(locate(*photos, "--show", "a.png").err)


def test_no_answer(locate, photos, colours, monkeypatch):
    from vpr_bench import Match

    monkeypatch.setattr(colours.Colours, "match", lambda self, image, k: Match([], []))
    for form in ("table", "csv", "json"):
        done = locate(photos[0], "-f", form, "--show", "a.png")
        assert done.code == 0
    assert "nothing answered" in locate(photos[0]).out


def test_a_sequence(vpr_bench, tiny_dataset, colours, tiny_images):
    vpr_bench("fit", "-m", "seqslam", "-p", "inner=colours", "-p", "future=1", "--dataset", "tiny", "-o", "s.map")
    done = vpr_bench("locate", "s.map", str(tiny_images / "day_right"), "-k", "1", "-f", "json")
    said = json.loads(done.out)["photos"]
    assert [Path(one["photo"]).name for one in said] == [f"Image{number:03d}.jpg" for number in range(12)]
    assert sum(one["places"][0]["reference"] == number for number, one in enumerate(said)) >= 8


def test_words_of_others_are_written_on_one_line(locate, photos):
    name = Path("a\x1b[31m\nb.png")
    Image.open(photos[0]).save(name)
    for words in ((), ("--show", "a.png")):
        done = locate(name, *words)
        assert done.code == 0
        assert "\x1b" not in done.out + done.err
