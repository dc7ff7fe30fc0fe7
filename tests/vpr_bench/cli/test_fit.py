import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

FIT = ("fit", "--method", "colours", "--dataset", "tiny")


def one_line(text):
    return re.sub(r"\s+", " ", text)


@pytest.fixture(autouse=True)
def _plugins(tiny_dataset, colours):
    pass


def test_fits_once_and_says_what_came_out(vpr_bench, colours):
    first = vpr_bench(*FIT, "-o", "tiny.map", "--param", "cells=3", "--format", "json")
    assert first.code == 0
    facts = json.loads(first.out)
    assert (facts["map"], facts["method"], facts["n_references"]) == ("tiny.map", "colours", 12)
    assert "colours(cells=3) on tiny/day_left: fitting" in first.err
    again = vpr_bench(*FIT, "-o", "tiny.map", "--param", "cells=3", "--format", "json")
    assert json.loads(again.out) == facts
    assert "fitted already" in again.err
    assert colours.done == [12]


def test_what_a_map_is_of(vpr_bench, tiny_images):
    for number, words in enumerate(
        [
            ("--dataset", "tiny", "--references", "day_right"),
            ("--dataset", "tiny", "--protocol", "day_right-day_left"),
            ("--dataset", "tiny:simulated", "--references", "day_right"),
            ("--images", str(tiny_images / "day_right")),
        ]
    ):
        done = vpr_bench("fit", "-m", "colours", *words, "-o", f"{number}.map", "--format", "json")
        (part,) = json.loads(done.out)["references"]
        assert part["from"].rpartition("/")[2] == "day_right"
    shown = vpr_bench("info", "2.map")
    assert "tiny:simulated/day_right" in shown.out


def test_simulated_images_are_said_to_be(vpr_bench, tiny_dataset):
    tiny_dataset.without_images()
    assert "SIMULATED" in vpr_bench(*FIT, "-o", "tiny.map").err


def test_info_describes_a_map(vpr_bench):
    vpr_bench(*FIT, "-o", "tiny.map", "--seed", "3")
    shown = vpr_bench("info", "tiny.map")
    assert shown.code == 0
    assert "parameter: seed · value: 3" in shown.out
    assert "tiny/day_left · images: 12" in shown.out
    assert json.loads(vpr_bench("info", "tiny.map", "--format", "json").out)["n_references"] == 12
    (Path("tiny.map") / "state" / "map.npy").write_bytes(b"")
    assert vpr_bench("info", "tiny.map").code == 3


def test_methods_in_files(vpr_bench):
    Path("mine.py").write_text("from colours_plugin import Colours\n\nclass Mine(Colours):\n    version = '7'\n")
    assert vpr_bench("fit", "-m", "mine.py:Mine", "--dataset", "tiny", "-o", "tiny.map").code == 0
    photo = "--method", "mine.py:Mine", "--format", "json"
    refused = vpr_bench("locate", "tiny.map", "photo.jpg")
    assert refused.code == 2
    assert "If you trust it, say where it is with --method path/to/file.py:Class" in one_line(refused.err)
    Image.new("RGB", (64, 48)).save("photo.jpg")
    assert vpr_bench("locate", "tiny.map", "photo.jpg", *photo).code == 0


def test_preview_draws_and_does_not_fit(vpr_bench, colours):
    done = vpr_bench(*FIT, "--preview", "copies.png")
    assert (done.code, done.out) == (0, "copies.png\n")
    assert "Nothing was fitted" in done.err
    assert colours.done == []
    with Image.open("copies.png") as picture:
        assert picture.format == "PNG"
        assert picture.width > 3 * 264
    before = Path("copies.png").read_bytes()
    vpr_bench(*FIT, "--preview", "copies.png")
    assert Path("copies.png").read_bytes() == before


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("--method", "colours", "-o", "a.map"), 2, "either --dataset or --images"),
        (("--method", "colours", "--dataset", "tiny", "--images", ".", "-o", "a.map"), 2, "either --dataset"),
        (("--method", "colours", "--images", ".", "--references", "a", "-o", "a.map"), 2, "are for --dataset"),
        (("--method", "colours", "--images", ".", "-o", "a.map"), 3, "holds no images"),
        (("--method", "colours", "--images", "nowhere", "-o", "a.map"), 3, "nowhere is missing"),
        (("--method", "colours", "--dataset", "tiny"), 2, "where to put the map with --output"),
        (("--method", "colour", "--dataset", "tiny", "-o", "a.map"), 2, "Did you mean 'colours'"),
        (("--method", "colours", "--dataset", "tin", "-o", "a.map"), 2, "Did you mean 'tiny'"),
        (("--method", "colours", "-p", "cell=2", "--dataset", "tiny", "-o", "a.map"), 2, "Did you mean 'cells'"),
        (("--method", "colours", "-p", "cells", "--dataset", "tiny", "-o", "a.map"), 2, "is written name=value"),
        (("--method", "forgetful", "--dataset", "tiny", "-o", "a.map"), 2, "cannot be kept on disk"),
        (("--method", "colours", "--dataset", "tiny", "-o", "."), 2, "needs a name of its own"),
        (("--method", "colours", "--dataset", "tiny", "--preview", "a.jpg"), 2, "must end in .png"),
        (("--method", "hog", "--dataset", "tiny", "--preview", "a.png"), 2, "'hog' learns from no changed copies"),
        (
            ("--method", "colours", "--dataset", "tiny", "--references", "day", "-o", "a.map"),
            2,
            "there is no traverse 'day'",
        ),
    ],
)
def test_what_is_wrong_is_said(vpr_bench, words, code, said):
    done = vpr_bench("fit", *words)
    assert done.code == code
    assert said in one_line(done.err)
    assert "Traceback" not in done.err
    assert done.out == ""


