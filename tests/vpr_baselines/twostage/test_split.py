import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from vpr_baselines.twostage.split import TEST, TRAINING, VALIDATION, split
from vpr_bench.types.clusters import Clusters

labelings = st.lists(st.integers(0, 6), min_size=1, max_size=40).map(Clusters.from_labels)


def counts(parts):
    return [int((parts == part).sum()) for part in (TRAINING, VALIDATION, TEST)]


@given(labelings, st.integers(1, 8), st.integers(0, 3))
def test_every_original_trains_and_every_cluster_holds_back_its_tenths(clusters, variants, seed):
    parts = split(clusters, variants, seed)
    assert parts.shape == (len(clusters.labels), variants)
    assert (parts[:, 0] == TRAINING).all()
    for cluster in range(len(clusters)):
        training, validation, test = counts(parts[clusters.members(cluster)])
        total = clusters.sizes[cluster] * variants
        assert training + validation + test == total
        assert validation == test <= 0.1 * total + 0.5


def test_of_a_large_cluster_exactly_a_tenth_is_held_back_for_each():
    assert counts(split(Clusters(np.zeros(100, int)), 6, 0)) == [480, 60, 60]


def test_without_augmentations_all_train():
    assert counts(split(Clusters([0, 0, 1]), 1, 0)) == [3, 0, 0]


def test_it_is_drawn_from_the_seed():
    clusters = Clusters(np.zeros(20, int))
    assert np.array_equal(split(clusters, 6, 1), split(clusters, 6, 1))
    assert not np.array_equal(split(clusters, 6, 1), split(clusters, 6, 2))


def test_clusters_that_are_added_change_nothing_about_the_others():
    before = split(Clusters([0, 1, 0, 1, 1]), 6, 3)
    after = split(Clusters([0, 1, 0, 1, 1, 2, 2, 3]), 6, 3)
    assert np.array_equal(after[:5], before)
