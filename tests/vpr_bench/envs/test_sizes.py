import io

import numpy as np
import pytest
from PIL import Image

from vpr_bench.envs.sizes import image_sizes
from vpr_bench.errors import DataError
from vpr_bench.types.traverse import Traverse


def halved(image):
    return image[::2, ::2]


@pytest.mark.parametrize("suffix", ["jpg", "png", "webp", "tif", "bmp", "ppm"])
@pytest.mark.parametrize("orientation", [None, 3, 6, 8])
def test_sizes_are_those_of_the_decoded_images(tmp_path, suffix, orientation):
    file, picture, exif = tmp_path / f"one.{suffix}", Image.new("RGB", (12, 8)), Image.Exif()
    if orientation and suffix not in ("bmp", "ppm"):
        exif[0x0112] = orientation
        picture.save(file, exif=exif)
    else:
        picture.save(file)
    walk = Traverse("walk", [file])
    assert image_sizes(walk).tolist() == [list(walk[0].shape[:2])]


def test_nothing_is_decoded(tmp_path):
    buffer = io.BytesIO()
    Image.fromarray(np.random.default_rng(0).integers(0, 256, (40, 60, 3), dtype=np.uint8)).save(buffer, "JPEG")
    file = tmp_path / "cut.jpg"
    file.write_bytes(buffer.getvalue()[:-500])
    assert image_sizes(Traverse("walk", [file] * 2)).tolist() == [[40, 60]] * 2


def test_what_is_done_after_decoding_counts():
    sources = [np.zeros((8, 6, 3), np.uint8), np.zeros((4, 2, 3), np.uint8), np.zeros((8, 6, 3), np.uint8)]
    assert image_sizes(Traverse("walk", sources, halved)).tolist() == [[4, 3], [2, 1], [4, 3]]


def test_no_images():
    assert image_sizes(Traverse("walk", [])).shape == (0, 2)


@pytest.mark.parametrize("content", [b"", b"no image"])
def test_damaged_files_are_named(tmp_path, content):
    file = tmp_path / "bad.jpg"
    file.write_bytes(content)
    with pytest.raises(DataError, match=r"bad\.jpg cannot be read"):
        image_sizes(Traverse("walk", [file]))
    with pytest.raises(DataError, match=r"gone\.jpg cannot be read"):
        image_sizes(Traverse("walk", [tmp_path / "gone.jpg"]))
