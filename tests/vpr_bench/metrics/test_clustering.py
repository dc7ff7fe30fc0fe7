import math

import numpy as np
import pytest

from vpr_bench.metrics.clustering import central_members, distortion, silhouette
from vpr_bench.types.clusters import Clusters


def line(*places):
    return np.array(places, dtype=np.float32)[:, None]


def test_silhouette_by_hand():
    # 0 is 1 from its own, 10 from the other cluster: 1 - 1/10; 1 is 9 from it: 1 - 1/9; the lonely one counts 0.
    assert silhouette(line(0, 1, 10), Clusters([0, 0, 1])) == pytest.approx((0.9 + 8 / 9) / 3)


def test_silhouette_prefers_the_clusters_that_are_there():
    rows = line(0, 1, 0, 50, 51, 50)
    assert silhouette(rows, Clusters([0, 0, 0, 1, 1, 1])) > 0.9 > silhouette(rows, Clusters([0, 0, 1, 1, 2, 2]))


@pytest.mark.parametrize("labels", [[0, 0, 0], [0, 1, 2], [0]])
def test_there_is_no_silhouette_of_one_cluster_or_of_one_for_each(labels):
    assert math.isnan(silhouette(line(*range(len(labels))), Clusters(labels)))


def test_there_is_no_silhouette_of_very_many(monkeypatch):
    monkeypatch.setattr("vpr_bench.metrics.clustering.MOST", 3)
    assert math.isnan(silhouette(line(0, 1, 2, 3), Clusters([0, 0, 1, 1])))


def test_distortion_falls_to_nothing():
    rows = line(0, 2, 10, 14)
    assert distortion(rows, Clusters([0, 0, 0, 0])) == pytest.approx(np.square(rows - 6.5).sum())
    assert distortion(rows, Clusters([0, 0, 1, 1])) == 2 + 8
    assert distortion(rows, Clusters([0, 1, 2, 3])) == 0


def test_central_members_are_nearest_to_the_mean_or_in_the_middle():
    clusters = Clusters([0, 0, 1, 0, 1])
    assert central_members(clusters, line(0, 4, 7, 5, 7)).tolist() == [1, 2]
    assert central_members(clusters).tolist() == [1, 2]
