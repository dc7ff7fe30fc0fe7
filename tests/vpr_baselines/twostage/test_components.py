import numpy as np
import pytest

from vpr_baselines.twostage.components import Answers, Components
from vpr_baselines.twostage.heads import LinearHead
from vpr_bench.types.clusters import Clusters

SCATTERED = Clusters([0, 1, 0, 0, 1, 2])
ROWS = [0, 2, 3, 1, 4, 5]  # the references in the order of the clusters


@pytest.fixture
def components():
    """Every reference answers to a direction of its own."""
    return Components(SCATTERED, LinearHead(np.eye(6, dtype=np.float32)[ROWS], np.zeros(6, np.float32)))


QUERY = np.array([0.1, 0.9, 0.5, 0.2, 1.0, 0.3], np.float32)


def test_rows_stand_cluster_by_cluster(components):
    assert components.references.tolist() == ROWS
    assert components.bounds.tolist() == [0, 3, 5, 6]
    assert [components.members(one).tolist() for one in range(3)] == [[0, 2, 3], [1, 4], [5]]


def test_each_triggered_component_names_its_best(components):
    answers = components.answers(QUERY, np.array([1, 0]), best=2)
    assert answers.references.tolist() == [4, 1, 2, 3]
    assert answers.components.tolist() == [1, 1, 0, 0]
    assert answers.logits == pytest.approx([1.0, 0.9, 0.5, 0.2])
    assert answers.references.dtype == answers.components.dtype == np.int64


def test_probabilities_are_within_the_whole_cluster(components):
    answers = components.answers(QUERY, np.array([0]), best=2)
    exponentials = np.exp(QUERY[[2, 3, 0]])
    assert answers.probabilities == pytest.approx((exponentials / exponentials.sum())[:2])
    assert components.answers(QUERY, np.array([2]), best=9).probabilities.tolist() == [1.0]


def test_large_logits_have_probabilities_too(components):
    loud = Components(SCATTERED, LinearHead(components.head.weight * 1e4, components.head.bias))
    assert loud.answers(QUERY, np.array([0]), best=3).probabilities == pytest.approx([1, 0, 0])


def test_the_bias_belongs_to_the_reference(components):
    biased = Components(SCATTERED, LinearHead(components.head.weight, np.arange(6, dtype=np.float32)))
    answers = biased.answers(np.zeros(6, np.float32), np.array([0, 1]), best=2)
    assert answers.references.tolist() == [3, 2, 4, 1]


def test_a_small_cluster_gives_all_it_has_and_equals_come_in_their_order(components):
    answers = components.answers(np.zeros(6, np.float32), np.array([2, 0]), best=99)
    assert answers.references.tolist() == [5, 0, 2, 3]


def test_nothing_triggered_names_nothing(components):
    answers = components.answers(QUERY, np.empty(0, np.int64), best=3)
    assert [len(part) for part in vars(answers).values()] == [0, 0, 0, 0]
    assert answers.references.dtype == np.int64


def test_only_triggered_rows_are_read_and_half_precision_will_do(components, tmp_path):
    half = np.lib.format.open_memmap(tmp_path / "half.npy", "w+", np.float16, (6, 6))
    half[:] = components.head.weight
    half[3:] = np.nan
    mapped = Components(SCATTERED, LinearHead(half, components.head.bias))
    answers = mapped.answers(QUERY, np.array([0]), best=3)
    assert answers.references.tolist() == [2, 3, 0] and answers.logits.dtype == np.float32
    assert mapped.part(0).weight.dtype == np.float32


def test_answers_are_joined_in_order():
    one = Answers.best(4, np.array([7, 9]), np.array([0.0, 1.0], np.float32), 1)
    two = Answers.best(2, np.array([3]), np.array([5.0], np.float32), 3)
    joined = Answers.join([one, two])
    assert joined.references.tolist() == [9, 3] and joined.components.tolist() == [4, 2]
