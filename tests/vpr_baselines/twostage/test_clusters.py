import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_baselines.twostage.clusters import Clusters, by_count, by_similarity


def directions(*degrees):
    """Unit vectors in the plane: (n, 2) float32."""
    angles = np.radians(degrees)
    return np.stack([np.cos(angles), np.sin(angles)], axis=1).astype(np.float32)


def test_a_cluster_ends_where_an_image_no_longer_resembles_its_first():
    # cos 40° is 0.77: each step is small, but the third image is too far from where the cluster began.
    assert by_similarity(directions(0, 20, 41, 60, 90), 0.766).bounds.tolist() == [0, 2, 4, 5]


def test_the_threshold_itself_is_similar_enough():
    assert len(by_similarity(np.eye(2, dtype=np.float32), 0.0)) == 1
    assert len(by_similarity(np.eye(2, dtype=np.float32), 1e-6)) == 2


def test_a_place_that_comes_back_starts_another_cluster():
    assert by_similarity(directions(0, 90, 0), 0.5).bounds.tolist() == [0, 1, 2, 3]


def test_identical_images_are_one_cluster():
    assert by_similarity(directions(*[30] * 6), 0.99).bounds.tolist() == [0, 6]


@pytest.mark.parametrize("images", [np.eye(5, dtype=np.float32), np.zeros((5, 3), np.float32)], ids=["unlike", "empty"])
def test_images_that_resemble_nothing_are_clusters_of_their_own(images):
    assert by_similarity(images, 0.65).bounds.tolist() == [0, 1, 2, 3, 4, 5]


def test_a_number_of_clusters_is_cut_where_neighbours_differ_most():
    images = directions(0, 5, 50, 55, 85, 86)
    assert by_count(images, 1).bounds.tolist() == [0, 6]
    assert by_count(images, 2).bounds.tolist() == [0, 2, 6]
    assert by_count(images, 3).bounds.tolist() == [0, 2, 4, 6]


def test_more_clusters_than_images_are_one_for_each():
    assert by_count(directions(0, 5, 50), 10).bounds.tolist() == [0, 1, 2, 3]


def test_identical_images_are_cut_into_the_number_asked_for():
    assert len(by_count(directions(*[30] * 6), 4)) == 4


def test_one_image_is_one_cluster():
    for clusters in (by_similarity(directions(0), 0.65), by_count(directions(0), 3)):
        assert clusters.bounds.tolist() == [0, 1] and clusters.labels.tolist() == [0]


@given(st.lists(st.integers(0, 359), min_size=1, max_size=20), st.integers(1, 25), st.floats(-1, 1))
def test_clusters_always_cover_the_sequence_in_order(degrees, count, threshold):
    images = directions(*degrees)
    assert len(by_count(images, count)) == min(count, len(images))
    for clusters in (by_count(images, count), by_similarity(images, threshold)):
        covered = [index for one in range(len(clusters)) for index in range(len(images))[clusters.stretch(one)]]
        assert covered == list(range(len(images)))
        assert [clusters.labels[clusters.stretch(one)].tolist() for one in range(len(clusters))] == [
            [one] * (stop - start)
            for one, (start, stop) in enumerate(zip(clusters.bounds, clusters.bounds[1:], strict=False))
        ]


@pytest.mark.parametrize("bounds", [[], [0], [1, 3], [0, 2, 2], [0, 3, 1]])
def test_bounds_that_cover_nothing_are_refused(bounds):
    with pytest.raises(ValueError, match="must start at 0 and increase"):
        Clusters(np.array(bounds, dtype=np.int64))
