import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_baselines.clustering.cluster import cluster_descriptors, cohesion
from vpr_baselines.clustering.options import ClusteringOptions
from vpr_bench.types.clusters import Clusters

SEQUENTIAL = ("count", "leader", "chain")


def line(*places):
    """Return images that are as far apart as numbers: (n, 1) float32."""
    return np.array(places, dtype=np.float32)[:, None]


def directions(*degrees):
    """Return unit vectors in the plane: (n, 2) float32."""
    angles = np.radians(degrees)
    return np.stack([np.cos(angles), np.sin(angles)], axis=1).astype(np.float32)


def clustered(rows, kind, distance="l1", **options):
    return cluster_descriptors(rows, ClusteringOptions(kind, distance, **options))


def labels(rows, kind, distance="l1", **options):
    return clustered(rows, kind, distance, **options).labels.tolist()


@st.composite
def sequences(draw):
    n = draw(st.integers(1, 24))
    values = st.integers(0, 5)
    return np.array([[draw(values), draw(values)] for _ in range(n)], dtype=np.float32)


@st.composite
def options(draw, n):
    kind = draw(st.sampled_from(["count", "leader", "chain", "kmeans", "focus", "labels"]))
    distance = draw(st.sampled_from(["cosine", "l2"] if kind == "kmeans" else ["cosine", "l1", "l2"]))
    given = {"min_size": draw(st.integers(1, n)), "max_size": draw(st.none() | st.integers(1, n + 2))}
    if kind in ("count", "kmeans"):
        given["n_clusters"] = draw(st.integers(1, n))
    elif kind == "labels":
        given["labels"] = draw(st.lists(st.integers(0, 5), min_size=n, max_size=n))
    else:
        given["threshold"] = draw(st.floats(-1, 1) if distance == "cosine" else st.floats(0, 10))
    return {"kind": kind, "distance": distance, **given}


@given(st.data())
def test_sizes_are_within_their_limits_or_refused_for_a_reason(data):
    rows = data.draw(sequences())
    n = len(rows)
    chosen = data.draw(options(n))
    low, high = chosen["min_size"], chosen["max_size"] or n
    counts = [count for count in range(1, n + 1) if count * low <= n <= count * high]
    try:
        clusters = cluster_descriptors(rows, ClusteringOptions(**chosen))
    except ValueError:
        asked = chosen.get("n_clusters", 1)
        different = asked <= len(
            np.unique(np.round(rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-12), 4), axis=0)
        )
        possible = low <= high and (asked in counts if chosen["kind"] == "count" else bool(counts))
        assert not possible or (chosen["kind"] == "kmeans" and not different)
        return
    assert low <= clusters.sizes.min() and clusters.sizes.max() <= high
    assert clusters.sizes.sum() == n and clusters.cohesion is not None and len(clusters.cohesion) == len(clusters)
    if chosen["kind"] in SEQUENTIAL:
        assert clusters.contiguous
    if chosen["kind"] == "count":
        assert len(clusters) == chosen["n_clusters"]


@given(sequences(), st.sampled_from(["leader", "chain", "focus"]), st.floats(-1, 1), st.floats(0.1, 100))
def test_the_cosine_does_not_know_how_long_descriptors_are(rows, kind, threshold, scale):
    # Exactly at the threshold, rounding decides.
    unit = rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-12)
    if np.abs(unit @ unit.T - threshold).min() > 1e-5:
        assert labels(rows, kind, "cosine", threshold=threshold) == labels(
            rows * np.float32(scale), kind, "cosine", threshold=threshold
        )


@given(sequences(), st.sampled_from(["leader", "chain", "focus"]), st.integers(0, 10), st.integers(-20, 20))
def test_distances_do_not_know_where_the_origin_is(rows, kind, threshold, shift):
    assert labels(rows, kind, threshold=threshold) == labels(rows + shift, kind, threshold=threshold)


@given(sequences(), st.data())
def test_the_best_cut_is_no_worse_than_any_other(rows, data):
    count = data.draw(st.integers(1, len(rows)))
    cuts = (
        data.draw(st.sets(st.integers(1, max(len(rows) - 1, 1)), min_size=count - 1, max_size=count - 1))
        if count > 1
        else set()
    )
    other = Clusters.from_starts([0, *sorted(cuts)], len(rows))
    assert scattered(rows, clustered(rows, "count", "l2", n_clusters=count)) <= scattered(rows, other) + 1e-4


def scattered(rows, clusters):
    groups = [rows[clusters.members(number)] for number in range(len(clusters))]
    return sum(float(((one - one.mean(axis=0)) ** 2).sum()) for one in groups)


def test_a_leaders_cluster_ends_where_an_image_no_longer_resembles_its_first():
    # cos 40° is 0.77: each step is small, but the third image is too far from where the cluster began.
    assert labels(directions(0, 20, 41, 60, 90), "leader", "cosine", threshold=0.766) == [0, 0, 1, 1, 2]


def test_a_chain_goes_on_as_long_as_steps_are_small():
    assert labels(directions(0, 20, 41, 60, 101), "chain", "cosine", threshold=0.766) == [0, 0, 0, 0, 1]


def test_the_threshold_itself_is_close_enough():
    for kind in ("leader", "chain", "focus"):
        assert labels(line(0, 3), kind, threshold=3) == [0, 0]
        assert labels(line(0, 3), kind, threshold=2.9) == [0, 1]


