"""Sizes and grey levels: what is done to an image before it is described."""

import cv2
import numpy as np
from numpy.typing import NDArray

_CLIP, _TILES = 2.0, (8, 8)


def resized(image: NDArray[np.uint8], width: int, height: int) -> NDArray[np.uint8]:
    """Resize an (H, W) or (H, W, 3) image to ``width`` × ``height`` pixels, by area so that nothing aliases."""
    return np.asarray(cv2.resize(image, (width, height), interpolation=cv2.INTER_AREA), dtype=np.uint8)


def grey(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Turn (H, W, 3) RGB into its (H, W) luminance."""
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), dtype=np.uint8)


def locally_equalised(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Equalise an (H, W) grey image tile by tile with limited contrast (CLAHE; Zuiderveld, Graphics Gems IV)."""
    return np.asarray(cv2.createCLAHE(_CLIP, _TILES).apply(image), dtype=np.uint8)
