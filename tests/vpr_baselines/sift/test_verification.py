import cv2
import numpy as np
import pytest

from vpr_baselines.sift.verification import consistent

POINTS = np.random.default_rng(0).uniform(0, 400, (80, 2)).astype(np.float32)


def half_moved():
    """Return points of which the first 50 move together and the others anywhere."""
    moved = POINTS @ np.float32([[0.9, 0.1], [-0.1, 0.9]]) + np.float32([20, 5])
    moved[50:] = np.random.default_rng(1).uniform(0, 400, (30, 2))
    return moved.astype(np.float32)


@pytest.mark.parametrize("geometry", ["homography", "fundamental"])
def test_what_moves_together_is_told_from_what_does_not(geometry):
    kept = consistent(POINTS, half_moved(), geometry)
    assert kept.shape == (80,) and kept.dtype == np.bool_
    assert kept[:50].sum() >= 48
    assert kept[50:].sum() <= 6


@pytest.mark.parametrize("geometry", ["homography", "fundamental"])
def test_the_same_pairs_give_the_same_answer(geometry):
    answers = {consistent(POINTS, half_moved(), geometry).tobytes() for _ in range(5)}
    assert len(answers) == 1


@pytest.mark.parametrize("geometry", ["homography", "fundamental"])
@pytest.mark.parametrize("count", [0, 1, 3, 7, 8, 20])
def test_too_few_or_degenerate_pairs_are_no_error(geometry, count):
    same = np.ones((count, 2), np.float32)
    assert consistent(same, same, geometry).shape == (count,)
    assert not consistent(POINTS[:3], POINTS[:3], geometry).any()


def test_where_opencv_finds_no_model_nothing_is_consistent(monkeypatch):
    def fail(*arguments, **options):
        raise cv2.error("(-215:Assertion failed) !model.empty()")

    monkeypatch.setattr(cv2, "findFundamentalMat", fail)
    assert not consistent(POINTS, POINTS, "fundamental").any()
