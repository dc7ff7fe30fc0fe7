"""The five augmentations that enlarge the training set (thesis, ch. 4.5)."""

from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.uint8]

# The thesis names the five and none of their parameters. Rotations of up to 20 degrees are said to keep what a picture
# shows recognisable; half of that is a camera that is held badly.
_NOISE_DEVIATION = 20.0  # grey levels
_BLUR_SIGMA = 0.006  # of the image's width
_ERASED = (0.2, 0.45)  # of each side
_ROTATION = 10.0  # degrees, either way


def gaussian_noise(image: Image, random: np.random.Generator) -> Image:
    """Add noise, as high sensor gain does at night."""
    noise = random.standard_normal(image.shape, dtype=np.float32) * _NOISE_DEVIATION
    return np.clip(image + noise, 0, 255).astype(np.uint8)


def blur(image: Image, random: np.random.Generator) -> Image:
    """Blur, as a camera out of focus or in motion does."""
    return np.asarray(cv2.GaussianBlur(image, (0, 0), max(_BLUR_SIGMA * image.shape[1], 0.5)))


def equalise(image: Image, random: np.random.Generator) -> Image:
    """Equalise the histogram of the luminance, colours kept."""
    luminance = cv2.cvtColor(image, cv2.COLOR_RGB2YCrCb)
    luminance[..., 0] = cv2.equalizeHist(np.ascontiguousarray(luminance[..., 0]))
    return np.asarray(cv2.cvtColor(luminance, cv2.COLOR_YCrCb2RGB))


def erase(image: Image, random: np.random.Generator) -> Image:
    """Replace one rectangle by noise, as if somebody stood there."""
    height, width = (max(int(side * random.uniform(*_ERASED)), 1) for side in image.shape[:2])
    top = random.integers(0, image.shape[0] - height + 1)
    left = random.integers(0, image.shape[1] - width + 1)
    erased = image.copy()
    erased[top : top + height, left : left + width] = random.integers(0, 256, (height, width, 3), dtype=np.uint8)
    return erased


def rotate(image: Image, random: np.random.Generator) -> Image:
    """Rotate about the centre by a few degrees; what comes in at the corners is mirrored."""
    height, width = image.shape[:2]
    turn = cv2.getRotationMatrix2D((width / 2, height / 2), random.uniform(-_ROTATION, _ROTATION), 1.0)
    return np.asarray(cv2.warpAffine(image, turn, (width, height), borderMode=cv2.BORDER_REFLECT_101))


AUGMENTATIONS: dict[str, Callable[[Image, np.random.Generator], Image]] = {
    "Gaussian noise": gaussian_noise,
    "blur": blur,
    "histogram equalisation": equalise,
    "random erasing": erase,
    "random rotation": rotate,
}
"""By name: each turns an (H, W, 3) uint8 RGB image into another of the same shape and leaves its argument as it is."""

VARIANTS = 1 + len(AUGMENTATIONS)
"""How many images a reference is trained with: itself and its augmentations."""


def augmented_by_name(image: Image, seed: int, index: int) -> dict[str, Image]:
    """Return the five variants of reference ``index``, the same ones for the same seed whatever came before.

    Parameters
    ----------
    image : (H, W, 3) uint8
        RGB. Noise has a deviation of 20 grey levels, blur one of 0.6 % of the width (at least half a pixel); the
        histogram that is equalised is the luminance's; a rectangle of 20 to 45 % of each side is replaced by uniform
        noise; a rotation is by up to 10 degrees either way, with the image mirrored at its edges.
    seed, index : int
        Each variant is drawn from these and its own place in the list, so that one can be had without the others.
    """
    return {name: variant_of(image, seed, index, number) for number, name in enumerate(AUGMENTATIONS, 1)}


def augmented(image: Image, seed: int, index: int) -> list[Image]:
    """Return the variants of :func:`augmented_by_name` without their names."""
    return list(augmented_by_name(image, seed, index).values())


def variant_of(image: Image, seed: int, index: int, number: int) -> Image:
    """Return one variant: 0 is the image itself, then the augmentations in their order."""
    if number == 0:
        return image
    augment = list(AUGMENTATIONS.values())[number - 1]
    return augment(image, np.random.default_rng([seed, index, number]))
