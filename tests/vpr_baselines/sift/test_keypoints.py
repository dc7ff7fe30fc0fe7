import cv2
import numpy as np
import pytest

from vpr_baselines.sift.keypoints import detect, root_sift


def test_they_are_opencvs_the_strongest_first(scenes):
    image = scenes[0]
    points = detect(image, size=240, limit=10_000)
    theirs, descriptors = cv2.SIFT_create().detectAndCompute(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), None)
    order = np.argsort([-one.response for one in theirs], kind="stable")
    assert len(points.positions) > 50
    assert np.array_equal(points.positions, np.float32([one.pt for one in theirs])[order])
    assert np.array_equal(points.descriptors, descriptors[order])


def test_there_are_no_more_than_asked_for_even_where_many_are_equally_strong():
    squares = np.zeros((200, 200, 3), np.uint8)
    for top in range(10, 190, 30):
        for left in range(10, 190, 30):
            squares[top : top + 12, left : left + 12] = 255
    assert len(detect(squares, 200, 20).positions) == 20


@pytest.mark.parametrize("shape", [(1, 1), (3, 200), (600, 7), (180, 240)])
def test_an_image_without_key_points_has_none(shape):
    points = detect(np.full((*shape, 3), 128, np.uint8), 480, 500)
    assert points.positions.shape == (0, 2) and points.descriptors.shape == (0, 128)
    assert root_sift(points.descriptors).shape == (0, 128)


def test_portrait_and_landscape_are_resized_alike(scenes):
    upright = detect(np.rot90(scenes[0]), 120, 500)
    assert upright.positions[:, 0].max() < 90 and 90 < upright.positions[:, 1].max() < 120


def test_root_sift_is_a_unit_vector_of_roots():
    descriptors = np.random.default_rng(0).integers(0, 256, (7, 128), dtype=np.uint8)
    descriptors[3] = 0
    roots = root_sift(descriptors)
    expected = np.sqrt(descriptors / np.maximum(descriptors.sum(axis=1, keepdims=True, dtype=np.float64), 1))
    assert roots == pytest.approx(expected, rel=2**-8)
    assert np.linalg.norm(roots, axis=1) == pytest.approx([1, 1, 1, 0, 1, 1, 1], abs=2**-8)
