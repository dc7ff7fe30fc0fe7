import json
import shutil

import pytest


def test_when_all_is_well_one_line_says_what_was_checked(vpr_bench, tiny_dataset):
    done = vpr_bench("data", "lint", "tiny")
    assert (done.code, done.err) == (0, "")
    assert done.out == "tiny: nothing wrong in 36 images of 3 traverses, 2 protocols\n"


def test_the_simulated_edition(vpr_bench, tiny_dataset):
    done = vpr_bench("data", "lint", "tiny:simulated", "--protocol", "day_left-night_right")
    assert done.code == 0
    assert done.out == "tiny:simulated: nothing wrong in 24 images of 2 traverses, 1 protocol\n"


def test_a_folder_of_ones_own(vpr_bench, tiny_images, data_folder):
    done = vpr_bench("data", "lint", str(tiny_images), "--protocol", "day_left-day_right", "-f", "json")
    assert done.code == 0
    assert json.loads(done.out)["images"] == 24


def test_an_error(vpr_bench, tiny_dataset):
    (tiny_dataset.folder / "day_left" / "Image001.jpg").write_bytes(b"")
    done = vpr_bench("data", "lint", "tiny", "--protocol", "day_left-day_right")
    assert done.code == 1
    assert "Errors" in done.out and "does-not-decode" in done.out and "day_left/Image001.jpg" in done.out
    assert done.out.index("Errors") < done.out.index("Warnings")  # another copy, too
    assert done.out.endswith("tiny: 1 error, 1 warning in 24 images of 2 traverses, 1 protocol\n")


def test_a_warning(vpr_bench, tiny_dataset):
    (tiny_dataset.folder / "day_left" / "places.pkl").touch()
    done = vpr_bench("data", "lint", "tiny")
    assert done.code == 1
    assert "junk-files" in done.out


def test_a_note_is_no_failure(vpr_bench, tiny_dataset):
    (tiny_dataset.folder / "day_left" / ".DS_Store").touch()
    done = vpr_bench("data", "lint", "tiny")
    assert done.code == 0
    assert "Notes" in done.out and "1 note in 36 images" in done.out


def test_json(vpr_bench, tiny_dataset):
    (tiny_dataset.folder / "day_left" / "[red]\x1b[31m.pkl").touch()
    done = vpr_bench("data", "lint", "tiny", "--format", "json", "--protocol", "day_left-day_right@2f")
    assert done.code == 1
    content = json.loads(done.out)
    (finding,) = content.pop("findings")
    assert content == {"dataset": "tiny", "protocols": ["tiny/day_left-day_right@2f"], "images": 24}
    assert set(finding) == {"check", "severity", "where", "message"}
    assert (finding["check"], finding["severity"], finding["where"]) == ("junk-files", "warning", "day_left")


def test_names_of_files_are_no_markup(vpr_bench, tiny_dataset):
    (tiny_dataset.folder / "day_left" / "[red]\x1b[31m.pkl").touch()
    done = vpr_bench("data", "lint", "tiny")
    assert "[red][31m.pkl" in done.out and "\x1b" not in done.out


@pytest.mark.parametrize("form", ["table", "json"])
def test_nothing_that_can_be_loaded(vpr_bench, tiny_dataset, form):
    for traverse in ("day_right", "night_right", "day_left"):
        shutil.rmtree(tiny_dataset.folder / traverse)
        (tiny_dataset.folder / traverse).mkdir()
    done = vpr_bench("data", "lint", "tiny", "--format", form)
    assert done.code == 3
    assert "does-not-load" in done.out


def test_a_dataset_that_is_not_there(vpr_bench, tiny_dataset):
    tiny_dataset.without_images()
    done = vpr_bench("data", "lint", "tiny:real")
    assert (done.code, done.out) == (3, "")
    assert "vpr-bench data fetch tiny" in done.err or "are not under" in done.err


@pytest.mark.parametrize("words", [("tinny",), ("tiny", "--protocol", "day_left-day_rigt"), ("tiny", "-f", "csv"), ()])
def test_usage(vpr_bench, tiny_dataset, words):
    assert vpr_bench("data", "lint", *words).code == 2


def test_help_shows_examples(vpr_bench):
    done = vpr_bench("data", "lint", "--help")
    assert done.code == 0
    assert "vpr-bench data lint gardens" in done.out.replace("\n", " ")