def test_a_focus_draws_images_from_everywhere():
    assert labels(line(0, 9, 2, 8, 5, 3), "focus", threshold=3) == [0, 1, 0, 1, 2, 0]
    assert labels(line(0, 9, 2, 8, 5, 3), "leader", threshold=3) == [0, 1, 2, 3, 3, 4]


def test_l1_and_l2_differ_where_descriptors_differ_in_more_than_one_number():
    rows = np.array([[0, 0], [3, 4]], np.float32)
    assert labels(rows, "leader", "l1", threshold=6) == [0, 1]
    assert labels(rows, "leader", "l2", threshold=6) == [0, 0]


def test_a_passer_by_is_no_cluster_of_its_own():
    """Between the third and the fourth image is the greatest step, and one back; the scene changes at the sixth."""
    walk = line(0, 0, 1, 6, 1, 1, 9, 9, 10, 9)
    assert labels(walk, "count", "l2", n_clusters=2) == [0] * 6 + [1] * 4


def test_count_minds_sizes_from_the_start():
    assert labels(line(0, 9, 9, 9, 9, 9), "count", "l2", n_clusters=2, min_size=2) == [0, 0, 1, 1, 1, 1]
    assert labels(line(0, 9, 9, 9, 9, 9), "count", "l2", n_clusters=2, max_size=4) == [0, 0, 1, 1, 1, 1]


@pytest.mark.parametrize("distance", ["cosine", "l1", "l2"])
def test_a_sequence_longer_than_a_piece_is_cut_into_exactly_as_many(distance, monkeypatch):
    monkeypatch.setattr("vpr_baselines.clustering.count._PIECE", 7)
    rows = np.random.default_rng(0).random((40, 3), dtype=np.float32)
    for count in (1, 2, 5, 13, 40):
        clusters = clustered(rows, "count", distance, n_clusters=count)
        assert len(clusters) == count and clusters.contiguous
    assert set(clustered(rows, "count", distance, n_clusters=10, min_size=4, max_size=4).sizes.tolist()) == {4}


def test_kmeans_finds_a_place_that_comes_back_and_repeats_itself():
    rows = line(0, 1, 50, 51, 0, 1)
    assert labels(rows, "kmeans", "l2", n_clusters=2) == [0, 0, 1, 1, 0, 0]
    many = np.random.default_rng(1).random((60, 4), dtype=np.float32)
    assert labels(many, "kmeans", "l2", n_clusters=7, seed=3) == labels(many, "kmeans", "l2", n_clusters=7, seed=3)


def test_kmeans_of_images_that_do_not_differ_is_refused():
    with pytest.raises(ValueError, match="K-means finds 1 clusters, not 3"):
        clustered(line(4, 4, 4, 4), "kmeans", "l2", n_clusters=3)


def test_given_labels_are_numbered_by_first_appearance():
    assert labels(line(1, 2, 3, 4), "labels", labels=(9, 4, 9, 7)) == [0, 1, 0, 2]


def test_identical_images_are_one_cluster_or_as_many_as_asked_for():
    rows = line(*[5] * 6)
    assert labels(rows, "leader", threshold=0) == [0] * 6
    assert len(clustered(rows, "count", n_clusters=4)) == 4


@pytest.mark.parametrize("kind", ["leader", "chain", "focus"])
def test_descriptors_of_nothing_resemble_nothing(kind):
    assert labels(np.zeros((4, 3), np.float32), kind, "cosine", threshold=0.5) == [0, 1, 2, 3]


def test_one_reference_is_one_cluster():
    assert labels(line(3), "count", n_clusters=1) == labels(line(3), "chain", threshold=1) == [0]


def test_cohesion_is_one_where_all_are_alike_and_less_where_they_differ():
    rows = directions(10, 10, 0, 90, 0)
    found = cohesion(rows, Clusters([0, 0, 1, 1, 2]))
    assert found.tolist() == pytest.approx([1, np.sqrt(0.5), 1], abs=1e-6)
    assert cohesion(np.zeros((2, 3), np.float32), Clusters([0, 0])).tolist() == [0]


@pytest.mark.parametrize(
    ("rows", "kind", "given", "message"),
    [
        (line(), "count", {"n_clusters": 1}, "no references"),
        (line(1, 2), "count", {"n_clusters": 3}, "2 references cannot be cut into 3 clusters"),
        (line(1, 2, 3), "count", {"n_clusters": 2, "min_size": 2}, "cut into 2 clusters of 2 to any number"),
        (line(1, 2, 3), "leader", {"threshold": 1, "min_size": 4}, "divided into clusters of at least 4"),
        (line(1, 2, 3, 4, 5), "chain", {"threshold": 1, "min_size": 3, "max_size": 4}, "clusters of 3 to 4"),
        (line(1, 2), "labels", {"labels": (0,)}, "one per reference, 2. Got 1"),
        (line(1, 2), "kmeans", {"n_clusters": 3, "distance": "l2"}, "2 references cannot be put into 3"),
        (line(1, np.nan), "chain", {"threshold": 1}, "must be finite"),
        (np.zeros(3, np.float32), "chain", {"threshold": 1}, "one row per reference"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(rows, kind, given, message):
    with pytest.raises(ValueError, match=message) as refused:
        clustered(rows.reshape(-1, 1) if rows.size == 0 else rows, kind, given.pop("distance", "l1"), **given)
    assert "\n" not in str(refused.value)
