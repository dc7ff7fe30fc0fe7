"""Smooth noise and blurs in integer arithmetic."""

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice


def value_noise(dice: Dice, height: int, width: int, cell: int, octaves: int = 1) -> NDArray[np.uint8]:
    """Return (height, width) uint8 noise around 128 whose coarsest features are ``cell`` pixels wide.

    Each octave is a lattice of random bytes, enlarged by OpenCV's bit-exact linear interpolation.
    """
    total = np.zeros((height, width), dtype=np.uint16)
    left = 256
    for octave in range(octaves):
        size = max(cell >> octave, 1)
        lattice = dice.bytes(height // size + 2, width // size + 2)
        layer = cv2.resize(
            lattice, (lattice.shape[1] * size, lattice.shape[0] * size), interpolation=cv2.INTER_LINEAR_EXACT
        )[size // 2 : size // 2 + height, size // 2 : size // 2 + width]
        weight = left if octave == octaves - 1 else left // 2
        left -= weight
        total += layer.astype(np.uint16) * np.uint16(weight) >> 8
    return total.astype(np.uint8)


def soften(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Blur an (H, W) or (H, W, C) uint8 image with the 1-2-1 kernel in both directions; same shape."""
    wide = image.astype(np.uint16)
    across = wide * np.uint16(2)
    across[:, 1:] += wide[:, :-1]
    across[:, :1] += wide[:, :1]
    across[:, :-1] += wide[:, 1:]
    across[:, -1:] += wide[:, -1:]
    down = across * np.uint16(2)
    down[1:] += across[:-1]
    down[:1] += across[:1]
    down[:-1] += across[1:]
    down[-1:] += across[-1:]
    return (down + np.uint16(8) >> 4).astype(np.uint8)


def box_sum(image: NDArray[np.uint8], radius: int) -> NDArray[np.int32]:
    """Sum an (H, W) uint8 image over squares of ``2 radius + 1`` pixels; (H, W) int32, exact."""
    side = 2 * radius + 1
    return np.asarray(cv2.boxFilter(image, cv2.CV_32S, (side, side), normalize=False, borderType=cv2.BORDER_REPLICATE))
