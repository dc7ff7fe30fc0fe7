import numpy as np
import pytest

from vpr_baselines.sad import Sad
from vpr_bench.types.traverse import Traverse


def noise(seed, shape=(32, 64)):
    grey = np.random.default_rng(seed).integers(0, 256, shape, dtype=np.uint8)
    return np.stack([grey] * 3, axis=2)


def score(method, one, other):
    method.fit(Traverse("map", [one]))
    return float(method.match(other, 1).scores[0])


def test_raw_scores_are_minus_the_mean_difference_of_grey_levels():
    one, other = noise(0), noise(1)
    expected = -np.abs(one[..., 0].astype(float) - other[..., 0]).mean()
    assert score(Sad(raw=True), one, other) == pytest.approx(expected, rel=1e-5)


def test_patches_have_mean_0_and_deviation_1():
    pixels = Sad().describe(noise(0)).reshape(32, 64) * 32 * 64
    patches = pixels.reshape(4, 8, 8, 8).swapaxes(1, 2)
    assert patches.mean(axis=(2, 3)) == pytest.approx(np.zeros((4, 8)), abs=1e-5)
    assert patches.std(axis=(2, 3)) == pytest.approx(np.ones((4, 8)), abs=1e-5)


def test_brightness_and_contrast_of_a_patch_do_not_count_unless_raw():
    one = noise(0)
    other = one // 4 * 2 + 60
    dimmed = one // 4 * 4
    assert score(Sad(), dimmed, other) == pytest.approx(0, abs=1e-3)
    assert score(Sad(raw=True), dimmed, other) < -10


def test_a_patch_without_contrast_is_zero():
    assert not Sad().describe(np.full((32, 64, 3), 77, np.uint8)).any()


def test_patches_may_be_cut_off_at_the_border():
    method = Sad(width=20, height=11, patch=8)
    descriptor = method.describe(noise(0, (40, 60)))
    assert descriptor.shape == (220,) and np.isfinite(descriptor).all() and descriptor.dtype == np.float32


@pytest.mark.parametrize("shape", [(1, 1), (3, 200), (600, 7)])
def test_images_of_any_size_are_described(shape):
    assert np.isfinite(score(Sad(), noise(0, shape), noise(1))).all()
