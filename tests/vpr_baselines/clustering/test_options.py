import pytest

from vpr_baselines.clustering.options import ClusteringOptions


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({}, "'count' needs n_clusters"),
        ({"kind": "leader"}, "'leader' needs threshold"),
        ({"kind": "labels"}, "'labels' needs labels"),
        ({"kind": "leader", "threshold": 0.7, "n_clusters": 5}, "'leader' does not use n_clusters"),
        ({"n_clusters": 5, "labels": (1, 2)}, "'count' does not use labels"),
        ({"kind": "leeder", "threshold": 0.7}, "kind must be one of count, leader"),
        ({"distance": "manhattan", "n_clusters": 5}, "distance must be one of cosine, l1, l2"),
        ({"kind": "chain", "threshold": 340}, "cosine must be from -1 to 1. Got 340"),
        ({"kind": "chain", "threshold": -0.1, "distance": "l1"}, "l1 must be at least 0"),
        ({"kind": "chain", "threshold": float("nan"), "distance": "l1"}, "l1 must be at least 0"),
        ({"n_clusters": 0}, "n_clusters must be at least 1"),
        ({"n_clusters": 2, "min_size": 0}, "min_size must be at least 1"),
        ({"n_clusters": 2, "min_size": 5, "max_size": 4}, "min_size=5, max_size=4"),
        ({"kind": "kmeans", "n_clusters": 2, "distance": "l1"}, "cosine or l2"),
    ],
)
def test_combinations_that_make_no_sense_are_refused(given, message):
    with pytest.raises(ValueError, match=message):
        ClusteringOptions(**given)


def test_labels_may_be_a_list_and_options_are_hashable():
    assert hash(ClusteringOptions("labels", labels=[0, 1])) == hash(ClusteringOptions("labels", labels=(0, 1)))
