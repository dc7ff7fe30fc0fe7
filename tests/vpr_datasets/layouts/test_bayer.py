import numpy as np
import pytest

from vpr_bench.errors import DataError
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.bayer import PATTERNS, Bayer


def mosaic(image, pattern):
    """What a camera behind this pattern records of an image, as it is decoded: three equal channels."""
    raw = np.empty(image.shape[:2], np.uint8)
    for number, colour in enumerate(pattern):
        row, column = divmod(number, 2)
        raw[row::2, column::2] = image[row::2, column::2, "RGB".index(colour)]
    return np.repeat(raw[..., None], 3, axis=2)


def smooth():
    """A picture whose three channels differ and change slowly."""
    rows, columns = np.mgrid[:40, :60].astype(float)
    return np.stack([40 + 3 * columns, 200 - 2 * rows, 90 + rows - columns / 2], axis=2).astype(np.uint8)


@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_mosaic_of_one_colour_comes_back_exactly(pattern):
    image = np.full((7, 10, 3), (200, 120, 30), np.uint8)
    assert np.array_equal(Bayer(pattern)(mosaic(image, pattern)), image)


@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_mosaic_of_a_picture_comes_back_almost(pattern):
    image = smooth()
    coloured = Bayer(pattern)(mosaic(image, pattern))
    assert coloured.shape == image.shape and coloured.dtype == np.uint8
    assert np.abs(coloured.astype(int) - image)[1:-1, 1:-1].max() <= 3
    for other in set(PATTERNS) - {pattern}:
        assert np.abs(Bayer(other)(mosaic(image, pattern)).astype(int) - image).mean() > 20


def test_traverses_of_one_pattern_can_be_joined():
    one, other = (Traverse(name, [mosaic(smooth(), "GBRG")], Bayer("GBRG")) for name in "ab")
    assert np.abs(Traverse.join([one, other])[1].astype(int) - smooth())[1:-1, 1:-1].max() <= 3
    with pytest.raises(ValueError, match="converted alike"):
        Traverse.join([one, Traverse("c", other.sources, Bayer("RGGB"))])
    assert repr(Bayer("RGGB")) == "Bayer(pattern='RGGB')"  # part of the digest of what a run is measured on


def test_a_colour_image_is_no_mosaic():
    with pytest.raises(DataError, match="is in colour"):
        Bayer("RGGB")(smooth())


@pytest.mark.parametrize("shape", [(1, 1), (2, 9), (9, 2)])
def test_an_image_too_small_to_interpolate_is_refused(shape):
    with pytest.raises(DataError, match="at least 3 × 3"):
        Bayer("RGGB")(np.zeros((*shape, 3), np.uint8))


@pytest.mark.parametrize("pattern", ["BG", "rggb", "", None, 3, ["RGGB"], "RGGB_VNG"])
def test_other_patterns_are_refused(pattern):
    with pytest.raises(DataError, match="one of RGGB, BGGR, GRBG, GBRG"):
        Bayer(pattern)
