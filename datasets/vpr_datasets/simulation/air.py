"""The air between the camera and the scene: fog, and falling snow."""

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.raster import FAR, Buffers

AIR = 206 * 232
"""Light of fog by day."""

FLAKE = 232 * 240
"""Light of a flake of snow."""


def veil(light: NDArray[np.uint16], buffers: Buffers, haze: float) -> NDArray[np.uint16]:
    """Replace light from afar by that of the air, half of it at ``haze`` metres; (H, W, C) uint16."""
    # In steps of 1/256, so that all that follows is on integers.
    share = (buffers.depth / (buffers.depth + np.float32(haze)) * np.float32(256)).astype(np.uint32)
    # The sky is not so far that nothing is left of its clouds.
    share[buffers.depth >= FAR] = min(204, int(256 * 2000.0 / (2000.0 + haze)))
    return _mix(light, share, AIR)


def snowfall(light: NDArray[np.uint16], dice: Dice, amount: float) -> NDArray[np.uint16]:
    """Let flakes fall before the camera, small ones far away and larger ones near; (H, W, C) uint16."""
    height, width = light.shape[:2]
    share = np.zeros((height, width), dtype=np.uint8)
    for size, weight, opacity in ((1, 6, 120), (2, 5, 150), (3, 4, 170)):
        field = dice.bytes(height // size + 1, width // size + 1)
        flakes = np.where(field < int(weight * amount), np.uint8(opacity), np.uint8(0))
        large = cv2.resize(flakes, None, fx=size, fy=size, interpolation=cv2.INTER_NEAREST)
        np.maximum(share, np.asarray(large)[:height, :width], out=share)
    return _mix(light, share.astype(np.uint32), FLAKE)


def _mix(light: NDArray[np.uint16], share: NDArray[np.uint32], other: int) -> NDArray[np.uint16]:
    """Blend in ``share / 256`` of another light."""
    part = share[..., None]
    return np.asarray((light * (np.uint32(256) - part) + part * np.uint32(other)) >> np.uint32(8), dtype=np.uint16)
