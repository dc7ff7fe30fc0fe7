import numpy as np
import pytest

from vpr_baselines.photometry import grey, locally_equalised, resized


@pytest.fixture
def image():
    return np.random.default_rng(0).integers(0, 256, (37, 51, 3), dtype=np.uint8)


def test_images_are_resized_to_width_by_height(image):
    assert resized(image, 20, 10).shape == (10, 20, 3)
    assert resized(image[..., 0], 90, 80).shape == (80, 90)
    assert resized(image, 51, 37).tolist() == image.tolist()


def test_shrinking_averages_so_that_nothing_aliases():
    stripes = np.tile(np.array([0, 255], np.uint8), (8, 8))
    assert np.abs(resized(stripes, 4, 4).astype(int) - 127.5).max() <= 1


def test_grey_is_the_luminance_of_rgb(image):
    assert grey(image).shape == (37, 51) and grey(image).dtype == np.uint8
    channels = [int(grey(np.eye(3, dtype=np.uint8)[None, None, one] * 255)[0, 0]) for one in range(3)]
    assert channels == [76, 150, 29]  # ITU-R BT.601: 0.299 red, 0.587 green, 0.114 blue


def test_local_equalisation_raises_the_contrast_where_it_is_low(image):
    dim = (grey(image) // 8).astype(np.uint8)
    equalised = locally_equalised(dim)
    assert equalised.shape == dim.shape and equalised.dtype == np.uint8
    assert equalised.std() > 1.5 * dim.std()


@pytest.mark.parametrize("shape", [(1, 1), (5, 3), (8, 8), (257, 33)])
def test_local_equalisation_takes_any_size(shape):
    assert locally_equalised(np.full(shape, 9, np.uint8)).shape == shape
