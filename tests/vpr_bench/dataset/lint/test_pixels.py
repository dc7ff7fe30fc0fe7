import struct
import time
import zlib
from contextlib import contextmanager

import numpy as np
import pytest
from PIL import Image

from vpr_bench.dataset.lint.survey import survey
from vpr_bench.progress import listen
from vpr_bench.types.traverse import Traverse


def svg(file):
    """Write a drawing, whatever the file is called."""
    file.write_text('<svg xmlns="http://www.w3.org/2000/svg"><rect width="9" height="9"/></svg>')


def bomb(file):
    """Write a PNG whose header promises 50,000 × 50,000 pixels."""
    content = file.read_bytes()
    chunk = b"IHDR" + struct.pack(">II", 50000, 50000) + content[24:29]
    file.write_bytes(content[:12] + chunk + struct.pack(">I", zlib.crc32(chunk)) + content[33:])


def test_images_that_do_not_decode(made):
    made.image("day", 2).write_bytes(b"")
    svg(made.image("day", 4))
    bomb(made.image("night", 6))
    found = made.lint()
    assert {(one.check, one.severity) for one in found} == {("does-not-decode", "error")}
    assert [one.where for one in found] == ["day/02.png", "day/04.png", "night/06.png"]
    for finding, said in zip(found, ("is empty", "is not an image", "image bomb"), strict=True):
        assert said in finding.message


def test_of_very_many_only_the_first_are_named(made):
    for index in range(8):
        made.image("day", index).write_bytes(b"")
    found = made.lint()
    assert len(found) == 6 and found[-1].where == "day"
    assert found[-1].message == "3 more of 10 images cannot be decoded"


def test_images_of_mixed_sizes(made, picture):
    Image.fromarray(picture(3)[:20]).save(made.image("day", 3))
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("mixed-sizes", "warning", "day")
    assert finding.message.endswith("9 of 32×24, 1 of 32×20")


def test_sizes_may_differ_between_traverses(made, picture):
    for index in range(10):
        made.paint("day", index, picture(index)[:20])
    assert made.lint() == []


def test_a_tunnel(made):
    for index in (1, 3, 4, 5, 6, 7, 8):
        made.paint("day", index, np.random.default_rng(index).integers(0, 9, (24, 32, 3), dtype=np.uint8))
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("dark", "warning", "day")
    assert finding.message == ("black (mean below 5 of 255): 7 of 10 images: day/01.png, day/03.png to day/08.png (6)")


def test_a_dim_image_is_not_dark(made, picture):
    for index in range(10):
        made.paint("day", index, (picture(index) * 0.06).astype(np.uint8))
    assert made.lint() == []


def nearly(image, seed):
    """Return the picture as another exposure of it is: with other noise."""
    return (image + np.random.default_rng(seed).choice([0, 1], image.shape, p=[0.9, 0.1])).astype(np.uint8)


def test_a_train_that_stands(made, picture):
    for index in range(3, 8):
        made.paint("night", index, nearly(picture(103), index))
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("frozen", "warning", "night")
    assert finding.message == "one picture over and over: 5 of 10 images: night/03.png to night/07.png (5)"


def test_a_short_halt_is_nothing(made, picture):
    for index in range(3, 7):
        made.paint("night", index, nearly(picture(103), index))
    assert made.lint() == []


def of_greys(greys):
    return Traverse("walk", [np.full((24, 32, 3), grey, np.uint8) for grey in greys])


@pytest.mark.parametrize(
    ("greys", "frozen"),
    [
        ([100] * 5, [range(5)]),
        ([100] * 4, []),
        ([20, 100, 100, 100, 100, 100, 20], [range(1, 6)]),
        ([100] * 5 + [101] * 6 + [102], [range(11)]),
        (list(range(100, 120)), []),
        ([0] * 9, []),
        ([100] * 5 + [0] * 5 + [100] * 5, [range(5), range(10, 15)]),
        ([], []),
    ],
)
def test_stretches_of_one_picture(greys, frozen):
    assert survey(of_greys(greys)).frozen == frozen


def test_a_slow_train_is_not_a_standing_one():
    ramp = np.linspace(0, 255, 640)
    frames = [np.tile(np.roll(ramp, step).astype(np.uint8)[None, :, None], (24, 1, 3)) for step in range(0, 60, 2)]
    assert survey(Traverse("slow", frames)).frozen == []


def test_an_image_that_its_conversion_refuses(picture):
    def refuse(image):
        raise ValueError("not a mosaic")

    seen = survey(Traverse("walk", [picture(1)], refuse))
    assert seen.faults == {0: "walk[0]: ValueError: not a mosaic"}


def test_ctrl_c_does_not_wait_for_the_rest():
    decoded = []

    @contextmanager
    def interrupting(description, total):
        def advance(steps):
            raise KeyboardInterrupt

        yield advance

    def slowly(image):
        decoded.append(1)
        time.sleep(0.002)
        return image

    with listen(interrupting), pytest.raises(KeyboardInterrupt):
        survey(Traverse("walk", [np.zeros((8, 8, 3), np.uint8)] * 2000, slowly))
    assert len(decoded) < 1000
