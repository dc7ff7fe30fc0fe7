"""The camera: how much light it lets in, what its lens and its sensor add, and the light of the scene."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.lighting import CELL, LAYER, LAYERS, Grid
from vpr_datasets.simulation.noise import box_sum, soften
from vpr_datasets.simulation.raster import Buffers
from vpr_datasets.simulation.spec import Light, TraverseSpec
from vpr_datasets.simulation.texture import SKY, SURFACE
from vpr_datasets.simulation.view import View


@dataclass(frozen=True)
class Exposure:
    """How a light condition is recorded, in the units of square roots of light (0 to 255).

    Attributes
    ----------
    target
        Mean that the automatic exposure aims at.
    least, most
        Limits of its gain, in 256ths.
    sky
        Light of the sky.
    glow
        Strength in 256ths of everything that glows by itself.
    noise
        Amplitude of the noise after a gain of one.
    grey
        Whether only brightness is recorded.
    """

    target: int
    least: int
    most: int
    sky: int
    glow: int
    noise: int
    grey: bool


EXPOSURES: dict[Light, Exposure] = {
    "day": Exposure(108, 200, 420, 250, 0, 3, False),
    "overcast": Exposure(126, 236, 420, 250, 0, 4, False),
    "dusk": Exposure(100, 256, 620, 190, 190, 9, False),
    "night": Exposure(126, 300, 1400, 90, 200, 9, True),
}


def illuminate(buffers: Buffers, view: View, grid: Grid, light: Light) -> NDArray[np.uint16]:
    """Return the light that reaches the camera from every pixel.

    Returns
    -------
    (H, W, C) uint16
        65025 at most; C is 3, or 1 where the camera records grey.
    """
    exposure = EXPOSURES[light]
    # A step towards the camera keeps a wall from standing in its own shadow.
    depth = np.maximum(buffers.depth - np.float32(0.35), np.float32(0.2))
    ray_x, ray_y = view.rays
    rows = np.arange(view.height)[:, None] + 0.5
    layer = depth * ((view.horizon - rows) * (1.0 / (view.focal * LAYER))).astype(np.float32)
    layer += view.eye / LAYER
    layer += buffers.jitter[0]
    level = np.minimum(np.maximum(layer, 0.0), LAYERS - 1).astype(np.int64)
    place = _cells(depth, ray_y, view.y - grid.y, buffers.jitter[1], grid.cells.shape[1])
    level *= grid.cells.shape[1]
    level += place
    level *= grid.cells.shape[2]
    level += _cells(depth, ray_x, view.x - grid.x, buffers.jitter[0], grid.cells.shape[2])
    lit = grid.cells.reshape(-1).take(level, mode="clip")
    channels = buffers.colour.view(np.uint8).reshape(view.height, view.width, 4)
    ink = channels[..., 3]
    sky = ink == SKY
    lit[sky] = exposure.sky
    surface = _luminance(channels)[..., None] if exposure.grey else channels[..., :3]
    result = np.multiply(surface, lit[..., None], dtype=np.uint16)
    if exposure.glow:
        table = (np.arange(256, dtype=np.uint32) * np.uint32(exposure.glow * 190) >> 8).astype(np.uint16)
        table[[0, SURFACE, SKY]] = 0
        extra: NDArray[np.uint16] = table[ink][..., None]
        # Adding must not go round at the end of 16 bits.
        np.minimum(result, np.uint16(65025) - extra, out=result)
        result += extra
    return np.asarray(result, dtype=np.uint16)


def _luminance(channels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Turn (H, W, 4) texels into (H, W) brightness."""
    grey = channels[..., 0] * np.uint16(77)
    grey += channels[..., 1] * np.uint16(150)
    grey += channels[..., 2] * np.uint16(29)
    return (grey >> 8).astype(np.uint8)


def _cells(
    depth: NDArray[np.float32], ray: NDArray[np.float64], start: float, jitter: NDArray[np.float32], count: int
) -> NDArray[np.int64]:
    """Return which cell along one axis each pixel's surface lies in."""
    place = depth * (ray * (1.0 / CELL)).astype(np.float32)
    place += jitter
    place += start / CELL
    return np.minimum(np.maximum(place, 0.0), count - 1).astype(np.int64)


def develop(light: NDArray[np.uint16], traverse: TraverseSpec, dice: Dice) -> NDArray[np.uint8]:
    """Turn light into the picture that the camera stores, (H, W, 3) uint8 RGB."""
    exposure = EXPOSURES[traverse.light]
    height, width = light.shape[:2]
    metered = light[::4, ::4]
    mean = int(metered.sum(dtype=np.int64)) // metered.size >> 8
    gain = min(max(exposure.target * 256 // max(mean, 1), exposure.least), exposure.most)
    gain = int(gain * traverse.exposure)
    answer = _CURVE[np.minimum(np.arange(65536, dtype=np.int64) * gain >> 16, 255)]
    picture = answer.take(light)
    if exposure.glow:
        picture = _bloom(picture)
    picture = soften(picture)
    amplitude = int(exposure.noise * traverse.noise * gain / 256)
    noisy = picture.astype(np.int16)
    noisy += _grain(dice, height, width, amplitude)[..., None]
    noisy -= (noisy * _vignette(height, width)[..., None]) >> 8
    picture = np.clip(noisy, 0, 255).astype(np.uint8)
    if exposure.grey:
        return np.repeat(picture, 3, axis=2)
    return picture


def _curve() -> NDArray[np.uint8]:
    """Return the (256,) tone curve that cameras apply: more contrast in the middle, soft shoulders."""
    x = np.arange(256, dtype=np.int64)
    smooth = x * x * (765 - 2 * x) // (255 * 255)
    return ((x + smooth * 2) // 3).astype(np.uint8)


_CURVE = _curve()


def _bloom(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Let bright lights flare over their surroundings."""
    height, width = picture.shape[:2]
    bright = np.maximum(picture.max(axis=2)[::4, ::4], 236) - 236
    spread = (box_sum((bright * 12).astype(np.uint8), 7) // 225).astype(np.uint8)
    spread = (box_sum(spread, 5) // 121).astype(np.uint8)
    veil = np.asarray(cv2.resize(spread, (width, height), interpolation=cv2.INTER_LINEAR_EXACT))
    return np.asarray(np.minimum(picture.astype(np.uint16) + veil[..., None], 255), dtype=np.uint8)


def _grain(dice: Dice, height: int, width: int, amplitude: int) -> NDArray[np.int16]:
    """Return (H, W) int16 noise: fine grain, and coarser blots as a telephone's noise filter leaves them."""
    fine = dice.bytes(height, width).astype(np.int16)
    coarse: NDArray[np.uint8] = np.asarray(
        cv2.resize(dice.bytes(height // 2, width // 2), (width, height), interpolation=cv2.INTER_LINEAR_EXACT),
        dtype=np.uint8,
    )
    fine += coarse
    fine -= 255
    fine *= np.int16(min(amplitude, 120))
    fine >>= 8
    return fine


def _vignette(height: int, width: int) -> NDArray[np.int16]:
    """Return how much darker the picture is towards its corners, in 256ths."""
    rows = (np.arange(height, dtype=np.int64) * 2 - height)[:, None]
    columns = np.arange(width, dtype=np.int64) * 2 - width
    square = rows * rows + columns * columns
    return (square * 52 // (height * height + width * width)).astype(np.int16)
