import numpy as np
import pytest

from vpr_bench.errors import UsageError
from vpr_bench.metrics.answers import NEVER, Answers, without_soft
from vpr_bench.metrics.definitions import compute
from vpr_bench.types.ground_truth import GroundTruth

# Five queries in a map of six: right at once, right at the third place, wrong, no true match, no answer.
TRUTH = GroundTruth.from_lists([[0], [2, 3], [4], [], [5]], n_references=6)
INDICES = np.array([[0, 1, 2], [0, 1, 3], [0, 1, -1], [5, 4, 3], [-1, -1, -1]])
SCORES = np.array(
    [[0.9, 0.8, 0.1], [0.7, 0.6, 0.5], [0.6, 0.5, -np.inf], [0.2, 0.1, 0.0], [-np.inf] * 3], dtype=np.float32
)


def test_from_matches_judges_the_best_match_and_finds_the_first_right_one():
    answers = Answers.from_matches(INDICES, SCORES, TRUTH, "miss")
    assert answers.correct.tolist() == [True, False, False, False, False]
    assert answers.rank.tolist() == [0, 2, NEVER, NEVER, NEVER]
    assert answers.has_match.tolist() == [True, True, True, False, True]
    assert answers.answered.tolist() == [True, True, True, True, False]
    assert np.array_equal(answers.score, np.array([0.9, 0.7, 0.6, 0.2, -np.inf], np.float32).astype(float))


def test_excluded_queries_leave_no_trace():
    excluded = Answers.from_matches(INDICES, SCORES, TRUTH, "exclude")
    rows = [0, 1, 2, 4]
    truth = GroundTruth.from_lists([TRUTH[row].tolist() for row in rows], n_references=6)
    never_there = Answers.from_matches(INDICES[rows], SCORES[rows], truth, "exclude")
    assert len(excluded) == 4 and excluded.has_match.all()
    for column in ("correct", "score", "rank"):
        assert np.array_equal(getattr(excluded, column), getattr(never_there, column))


def test_the_policies_by_hand(make):
    # By falling score: right, unmatched, right, wrong; and an unmatched query that is left unanswered.
    correct, score = [True, False, True, False, False], [0.9, 0.8, 0.7, 0.6, -np.inf]
    has_match = [True, False, True, True, False]
    names = ["pr_auc", "pr_auc_matched", "roc_auc", "recall@1", "recall@100p", "accuracy"]

    def values(unmatched):
        keep = np.array(has_match) | (unmatched != "exclude")
        rows = [np.array(column)[keep] for column in (correct, score, has_match)]
        return [round(v, 6) for v in compute(names, make(*rows, unmatched=unmatched)).values()]

    # Precision 1, 1, 2/3. Recall over 3: the area is that of true positives, 2 * 1, over 3.
    assert values("exclude") == [0.666667, 1.0, 1.0, 0.666667, 0.666667, 0.666667]
    # Precision 1, 1/2, 2/3, 2/4 at 1, 1, 2, 2 true positives: area 1 + (1/2 + 2/3) / 2 = 19/12.
    # ROC: 2 right against 3 not right; one of the 6 comparisons is lost.
    # Recall is over all 5, so that 2/5 are found; 1/5 before the first wrong answer.
    assert values("miss") == [0.316667, 0.791667, 0.833333, 0.4, 0.2, 0.4]
    # The same curve, but recall is over 3; the unanswered query ends well.
    assert values("reject") == [0.527778, 0.791667, 0.833333, 0.666667, 0.333333, 0.6]


def test_the_policies_agree_where_every_query_has_a_match():
    rows = [0, 1, 2, 4]
    truth = GroundTruth.from_lists([TRUTH[row].tolist() for row in rows], n_references=6)
    names = [
        "pr_auc",
        "pr_auc_matched",
        "roc_auc",
        "recall@1",
        "recall@100p",
        "accuracy",
        "average_precision",
    ]
    first, *others = (
        compute(names, Answers.from_matches(INDICES[rows], SCORES[rows], truth, policy))
        for policy in ("exclude", "miss", "reject")
    )
    assert others == [first, first]


