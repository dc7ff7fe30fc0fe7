import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from vpr_bench.errors import UsageError
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.places import Places, nearest
from vpr_bench.types.protocol import Protocol

coordinates = st.integers(-20, 20).map(float)


def labels(columns):
    return st.integers(1, 12).flatmap(lambda n: arrays(np.float64, (n, columns), elements=coordinates))


@given(columns=st.integers(1, 3), data=st.data(), radius=st.sampled_from([0, 0.5, 1, 5, 7.07, 30]))
def test_a_ground_truth_from_labels_and_a_radius_is_the_brute_force_definition(columns, data, radius):
    queries, references = data.draw(labels(columns)), data.draw(labels(columns))
    truth = GroundTruth.from_radius(queries, references, radius)
    for query, place in enumerate(queries):
        expected = [i for i, other in enumerate(references) if np.sqrt(((place - other) ** 2).sum()) <= radius]
        assert truth[query].tolist() == expected


@given(columns=st.integers(1, 2), data=st.data())
def test_the_nearest_are_those_that_no_more_than_count_others_are_nearer_than(columns, data):
    queries, references = data.draw(labels(columns)), data.draw(labels(columns))
    count = data.draw(st.integers(1, len(references)))
    truth = nearest(queries, references, count)
    for query, place in enumerate(queries):
        distances = ((place - references) ** 2).sum(axis=1)
        assert truth[query].tolist() == np.flatnonzero(distances <= np.sort(distances)[count - 1]).tolist()


@pytest.mark.parametrize("count", [0, 4])
def test_there_are_only_as_many_nearest_as_references(count):
    with pytest.raises(UsageError, match="There are 3 references"):
        nearest([0.0], [0.0, 1.0, 2.0], count)


def protocol(unit, radius=0.0):
    return Protocol("tiny", "a", "b", radius, unit)


def test_one_set_of_places_serves_every_unit():
    listed = GroundTruth.from_lists([[2], [0, 1]], 3).with_soft(GroundTruth.from_lists([[1], []], 3))
    places = Places(np.array([0.0, 5.0]), np.array([0.0, 4.0, 9.0]), listed)
    found = {
        unit: places.ground_truth(protocol(unit, radius))
        for unit, radius in (("f", 1.0), ("nearest", 2.0), ("given", 0))
    }
    assert [found["f"][query].tolist() for query in (0, 1)] == [[0], [1]]
    assert [found["nearest"][query].tolist() for query in (0, 1)] == [[0, 1], [1, 2]]
    assert found["given"] is listed


@given(columns=st.integers(1, 3), data=st.data())
def test_the_nearest_of_some_references_is_one_that_no_other_is_nearer_than(columns, data):
    places = Places(data.draw(labels(columns)), data.draw(labels(columns)))
    some = np.unique(data.draw(st.lists(st.integers(0, len(places.references) - 1), min_size=1)))
    away = np.sqrt(((places.references[some] - places.queries[0]) ** 2).sum(axis=1))
    assert places.distances(0, some) == pytest.approx(away)
    assert places.nearest_of(0, some) == some[places.distances(0, some).argmin()]


def test_without_labels_the_first_reference_is_the_nearest():
    assert Places().nearest_of(0, np.array([5, 2])) == 5
    with pytest.raises(UsageError, match="no distance"):
        Places().distances(0, np.array([5, 2]))


def test_a_protocol_that_the_places_cannot_serve_is_refused():
    listed, measured = Places(given=GroundTruth.from_lists([[0]], 1)), Places(np.zeros(1), np.zeros(1))
    for ask in (Places.ground_truth, Places.check):
        with pytest.raises(UsageError, match="lists no ground truth for a-b"):
            ask(measured, protocol("given"))
        with pytest.raises(UsageError, match="has no place labels"):
            ask(listed, protocol("f", 1))
    listed.check(protocol("given"))


@pytest.mark.parametrize(("unit", "radius"), [("f", 9), ("m", 9.5), ("nearest", 3)])
def test_a_reach_over_the_whole_map_is_refused(unit, radius):
    places = Places(np.array([0.0, 5.0]), np.array([0.0, 4.0, 9.0]))
    places.check(protocol(unit, 2))
    with pytest.raises(UsageError, match="reaches over the whole map"):
        places.ground_truth(protocol(unit, radius))


def test_places_are_stored_and_read_whole():
    listed = GroundTruth.from_lists([[2], []], 3).with_soft(GroundTruth.from_lists([[1], [0]], 3))
    for places in (
        Places(np.array([[0.0, 1.0], [5.0, 2.0]]), np.zeros((3, 2)), listed),
        Places(given=GroundTruth.from_lists([[], []], 3)),
        Places(np.zeros(2), np.zeros(3)),
    ):
        again = Places.from_arrays(places.arrays())
        assert again.given == places.given
        for name in ("queries", "references"):
            assert np.array_equal(getattr(again, name), getattr(places, name))


def test_some_queries_are_taken_with_everything_about_them():
    listed = GroundTruth.from_lists([[2], [0], [1]], 3).with_soft(GroundTruth.from_lists([[1], [], [0]], 3))
    taken = Places(np.arange(3.0), np.arange(3.0), listed).take([2, 0])
    assert taken.queries.tolist() == [2.0, 0.0] and taken.references.tolist() == [0.0, 1.0, 2.0]
    assert [taken.given[query].tolist() for query in (0, 1)] == [[1], [2]]
    assert [taken.given.soft[query].tolist() for query in (0, 1)] == [[0], [1]]
