import numpy as np

from vpr_datasets.simulation.archive import aged
from vpr_datasets.simulation.chance import Dice

IMAGE = np.stack(np.meshgrid(np.arange(120), np.arange(90), [60, 160, 220], indexing="ij"), axis=-1).sum(axis=-1)
PICTURE = np.clip(IMAGE.transpose(1, 0, 2) // 2, 0, 255).astype(np.uint8)


def test_a_print_has_one_tone_less_contrast_and_grain() -> None:
    prints = [aged(PICTURE, Dice(number)) for number in range(12)]
    for one in prints:
        assert one.shape == PICTURE.shape
        assert one.dtype == np.uint8
        # Darker in the corners than it was.
        assert one[:, :, 1].std() > 3
    assert any(np.ptp(one.astype(int), axis=-1).max() == 0 for one in prints)
    assert any(np.ptp(one.astype(int), axis=-1).max() > 20 for one in prints)
    np.testing.assert_array_equal(aged(PICTURE, Dice(3)), prints[3])


def test_the_picture_is_left_alone() -> None:
    before = PICTURE.copy()
    aged(PICTURE, Dice(1))
    np.testing.assert_array_equal(PICTURE, before)
