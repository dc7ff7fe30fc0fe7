import numpy as np
import pytest

from vpr_baselines.clustering.sizes import limited
from vpr_bench.types.clusters import Clusters


def limit(places, labels, low=1, high=None):
    rows = np.array(places, dtype=np.float32)[:, None]
    return Clusters.from_labels(limited(rows, np.array(labels), "l1", low, high)).labels.tolist()


def test_clusters_within_the_limits_stay_as_they_are():
    assert limit([0, 5, 9], [0, 1, 0], 1, 2) == [0, 1, 0]


def test_a_small_stretch_joins_the_closer_neighbour():
    assert limit([0, 0, 7, 9, 9], [0, 0, 1, 2, 2], 2) == [0, 0, 1, 1, 1]
    assert limit([0, 0, 2, 9, 9], [0, 0, 1, 2, 2], 2) == [0, 0, 0, 1, 1]


def test_a_small_stretch_joins_the_farther_neighbour_if_only_that_has_room():
    assert limit([0, 0, 7, 9, 9, 9], [0, 0, 1, 2, 2, 2], 2, 3) == [0, 0, 0, 1, 1, 1]


def test_a_large_stretch_is_split_at_its_weakest_point_and_no_more_often_than_needed():
    assert limit([0, 1, 6, 7, 8, 20], [0] * 5 + [1], 1, 3) == [0, 0, 1, 1, 1, 2]


def test_other_cuts_stay_where_they_are():
    assert limit([0, 3, 1, 6, 7, 8, 9], [0, 1, 1, 2, 2, 2, 2], 1, 3)[:3] == [0, 1, 1]


def test_a_small_cluster_joins_the_closest_one_wherever_that_is():
    assert limit([0, 0, 9, 9, 1, 0], [0, 0, 1, 1, 2, 0], 2) == [0, 0, 1, 1, 0, 0]


def test_a_large_cluster_that_is_no_stretch_is_split_where_its_images_are_least_alike():
    assert limit([0, 50, 1, 51, 9, 8], [0, 1, 0, 1, 0, 0], 1, 2) == [0, 1, 0, 1, 2, 2]


def test_limits_that_leave_no_choice_are_kept():
    assert sorted(np.bincount(limit([0, 9, 0, 9, 0, 0], [0, 1, 0, 1, 0, 0], 3, 3))) == [3, 3]


def test_what_cannot_be_divided_is_refused():
    with pytest.raises(ValueError, match="5 references cannot be divided into clusters of 3 to 4"):
        limit([0] * 5, [0] * 5, 3, 4)