@pytest.mark.parametrize(
    ("copies", "said"),
    [
        (lambda self, image, index: 1 / 0, "failed while changing day_left/Image001.jpg: ZeroDivisionError"),
        (lambda self, image, index: {"dark": image / 2}, "made of day_left/Image001.jpg by 'dark' something"),
        (lambda self, image, index: None, "failed while changing"),
    ],
)
def test_copies_that_are_none(vpr_bench, colours, monkeypatch, copies, said):
    monkeypatch.setattr(colours.Colours, "augmented", copies)
    done = vpr_bench(*FIT, "--preview", "copies.png")
    assert done.code == 1
    assert said in one_line(done.err)
    assert not Path("copies.png").exists()


def test_an_interruption(vpr_bench, colours):
    colours.fail_after.append(KeyboardInterrupt)
    assert vpr_bench(*FIT, "-o", "tiny.map").code == 130
    unfinished = vpr_bench("locate", "tiny.map", "photo.jpg")
    assert unfinished.code == 3
    assert "Give the command that was interrupted again" in one_line(unfinished.err)
    assert vpr_bench(*FIT, "-o", "tiny.map").code == 0
    assert colours.done == [12]


def test_extend(vpr_bench, tiny_images):
    vpr_bench(*FIT, "-o", "tiny.map")
    done = vpr_bench("extend", "tiny.map", "--references", "night_right", "--format", "json")
    assert done.code == 0
    assert json.loads(done.out)["n_references"] == 24
    done = vpr_bench("extend", "tiny.map", "--images", str(tiny_images / "day_right"), "-o", "all.map", "-f", "json")
    assert json.loads(done.out)["n_references"] == 36
    assert json.loads(vpr_bench("info", "tiny.map", "-f", "json").out)["n_references"] == 24


def test_extend_keeps_to_the_edition_of_the_map(vpr_bench):
    vpr_bench("fit", "-m", "colours", "--dataset", "tiny:simulated", "-o", "tiny.map")
    done = vpr_bench("extend", "tiny.map", "--references", "day_right", "-f", "json")
    assert [part["from"] for part in json.loads(done.out)["references"]] == [
        "tiny:simulated/day_left",
        "tiny:simulated/day_right",
    ]


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("tiny.map",), 2, "either --references or --images"),
        (("tiny.map", "--references", "day_right", "--images", "."), 2, "either --references or --images"),
        (("tiny.map", "--references", "day_left"), 2, "is part of tiny.map already"),
        (("tiny.map", "--references", "dawn"), 2, "there is no traverse 'dawn'"),
        (("tiny.map", "--images", "nowhere"), 3, "nowhere is missing"),
        (("tiny.map", "--images", ".", "--edition", "real"), 2, "are for --references"),
        (("own.map", "--references", "day_left"), 2, "say which --dataset has 'day_left'"),
        (("other.map", "--references", "day_left"), 3, "There is no map other.map"),
        (("hog.map", "--references", "day_right"), 2, "'hog' cannot add references"),
    ],
)
def test_extensions_that_make_no_sense(vpr_bench, words, code, said, tiny_images):
    vpr_bench(*FIT, "-o", "tiny.map")
    vpr_bench("fit", "-m", "colours", "--images", str(tiny_images / "day_left"), "-o", "own.map")
    vpr_bench("fit", "-m", "hog", "-p", "width=64", "-p", "height=64", "--dataset", "tiny", "-o", "hog.map")
    done = vpr_bench("extend", *words)
    assert done.code == code
    assert said in one_line(done.err)
    assert "Traceback" not in done.err


def test_a_full_disk(vpr_bench, colours, monkeypatch):
    def full(*words, **options):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "save", full)
    done = vpr_bench(*FIT, "-o", "tiny.map")
    assert done.code == 3
    assert "Free some space" in one_line(done.err)
    monkeypatch.undo()


def test_a_map_can_be_moved(vpr_bench, tiny_images):
    vpr_bench(*FIT, "-o", "tiny.map")
    shutil.move("tiny.map", "moved.map")
    done = vpr_bench("locate", "moved.map", str(tiny_images / "day_right" / "Image003.jpg"), "-f", "json")
    assert json.loads(done.out)["photos"][0]["places"][0]["reference"] == 3
