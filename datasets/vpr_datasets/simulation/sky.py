"""The sky and what stands at the horizon, as a panorama."""

import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.skyline import paint_skyline
from vpr_datasets.simulation.spec import Light, Season
from vpr_datasets.simulation.texture import SKY, Texture, bake

WIDTH, HEIGHT = 4096, 256

RISE = 0.75
"""Slope above the horizon at which the panorama ends."""

ZENITH = {"day": (88, 146, 216), "overcast": (176, 182, 190), "dusk": (74, 84, 140), "night": (40, 42, 54)}
HORIZON = {"day": (206, 224, 238), "overcast": (212, 214, 218), "dusk": (236, 160, 120), "night": (74, 70, 68)}
CLOUD = {"day": (246, 246, 246), "overcast": (226, 228, 230), "dusk": (220, 150, 140), "night": (92, 86, 82)}


def paint_sky(seed: int, weather: int, light: Light, setting: Setting, season: Season) -> Texture:
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
    paint_skyline(Dice(seed, "skyline"), picture, light, setting, season)
    return bake(picture, ink)