@pytest.mark.parametrize("width", [1, 3])
def test_answers_that_were_cut_off_limit_the_depth(width):
    full = INDICES[:, :width]
    assert Answers.from_matches(full, SCORES[:, :width], TRUTH).depth == width


def test_answers_that_end_by_themselves_do_not_limit_the_depth():
    ended = np.where(np.arange(3) < 2, INDICES, -1)
    assert Answers.from_matches(ended, SCORES, TRUTH).depth == NEVER
    complete = np.tile(np.arange(6), (5, 1))
    assert Answers.from_matches(complete, np.zeros((5, 6)), TRUTH).depth == NEVER


def test_a_row_taken_twice_counts_twice(make):
    answers = make([True, False], [0.5, 0.4])
    assert compute(["recall@1"], answers.take(np.array([0, 0, 1])))["recall@1"] == pytest.approx(2 / 3)


@pytest.mark.parametrize(
    ("indices", "scores", "message"),
    [
        (INDICES[:4], SCORES[:4], r"\(5, k\)"),
        (INDICES, SCORES[:, :2], r"\(5, k\)"),
        (INDICES[:, :0], SCORES[:, :0], r"\(5, k\)"),
        (np.full((5, 1), 6), np.zeros((5, 1)), r"\[0, 6\)"),
        (np.full((5, 1), -2), np.zeros((5, 1)), r"\[0, 6\)"),
        (np.zeros((5, 1), int), np.full((5, 1), np.nan), "NaN"),
    ],
)
def test_matches_that_do_not_fit_are_refused(indices, scores, message):
    with pytest.raises(ValueError, match=message):
        Answers.from_matches(indices, scores, TRUTH)


def test_columns_that_do_not_fit_are_refused():
    column = np.ones(2, dtype=bool)
    with pytest.raises(ValueError, match=r"shape \(n,\)"):
        Answers(column, np.zeros(3), column, np.zeros(2, int))
    with pytest.raises(ValueError, match="weight must have shape"):
        Answers(column, np.zeros(2), column, np.zeros(2, int), weight=np.ones((4, 3)))


def test_an_unknown_policy_is_refused_with_the_closest_one():
    with pytest.raises(UsageError, match="'reject'"):
        Answers.from_matches(INDICES, SCORES, TRUTH, "rejected")


def test_soft_matches_are_passed_over():
    truth = GroundTruth.from_lists([[0], [3], []], 5).with_soft(GroundTruth.from_lists([[1], [0, 2], [4]], 5))
    indices = np.array([[1, 0, 2], [2, 0, 3], [4, 1, 0]])
    scores = np.array([[0.9, 0.8, 0.7], [0.6, 0.5, 0.4], [0.3, 0.2, 0.1]])
    answers = Answers.from_matches(indices, scores, truth, unmatched="miss")
    assert answers.correct.tolist() == [True, True, False]
    assert answers.score.tolist() == [0.8, 0.4, 0.2]
    assert answers.rank.tolist() == [0, 0, NEVER]
    assert answers.depth == 1  # of the second query only one answer counts


def test_without_soft_matches_the_others_move_up():
    truth = GroundTruth.from_lists([[0], [3]], 5).with_soft(GroundTruth.from_lists([[1], []], 5))
    indices, scores = np.array([[1, 0, 2], [3, 1, -1]]), np.array([[0.9, 0.8, 0.7], [0.6, 0.5, -np.inf]])
    found = without_soft(indices, scores, truth)
    assert found[0].tolist() == [[0, 2, -1], [3, 1, -1]]
    assert found[1].tolist() == [[0.8, 0.7, -np.inf], [0.6, 0.5, -np.inf]]


def test_answers_that_are_all_soft_are_refused_where_more_could_have_been_asked_for():
    truth = GroundTruth.from_lists([[0]], 3).with_soft(GroundTruth.from_lists([[1, 2]], 3))
    with pytest.raises(UsageError, match=r"All 2 answers to a query are soft matches.*Raise --k"):
        Answers.from_matches(np.array([[1, 2]]), np.array([[0.9, 0.8]]), truth)
    answers = Answers.from_matches(np.array([[1, 2, -1]]), np.array([[0.9, 0.8, -np.inf]]), truth)
    assert not answers.answered.any() and not answers.correct.any()
