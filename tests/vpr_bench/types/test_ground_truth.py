import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from vpr_bench.errors import UsageError
from vpr_bench.types.ground_truth import GroundTruth


def dense(truth):
    """The ground truth as a (n_queries, n_references) bool table."""
    table = np.zeros((truth.n_queries, truth.n_references), dtype=bool)
    table[truth.query_of_pair, truth.references] = True
    return table


labels = st.one_of(st.integers(-20, 20).map(float), st.floats(-1e6, 1e6))
radii = st.one_of(st.integers(0, 10).map(float), st.floats(0, 1e6))


@settings(deadline=None)
@given(st.lists(labels, max_size=15), st.lists(labels, max_size=15), radii)
def test_radius_on_numbers_is_the_definition(queries, references, radius):
    truth = GroundTruth.from_radius(queries, references, radius)
    near = np.abs(np.subtract.outer(np.array(queries), np.array(references))) <= radius
    assert np.array_equal(dense(truth), near.reshape(len(queries), len(references)))


def test_radius_survives_rounding():
    # |1 - -1e-17| rounds to 1, so it is within the radius although 1 - 1 = 0 lies above the reference.
    assert GroundTruth.from_radius([1.0], [-1e-17], radius=1)[0].tolist() == [0]
    # 0.1 + 0.2 is a little more than 0.3, and the definition is what the subtraction says.
    for query, reference in ((0.3, 0.1), (0.1, 0.3), (0.7, 0.5)):
        near = abs(query - reference) <= 0.2
        assert bool(GroundTruth.from_radius([query], [reference], radius=0.2).has_match[0]) == near


positions = st.lists(st.tuples(labels, labels), min_size=1, max_size=15).map(np.array)


@settings(deadline=None)
@given(positions, positions, radii)
def test_radius_on_positions_is_the_definition(queries, references, radius):
    truth = GroundTruth.from_radius(queries, references, radius)
    distance = np.sqrt(((queries[:, None] - references[None]) ** 2).sum(axis=2))
    assert np.array_equal(dense(truth), distance <= radius)


def test_positions_at_the_scale_of_map_coordinates():
    # A grid of metres far from the origin, where 25 m is hit exactly by (7, 24) and (15, 20).
    offsets = np.array([[7, 24], [15, 20], [25, 0], [25, 1]])
    corner = np.array([[552_000.0, 4_183_000.0]])
    assert GroundTruth.from_radius(corner, corner + offsets, radius=25)[0].tolist() == [0, 1, 2]


@pytest.mark.parametrize("shape", [(0,), (0, 2)])
def test_nothing_to_compare(shape):
    some = np.zeros((3, *shape[1:]))
    assert GroundTruth.from_radius(np.zeros(shape), some, 1).n_queries == 0
    assert not GroundTruth.from_radius(some, np.zeros(shape), 1).has_match.any()


@pytest.mark.parametrize("radius", [-1, float("nan"), float("inf")])
def test_impossible_radius_is_refused(radius):
    with pytest.raises(UsageError, match="at least 0"):
        GroundTruth.from_radius([1], [1], radius)


@pytest.mark.parametrize(
    ("queries", "references", "message"),
    [
        ([np.nan], [1.0], "finite"),
        ([[1.0, 2.0]], [1.0], "columns"),
        (np.zeros((1, 1, 1)), [1.0], "shape"),
    ],
)
def test_unusable_labels_are_refused(queries, references, message):
    with pytest.raises(ValueError, match=message):
        GroundTruth.from_radius(queries, references, 1)


pairs = st.lists(st.tuples(st.integers(0, 5), st.integers(0, 7)), max_size=30)


@settings(deadline=None)
@given(pairs)
def test_pairs_and_transpose(found):
    queries, references = [q for q, _ in found], [r for _, r in found]
    truth = GroundTruth.from_pairs(queries, references, n_queries=6, n_references=8)
    assert set(zip(truth.query_of_pair.tolist(), truth.references.tolist(), strict=True)) == set(found)
    assert np.array_equal(dense(truth.transpose()), dense(truth).T)
    assert truth.transpose().transpose() == truth


