import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.envs.judge import Judge
from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.ranking import accuracy
from vpr_bench.types.ground_truth import GroundTruth

POLICIES = ["exclude", "miss", "reject"]
N_QUERIES, N_REFERENCES = 6, 7


@st.composite
def answered(draw):
    """A ground truth with soft matches, and ranked answers of any length to all queries."""
    pairs = st.sets(st.tuples(st.integers(0, N_QUERIES - 1), st.integers(0, N_REFERENCES - 1)), max_size=20)

    def truth(drawn):
        rows = sorted(drawn)
        return GroundTruth.from_pairs([q for q, _ in rows], [r for _, r in rows], N_QUERIES, N_REFERENCES)

    ground_truth = truth(draw(pairs))
    if draw(st.booleans()):
        ground_truth = ground_truth.with_soft(truth(draw(pairs)))
    rows = [
        draw(st.lists(st.integers(0, N_REFERENCES - 1), unique=True, max_size=N_REFERENCES)) for _ in range(N_QUERIES)
    ]
    indices = np.full((N_QUERIES, N_REFERENCES), -1)
    for row, references in enumerate(rows):
        indices[row, : len(references)] = references
    return ground_truth, indices


@given(answered(), st.sampled_from(POLICIES))
def test_it_agrees_with_the_metrics(case, unmatched):
    ground_truth, indices = case
    scores = np.where(indices >= 0, -np.arange(N_REFERENCES, dtype=np.float32), -np.inf)
    judged = Judge(ground_truth, unmatched)(np.arange(N_QUERIES), indices)
    metrics = Answers.from_matches(indices, scores, ground_truth, unmatched)
    counted = judged.has_match if unmatched == "exclude" else np.ones(N_QUERIES, bool)
    assert np.array_equal(judged.correct[counted], metrics.correct)
    assert np.array_equal(judged.has_match, ground_truth.has_match)
    if counted.any():
        assert judged.reward[counted].mean() == pytest.approx(float(accuracy(metrics)))
    for query in range(N_QUERIES):
        assert judged.truth[query][judged.truth[query] >= 0].tolist() == ground_truth[query].tolist()


def test_queries_come_in_any_order_and_number():
    judge = Judge(GroundTruth.from_radius([0, 5, 9], [0, 1, 5, 6], radius=1), "miss")
    judged = judge(np.array([2, 0]), np.array([[0], [1]]))
    assert judged.correct.tolist() == [False, True]
    assert judged.truth.tolist() == [[-1, -1], [0, 1]]
    assert len(judge(np.empty(0, np.int64), np.empty((0, 1), np.int64)).correct) == 0


def test_a_soft_match_is_passed_over():
    truth = GroundTruth.from_pairs([0], [2], 1, 4).with_soft(GroundTruth.from_pairs([0, 0], [1, 3], 1, 4))
    judge = Judge(truth, "exclude")
    assert judge(np.array([0]), np.array([[1, 3, 2]])).answer.tolist() == [2]
    judged = judge(np.array([0]), np.array([[1, 3, -1]]))
    assert judged.answer.tolist() == [-1] and not judged.correct[0]


@pytest.mark.parametrize(("unmatched", "reward"), [("exclude", 0), ("miss", 0), ("reject", 1)])
def test_answering_nothing_where_nothing_is_right(unmatched, reward):
    judge = Judge(GroundTruth.from_radius([0, 50], [0, 1], radius=1), unmatched)
    assert judge(np.array([1]), np.array([[-1]])).reward.tolist() == [reward]
    assert judge(np.array([1]), np.array([[0]])).reward.tolist() == [0]
    assert judge(np.array([0]), np.array([[-1]])).reward.tolist() == [0]


def test_a_ground_truth_without_any_pair():
    judged = Judge(GroundTruth.from_pairs([], [], 2, 3), "exclude")(np.array([0, 1]), np.array([[0], [1]]))
    assert not judged.correct.any() and judged.truth.tolist() == [[-1], [-1]]
