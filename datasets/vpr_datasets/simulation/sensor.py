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
from vpr_datasets.simulation.texture import SKY
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
    colour
        How much colour is kept, in 256ths.
    """

    target: int
    least: int
    most: int
    sky: int
    glow: int
    noise: int
    colour: int


EXPOSURES: dict[Light, Exposure] = {
    "day": Exposure(108, 200, 420, 250, 0, 3, 256),
    "dusk": Exposure(100, 256, 620, 190, 190, 9, 200),
    "night": Exposure(126, 300, 1400, 90, 256, 10, 0),
}


def illuminate(buffers: Buffers, view: View, grid: Grid, light: Light) -> NDArray[np.uint16]:
    """Return the light that reaches the camera from every pixel, (H, W, 3) uint16, 65025 at most."""
    exposure = EXPOSURES[light]
    # A step towards the camera keeps a wall from standing in its own shadow.
    depth = np.maximum(buffers.depth - 0.35, 0.2)
    ray_x, ray_y = view.rays
    rows = np.arange(view.height)[:, None] + 0.5
    layer = depth * ((view.horizon - rows) * (1.0 / (view.focal * LAYER)))
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
    result = np.multiply(channels[..., :3], lit[..., None], dtype=np.uint16)
    if exposure.glow:
        table = np.arange(256, dtype=np.uint32) * np.uint32(exposure.glow)
        table[:2] = 0
        table[SKY] = 0
        extra = (table * np.uint32(190) >> 8).astype(np.uint16)[ink]
        result = np.minimum(result.astype(np.uint32) + extra[..., None], 65025).astype(np.uint16)
    return result


def _cells(
    depth: NDArray[np.float64], ray: NDArray[np.float64], start: float, jitter: NDArray[np.float64], count: int
) -> NDArray[np.int64]:
    """Return which cell along one axis each pixel's surface lies in."""
    place = depth * (ray * (1.0 / CELL))
    place += jitter
    place += start / CELL
    return np.minimum(np.maximum(place, 0.0), count - 1).astype(np.int64)


def develop(light: NDArray[np.uint16], traverse: TraverseSpec, dice: Dice) -> NDArray[np.uint8]:
    """Turn light into the picture that the camera stores, (H, W, 3) uint8 RGB."""
    exposure = EXPOSURES[traverse.light]
    height, width = light.shape[:2]
    if exposure.colour == 0:
        grey = (
            light[..., 0].astype(np.uint32) * np.uint32(77)
            + light[..., 1].astype(np.uint32) * np.uint32(150)
            + light[..., 2].astype(np.uint32) * np.uint32(29)
        ) >> 8
        light = grey.astype(np.uint16)[..., None]
    mean = int(light[::4, ::4].astype(np.int64).sum()) * 16 // (light.size or 1) >> 8
    gain = min(max(exposure.target * 256 // max(mean, 1), exposure.least), exposure.most)
    picture = np.minimum(light * np.float64(gain / 65536.0), 255.0).astype(np.uint8)
    picture = _CURVE[picture]
    if exposure.glow:
        picture = _bloom(picture)
    picture = soften(picture)
    amplitude = int(exposure.noise * traverse.noise * gain / 256)
    noisy = picture.astype(np.int16)
    noisy += _grain(dice, height, width, amplitude)[..., None]
    noisy -= (noisy * _vignette(height, width)[..., None]) >> 8
    picture = np.clip(noisy, 0, 255).astype(np.uint8)
    if exposure.colour == 0:
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
    coarse = np.asarray(
        cv2.resize(dice.bytes(height // 2, width // 2), (width, height), interpolation=cv2.INTER_LINEAR_EXACT)
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
