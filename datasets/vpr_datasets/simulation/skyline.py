"""What stands at the horizon, painted along the lower edge of the sky's panorama."""

import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.floors import WOODLAND
from vpr_datasets.simulation.noise import value_noise
from vpr_datasets.simulation.plants import EVERGREEN, LEAVES
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Light, Season
from vpr_datasets.simulation.texture import Colour

Picture = NDArray[np.uint8]

DIM = {"day": 256, "overcast": 236, "dusk": 120, "night": 60}
"""How bright the horizon is, in 256ths."""


def paint_skyline(dice: Dice, picture: Picture, light: Light, setting: Setting, season: Season) -> None:
    """Paint what the setting has at its horizon."""
    if setting.skyline == "hills":
        _hills(dice, picture, light, season, setting.snow.get(season, 0.0))
        return
    if setting.skyline == "town":
        _town(dice, picture, light)
    _trees(dice, picture, light)


def _town(dice: Dice, picture: Picture, light: Light) -> None:
    """Put up blocks, some of them with windows."""
    height, span = picture.shape[:2]
    x = 0
    while x < span:
        width, tall = 14 + dice.below(60), 6 + dice.below(34)
        grey = (130 + dice.below(70)) * DIM[light] >> 8
        if dice.chance(0.55):
            block = picture[height - tall :, x : x + width]
            block[:] = (grey, grey, min(grey + 8, 255))
            bright = 235 if light in ("dusk", "night") else grey * 3 // 4
            for row in range(3, tall - 2, 4):
                for column in range(2, block.shape[1] - 2, 5):
                    if light not in ("dusk", "night") or dice.chance(0.25):
                        block[row : row + 2, column : column + 3] = bright
        x += width // 2 + dice.below(30)


def _trees(dice: Dice, picture: Picture, light: Light) -> None:
    """Let tree tops hide the feet of whatever is there."""
    height, span = picture.shape[:2]
    tops = value_noise(dice, 1, span, 64, 4)[0].astype(np.int64) // 7
    green = np.arange(height)[:, None] >= height - tops
    tone = value_noise(dice, height, span, 8, 2).astype(np.int32)[..., None]
    leaf = (np.array((60, 84, 56), dtype=np.int32) * (128 + tone) >> 8) * DIM[light] >> 8
    picture[green] = np.broadcast_to(leaf, picture.shape)[green].astype(np.uint8)


def _hills(dice: Dice, picture: Picture, light: Light, season: Season, snow: float) -> None:
    """Stagger mountains and wooded hills: the farther, the bluer."""
    # Half of the woods are spruces, which are green all year.
    wood = _mean(_mean(WOODLAND[season], LEAVES[season][0]), EVERGREEN[2])
    _ridge(dice, picture, light, 88, 420, (138, 152, 172), 0.3 + snow * 0.4)
    _ridge(dice, picture, light, 62, 320, (112, 130, 142), snow * 0.75)
    _ridge(dice, picture, light, 40, 200, _mean(wood, (108, 128, 138)), snow * 0.7)
    _ridge(dice, picture, light, 22, 96, wood, snow * 0.5)


def _mean(first: Colour, second: Colour) -> Colour:
    red, green, blue = ((a + b) // 2 for a, b in zip(first, second, strict=True))
    return red, green, blue


def _ridge(dice: Dice, picture: Picture, light: Light, tall: int, cell: int, colour: Colour, snow: float) -> None:
    """Raise one ridge of at most ``tall`` pixels; snow lies from its top down."""
    height, span = picture.shape[:2]
    profile = value_noise(dice, 1, span, cell, 6)[0].astype(np.int64)
    tops = np.maximum((profile - 56) * tall // 150, 3)
    rows = np.arange(height)[:, None]
    solid = rows >= height - tops
    tone = value_noise(dice, height, span, 12, 3).astype(np.int32)
    rough = value_noise(dice, height, span, 40, 4).astype(np.int32)
    body = np.array(colour, dtype=np.int32) * (160 + tone[..., None] * 3 // 4) >> 8
    level = (height - rows) * 256 // max(tall, 1) + rough - 128
    white = (level > int(256 - 330 * snow)) & (rough + tone > 228)
    drift = np.array((214, 221, 230), dtype=np.int32) * (200 + tone[..., None] * 3 // 8) >> 8
    body = np.where(white[..., None], drift, body)
    body = body * DIM[light] >> 8
    picture[solid] = np.minimum(body, 255)[solid].astype(np.uint8)