@settings(deadline=None)
@given(pairs)
def test_contains_is_a_table_look_up(found):
    truth = GroundTruth.from_pairs([q for q, _ in found], [r for _, r in found], n_queries=6, n_references=8)
    asked = np.arange(-1, 9)  # one below and one above the map: never right
    expected = np.pad(dense(truth), ((0, 0), (1, 1)))
    assert np.array_equal(truth.contains(np.arange(6)[:, None], asked[None]), expected)


def test_lists():
    truth = GroundTruth.from_lists([[2, 0, 2], [], [1]], n_references=3)
    assert [row.tolist() for row in (truth[0], truth[1], truth[2])] == [[0, 2], [], [1]]
    assert truth.has_match.tolist() == [True, False, True]
    assert truth == GroundTruth.from_lists([[0, 2], [], [1]], 3, queries_of_reference=[[0], [2], [0]])
    assert truth != GroundTruth.from_lists([[0, 2], [], [1]], n_references=4)
    assert truth != "something else"


def test_lists_that_contradict_each_other_are_refused():
    with pytest.raises(ValueError, match="not symmetric"):
        GroundTruth.from_lists([[0], []], 2, queries_of_reference=[[0], [1]])


@pytest.mark.parametrize("reference", [-1, 3])
def test_references_outside_the_map_are_refused(reference):
    with pytest.raises(ValueError, match=r"must lie in \[0, 3\)"):
        GroundTruth.from_lists([[0, reference]], n_references=3)


def test_queries_outside_the_traverse_are_refused():
    with pytest.raises(ValueError, match=r"query indices must lie in \[0, 2\)"):
        GroundTruth.from_pairs([2], [0], n_queries=2, n_references=1)
    truth = GroundTruth.from_lists([[0], [0]], n_references=1)
    for query in (-1, 2):
        with pytest.raises(IndexError, match="0 to 1"):
            truth[query]
    assert len(list(truth)) == 2


def test_pairs_without_a_partner_are_refused():
    with pytest.raises(ValueError, match="a query and a reference"):
        GroundTruth.from_pairs([0], [0, 1, 2], n_queries=1, n_references=3)


@pytest.mark.parametrize(
    ("offsets", "references", "message"),
    [
        ([0, 1], [0, 1], "from 0 to 2"),
        ([1, 2], [0, 1], "from 0 to 2"),
        ([0, 2, 1, 2], [0, 1], "must not decrease"),
        ([0, 1], [5], "must lie in"),
        ([0, 2], [1, 0], "ascending and unique"),
        ([0, 2], [1, 1], "ascending and unique"),
    ],
)
def test_broken_structure_is_refused(offsets, references, message):
    with pytest.raises(ValueError, match=message):
        GroundTruth(np.array(offsets), np.array(references), n_references=3)


matrices = st.tuples(st.integers(1, 6), st.integers(1, 6)).flatmap(
    lambda shape: st.tuples(arrays(np.bool_, shape), arrays(np.bool_, shape))
)


@given(matrices)
def test_soft_matches_are_those_that_are_not_right_already(matrix):
    hard, soft = matrix
    n, m = hard.shape
    truth = GroundTruth.from_pairs(*hard.nonzero(), n, m).with_soft(GroundTruth.from_pairs(*soft.nonzero(), n, m))
    rows, columns = np.indices(hard.shape)
    assert np.array_equal(truth.contains(rows, columns), hard)
    assert np.array_equal(truth.soft.contains(rows, columns), soft & ~hard)
    assert truth.transpose().transpose() == truth
    assert truth.take(range(n)) == truth


def test_a_pair_is_not_right_and_soft_at_once():
    one = GroundTruth.from_lists([[0]], 2)
    with pytest.raises(ValueError, match="right and soft"):
        GroundTruth(one.offsets, one.references, 2, soft=one)
    with pytest.raises(ValueError, match="relate 2 queries to 2 references, the others 1 to 2"):
        GroundTruth(one.offsets, one.references, 2, soft=GroundTruth.from_lists([[0], []], 2))


def test_queries_are_taken_in_any_order_and_more_than_once():
    truth = GroundTruth.from_lists([[0, 1], [], [2]], 3)
    taken = truth.take([2, 0, 0, 1])
    assert [taken[query].tolist() for query in range(4)] == [[2], [0, 1], [0, 1], []]
