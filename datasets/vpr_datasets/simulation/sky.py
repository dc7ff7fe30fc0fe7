"""The sky and the far skyline, as a panorama."""

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.spec import Light
from vpr_datasets.simulation.texture import SKY, Texture, bake

WIDTH, HEIGHT = 4096, 256

RISE = 0.75
"""Slope above the horizon at which the panorama ends."""

ZENITH = {"day": (88, 146, 216), "dusk": (74, 84, 140), "night": (40, 42, 54)}
HORIZON = {"day": (206, 224, 238), "dusk": (236, 160, 120), "night": (74, 70, 68)}
CLOUD = {"day": (246, 246, 246), "dusk": (220, 150, 140), "night": (92, 86, 82)}


def paint_sky(seed: int, weather: int, light: Light) -> Texture:
    """Paint the sky: the skyline belongs to the place (``seed``), the clouds to the day (``weather``)."""
    share = (np.arange(HEIGHT)[:, None, None] * 256 // HEIGHT).astype(np.int32)
    low, high = np.array(HORIZON[light], dtype=np.int32), np.array(ZENITH[light], dtype=np.int32)
    rgb = np.broadcast_to((high * (256 - share) + low * share) >> 8, (HEIGHT, WIDTH, 3)).astype(np.int32)
    dice = Dice(seed, weather, "clouds")
    clouds = value_noise(dice, HEIGHT, WIDTH, 128, 5).astype(np.int32)
    cover = np.clip((clouds - 118 - dice.below(24)) * 6, 0, 230)[..., None]
    rgb = (rgb * (256 - cover) + np.array(CLOUD[light], dtype=np.int32) * cover) >> 8
    ink = np.full((HEIGHT, WIDTH), SKY, dtype=np.uint8)
    picture = rgb.astype(np.uint8)
    _paint_skyline(Dice(seed, "skyline"), picture, light)
    return bake(picture, ink)


def _paint_skyline(dice: Dice, picture: np.ndarray[tuple[int, ...], np.dtype[np.uint8]], light: Light) -> None:
    """Put blocks and tree tops along the lower edge."""
    dim = {"day": 256, "dusk": 120, "night": 60}[light]
    x = 0
    while x < WIDTH:
        width, tall = 14 + dice.below(60), 6 + dice.below(34)
        grey = (130 + dice.below(70)) * dim >> 8
        if dice.chance(0.55):
            block = picture[HEIGHT - tall :, x : x + width]
            block[:] = (grey, grey, min(grey + 8, 255))
            bright = 235 if light != "day" else grey * 3 // 4
            for row in range(3, tall - 2, 4):
                for column in range(2, block.shape[1] - 2, 5):
                    if light == "day" or dice.chance(0.25):
                        block[row : row + 2, column : column + 3] = bright
        x += width // 2 + dice.below(30)
    tops = value_noise(dice, 1, WIDTH, 64, 4)[0].astype(np.int64) // 7
    rows = np.arange(HEIGHT)[:, None]
    green = rows >= HEIGHT - tops
    tone = value_noise(dice, HEIGHT, WIDTH, 8, 2).astype(np.int32)[..., None]
    leaf = (np.array((60, 84, 56), dtype=np.int32) * (128 + tone) >> 8) * dim >> 8
    picture[green] = np.broadcast_to(leaf, picture.shape)[green].astype(np.uint8)
