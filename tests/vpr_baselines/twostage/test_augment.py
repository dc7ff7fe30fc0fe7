import numpy as np
import pytest

from vpr_baselines.twostage.augment import (
    AUGMENTATIONS,
    VARIANTS,
    augmented,
    augmented_by_name,
    blur,
    equalise,
    erase,
    gaussian_noise,
    rotate,
    variant_of,
)


@pytest.fixture
def image():
    """Soft texture of middle contrast: (48, 64, 3) uint8."""
    blocks = np.random.default_rng(0).integers(60, 180, (6, 8, 3), dtype=np.uint8)
    return blocks.repeat(8, axis=0).repeat(8, axis=1)


@pytest.fixture
def chance():
    return np.random.default_rng(1)


def difference(one, other):
    return np.abs(one.astype(int) - other)


def test_there_are_five_and_each_changes_the_image(image):
    variants = augmented(image, seed=0, index=0)
    assert len(variants) == len(AUGMENTATIONS) == 5
    for variant in variants:
        assert variant.shape == image.shape and variant.dtype == np.uint8
        assert difference(variant, image).any()


def test_the_image_itself_is_left_as_it_is(image):
    before = image.copy()
    for variant in augmented(image, 0, 0):
        variant[:] = 0
    assert np.array_equal(image, before)


def test_the_same_seed_gives_the_same_variants_whatever_came_before(image):
    first = augmented(image, 3, 7)
    augmented(image, 3, 8)
    assert all(np.array_equal(*pair) for pair in zip(first, augmented(image, 3, 7), strict=True))


@pytest.mark.parametrize(("seed", "index"), [(4, 7), (3, 8)])
def test_other_seeds_and_other_images_give_other_variants(image, seed, index):
    same = [np.array_equal(*pair) for pair in zip(augmented(image, 3, 7), augmented(image, seed, index), strict=True)]
    assert same == [False, True, True, False, False]  # blur and equalisation know no chance


@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (2, 2), (5, 3)])
def test_tiny_images_keep_their_shape(shape):
    image = np.random.default_rng(0).integers(0, 256, (*shape, 3), dtype=np.uint8)
    assert [variant.shape for variant in augmented(image, 0, 0)] == [image.shape] * 5


@pytest.mark.parametrize("level", [0, 255])
def test_noise_does_not_wrap_round(chance, level):
    noisy = gaussian_noise(np.full((20, 20, 3), level, np.uint8), chance)
    assert difference(noisy, level).max() < 128
    assert 5 < difference(noisy, level).mean() < 12  # half of a normal distribution of deviation 20: 8


def test_blur_smooths_edges(image, chance):
    assert (
        difference(blur(image, chance)[:, 1:], blur(image, chance)[:, :-1]).max()
        < difference(image[:, 1:], image[:, :-1]).max()
    )


def test_equalisation_spreads_the_luminance(image, chance):
    grey = image[..., :1].repeat(3, axis=2)
    equalised = equalise(grey, chance)
    assert np.ptp(equalised) > 1.5 * np.ptp(grey)
    assert np.ptp(equalised.astype(int), axis=2).max() <= 1  # grey stays grey


def test_one_rectangle_is_erased_and_the_rest_kept(image, chance):
    changed = difference(erase(image, chance), image).any(axis=2)
    rows, columns = np.flatnonzero(changed.any(axis=1)), np.flatnonzero(changed.any(axis=0))
    height, width = np.ptp(rows) + 1, np.ptp(columns) + 1
    assert 0.15 * 48 < height < 0.5 * 48 and 0.15 * 64 < width < 0.5 * 64
    assert changed[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1].mean() > 0.95


def test_rotation_is_about_the_centre(chance):
    image = np.zeros((49, 65, 3), np.uint8)
    image[20:29, 28:37] = 255
    rotated = rotate(image, chance)
    y, x = np.nonzero(rotated[..., 0] > 127)
    assert abs(y.mean() - 24) < 1 and abs(x.mean() - 32) < 1


def test_they_can_be_had_by_name_and_one_by_one(image):
    named = augmented_by_name(image, 3, 7)
    assert list(named) == [
        "Gaussian noise",
        "blur",
        "histogram equalisation",
        "random erasing",
        "random rotation",
    ]
    single = [variant_of(image, 3, 7, number) for number in range(1, 6)]
    assert all(np.array_equal(*pair) for pair in zip(named.values(), single, strict=True))
    assert all(np.array_equal(*pair) for pair in zip(named.values(), augmented(image, 3, 7), strict=True))
    assert variant_of(image, 3, 7, 0) is image and VARIANTS == 6
