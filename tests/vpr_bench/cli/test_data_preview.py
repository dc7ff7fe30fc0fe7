from pathlib import Path

import pytest
from PIL import Image

CARD = """
id = "walk"
name = "Walk"
summary = "Two traverses."
citation = "none"
licence = "CC0"
homepage = "none"
unit = "f"
loader = { layout = "numbered", options = { pattern = "Image{index:03d}.jpg" } }
traverses = [{ name = "day_left" }, { name = "day_right" }]
protocols = [{ references = "day_left", queries = "day_right", radius = 1 }]
"""


def test_writes_a_picture_and_prints_its_path(vpr_bench, tiny_dataset):
    done = vpr_bench("data", "preview", "tiny")
    assert done.code == 0
    assert done.out == "tiny_day_left-day_right.png\n"
    with Image.open("tiny_day_left-day_right.png") as picture:
        assert picture.format == "PNG"


def test_what_to_show_can_be_chosen(vpr_bench, tiny_dataset, tmp_path):
    file = str(tmp_path / "mine.png")
    first = vpr_bench("data", "preview", "tiny", "--output", file, "--count", "3")
    assert first.out.strip() == file
    before = Path(file).read_bytes()
    for more in (["--seed", "1"], ["--radius", "3"], ["--protocol", "day_left-night_right"], ["--count", "4"]):
        assert vpr_bench("data", "preview", "tiny", "--output", file, "--count", "3", *more).code == 0
        assert Path(file).read_bytes() != before


def test_simulated_images_are_named_so(vpr_bench, tiny_dataset):
    done = vpr_bench("data", "preview", "tiny", "--edition", "simulated")
    assert done.out == "tiny-simulated_day_left-day_right.png\n"
    assert "SIMULATED" in done.err


def test_folder_of_ones_own(vpr_bench, tiny_images, tmp_path):
    folder = tmp_path / "walk"
    folder.mkdir()
    for name in ("day_left", "day_right"):
        (folder / name).symlink_to(tiny_images / name)
    (folder / "vpr-bench.toml").write_text(CARD)
    done = vpr_bench("data", "preview", str(folder))
    assert (done.code, done.out) == (0, "walk_day_left-day_right.png\n")


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["tiny", "--output", "picture.jpg"], 2, "must end in .png"),
        (["tiny", "--count", "0"], 2, "--count"),
        (["tiny", "--radius", "-1"], 2, "radius"),
        (["tiny", "--radius", "50"], 2, "whole map"),
        (["tiny", "--protocol", "day_left-noon"], 2, "no protocol"),
        (["tiny", "--output", "no/such/folder/picture.png"], 3, "Cannot write"),
        (["tinny"], 2, "Did you mean 'tiny'?"),
        (["./nowhere"], 3, "There is no folder"),
    ],
)
def test_what_cannot_be_shown(vpr_bench, tiny_dataset, words, code, said):
    done = vpr_bench("data", "preview", *words)
    assert done.code == code
    assert said in done.err
    assert done.out == ""
    assert not list(Path.cwd().iterdir())


def test_damaged_image_is_named(vpr_bench, tiny_dataset):
    for file in (tiny_dataset.folder / "day_right").iterdir():
        file.write_bytes(file.read_bytes()[:200])
    done = vpr_bench("data", "preview", "tiny")
    assert done.code == 3
    assert "day_right/Image" in done.err
