"""The five augmentations that enlarge the training set (thesis, ch. 4.3)."""

from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.uint8]

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


AUGMENTATIONS: tuple[Callable[[Image, np.random.Generator], Image], ...] = (
    gaussian_noise,
    blur,
    equalise,
    erase,
    rotate,
)
"""Each turns an (H, W, 3) uint8 RGB image into another of the same shape; the argument is left as it is."""


def augmented(image: Image, seed: int, index: int) -> list[Image]:
    """Return the five variants of reference ``index``, the same ones for the same seed whatever came before."""
    random = np.random.default_rng([seed, index])
    return [augment(image, random) for augment in AUGMENTATIONS]
