import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.types.clusters import Clusters

LABELS = st.lists(st.integers(-3, 6), max_size=40)


def test_stretches_of_a_sequence():
    clusters = Clusters.from_starts([0, 3, 4], 6)
    assert len(clusters) == 3 and clusters.contiguous
    assert clusters.labels.tolist() == [0, 0, 0, 1, 2, 2]
    assert (clusters.starts.tolist(), clusters.stops.tolist()) == ([0, 3, 4], [3, 4, 6])
    assert clusters.sizes.tolist() == [3, 1, 2]


def test_clusters_that_are_no_stretches():
    clusters = Clusters([0, 1, 0, 2, 1])
    assert not clusters.contiguous
    assert clusters.members(1).tolist() == [1, 4]
    assert (clusters.starts.tolist(), clusters.stops.tolist()) == ([0, 1, 3], [3, 5, 4])


def test_no_reference_has_no_cluster():
    assert len(Clusters([])) == 0 and Clusters([]).contiguous


@given(LABELS)
def test_any_labels_become_a_numbering_by_first_appearance(labels):
    clusters = Clusters.from_labels(labels)
    assert [clusters.labels.tolist()[one] for one in clusters.starts] == list(range(len(set(labels))))
    for first in range(len(labels)):
        for second in range(len(labels)):
            assert (labels[first] == labels[second]) == (clusters.labels[first] == clusters.labels[second])


@given(LABELS)
def test_members_are_every_reference_exactly_once(labels):
    clusters = Clusters.from_labels(labels)
    members = [clusters.members(number) for number in range(len(clusters))]
    assert sorted(one for row in members for one in row.tolist()) == list(range(len(labels)))
    for number, row in enumerate(members):
        assert (row[0], row[-1] + 1, len(row)) == (
            clusters.starts[number],
            clusters.stops[number],
            clusters.sizes[number],
        )


def test_cohesion_goes_with_the_clusters():
    cohesion = Clusters([0, 1], [0.5, 1]).cohesion
    assert cohesion is not None and cohesion.dtype == np.float32


def test_labels_cannot_be_changed_behind_the_back_of_what_follows_from_them():
    clusters = Clusters([0, 0])
    with pytest.raises(ValueError, match="read-only"):
        clusters.labels[0] = 1


@pytest.mark.parametrize("labels", [[1, 0], [0, 2], [0, 1, 3], [-1, 0], [[0, 1]], [0.0, 1.0]])
def test_what_is_no_numbering_is_refused(labels):
    with pytest.raises(ValueError, match="clusters"):
        Clusters(labels)


@pytest.mark.parametrize("starts", [[], [1], [0, 0], [0, 5], [0, 3, 2]])
def test_what_are_no_starts_is_refused(starts):
    with pytest.raises(ValueError, match="starts must ascend"):
        Clusters.from_starts(starts, 5)


@pytest.mark.parametrize("cohesion", [[0.5], [0.5, float("nan")], [[0.5, 0.5]]])
def test_cohesion_must_fit(cohesion):
    with pytest.raises(ValueError, match="cohesion"):
        Clusters([0, 1], cohesion)
