import numpy as np

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.noise import box_sum, soften, value_noise
from vpr_datasets.simulation.path import lay_course
from vpr_datasets.simulation.texture import bake


def test_dice_follow_the_raw_stream() -> None:
    # Fixed by the definitions of SeedSequence and PCG64, not by NumPy's choice of algorithms.
    dice = Dice(1, "tree")
    assert [dice.below(1000) for _ in range(4)] == [784, 646, 360, 546]
    assert Dice(1).bytes(2, 3).tolist() == [[255, 228, 34], [121, 243, 189]]


def test_dice_stay_within_their_bounds() -> None:
    dice = Dice(3)
    values = [dice.between(-2, 5) for _ in range(500)]
    assert -2 <= min(values) < -1.5
    assert 4.5 < max(values) < 5
    assert sorted(dice.shuffled(range(9))) == list(range(9))


def test_noise_and_blurs_are_level() -> None:
    noise = value_noise(Dice(1), 60, 80, 16, 3)
    assert noise.shape == (60, 80)
    assert 100 < noise.mean() < 156
    flat = np.full((5, 7, 3), 77, dtype=np.uint8)
    np.testing.assert_array_equal(soften(flat), flat)
    assert (box_sum(flat[..., 0], 1) == 9 * 77).all()


def test_path_has_the_length_and_the_slopes_it_should() -> None:
    course = lay_course(5, 100.0, 0.3, before=20.0, beyond=30.0)
    assert course.stop >= 130
    assert np.abs(course.slope).max() <= 0.3
    (x0, y0), (x1, y1) = course.point(40, 0), course.point(41, 0)
    assert abs((x1 - x0) ** 2 + (y1 - y0) ** 2 - 1) < 0.01
    left = np.subtract(course.point(40, 1), (x0, y0))
    assert abs(float(np.dot(left, course.tangent(40)))) < 1e-9
    assert left[1] > 0


def test_transparent_texels_do_not_bleed() -> None:
    rgb = np.zeros((4, 4, 3), dtype=np.uint8)
    ink = np.zeros((4, 4), dtype=np.uint8)
    rgb[:, :1], ink[:, :1] = 200, 1
    texture = bake(rgb, ink)
    second = texture.texels[texture.offsets[1] : texture.offsets[2]].reshape(2, 2)
    assert not texture.solid
    assert (second[:, 0] == 1 << 24 | 200 << 16 | 200 << 8 | 200).all()
    assert (second[:, 1] == 0).all()
