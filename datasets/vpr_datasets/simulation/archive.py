"""What becomes of a photograph in an archive: it loses its colours, fades, and collects dust and scratches."""

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.noise import soften, value_noise

TONES = ((256, 256, 256), (256, 256, 256), (262, 252, 236), (268, 250, 216), (262, 242, 200), (250, 254, 258))
"""Silver, brown and cold prints: 256ths of the grey in red, green and blue."""

PAPER = (226, 218, 200)


def aged(image: NDArray[np.uint8], dice: Dice) -> NDArray[np.uint8]:
    """Turn an (H, W, 3) uint8 RGB picture into the scan of an old print of it; same shape."""
    grey = _print(image, dice)
    height, width = grey.shape
    values: NDArray[np.int32] = grey.astype(np.int32)
    values += (value_noise(dice, height, width, 160, 3).astype(np.int32) - 128) * 26 >> 7
    values += (_grain(dice, height, width) * (9 + dice.below(10))) >> 7
    values -= values * _falloff(dice, height, width) >> 8
    grey = np.ascontiguousarray(np.clip(values, 0, 255), dtype=np.uint8)
    _scratch(grey, dice)
    tone = np.array(dice.pick(TONES), dtype=np.int32)
    picture = np.ascontiguousarray(np.minimum(grey.astype(np.int32)[..., None] * tone >> 8, 255), dtype=np.uint8)
    if dice.chance(0.3):
        _mount(picture, dice)
    return picture


def _print(image: NDArray[np.uint8], dice: Dice) -> NDArray[np.uint8]:
    """Record brightness on a plate that is blind to red, through a soft lens, with faded contrast."""
    wide = image.astype(np.uint32)
    grey = ((wide[..., 0] * 34 + wide[..., 1] * 112 + wide[..., 2] * 110) >> 8).astype(np.uint8)
    for _ in range(1 + dice.below(2)):
        grey = soften(grey)
    black, white = 18 + dice.below(34), 196 + dice.below(48)
    steep = 236 + dice.below(70)
    stretched = np.clip((grey.astype(np.int32) - 118) * steep // 256 + 118, 0, 255)
    return np.asarray(black + stretched * (white - black) // 255, dtype=np.uint8)


def _grain(dice: Dice, height: int, width: int) -> NDArray[np.int32]:
    """Return (H, W) grain from -128 to 127, in clumps of about two pixels."""
    clumps = np.asarray(
        cv2.resize(dice.bytes(height // 2 + 1, width // 2 + 1), (width, height), interpolation=cv2.INTER_LINEAR_EXACT)
    )
    return (clumps.astype(np.int32) + dice.bytes(height, width) >> 1) - 128


def _falloff(dice: Dice, height: int, width: int) -> NDArray[np.int32]:
    """Return how much darker the picture is towards its corners, in 256ths."""
    rows = (np.arange(height, dtype=np.int64) * 2 - height)[:, None]
    columns = np.arange(width, dtype=np.int64) * 2 - width
    square = rows * rows + columns * columns
    most = 60 + dice.below(80)
    return np.asarray(square * most // (height * height + width * width), dtype=np.int32)


def _scratch(grey: NDArray[np.uint8], dice: Dice) -> None:
    """Draw scratches, hairs and specks of dust."""
    height, width = grey.shape
    for _ in range(dice.below(5)):
        x, y = dice.below(width), dice.below(height)
        drift = dice.below(9) - 4
        cv2.line(grey, (x, y), (x + drift, y + dice.below(height)), [dice.pick((232, 214, 40))], 1)
    for _ in range(dice.below(3)):
        x, y, shade = dice.below(width), dice.below(height), dice.pick((226, 52))
        for _ in range(8):
            left, down = x + dice.below(11) - 5, y + dice.below(11) - 3
            cv2.line(grey, (x, y), (left, down), [shade], 1)
            x, y = left, down
    for _ in range(20 + dice.below(70)):
        centre = dice.below(width), dice.below(height)
        cv2.circle(grey, centre, dice.pick((0, 0, 0, 1, 1, 2)), [dice.pick((236, 224, 60))], -1)


def _mount(picture: NDArray[np.uint8], dice: Dice) -> None:
    """Leave the paper's white margin, not quite straight, on all sides."""
    height, width = picture.shape[:2]
    paper = np.array(PAPER, dtype=np.int32) - dice.below(24)
    edges = [6 + dice.below(max(width // 40, 4)) for _ in range(4)]
    rough = value_noise(dice, height, width, 24, 2).astype(np.int32) - 128 >> 4
    rows, columns = np.arange(height)[:, None], np.arange(width)
    lean = dice.below(7) - 3
    outside = rows < edges[0] + columns * lean // width
    outside = outside | (rows >= height - edges[1] + columns * lean // width)
    outside |= (columns < edges[2] + rows * lean // height) | (columns >= width - edges[3] + rows * lean // height)
    blank = np.clip(paper + rough[..., None], 0, 255).astype(np.uint8)
    picture[outside] = blank[outside]
