import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from sklearn import metrics as oracle

from vpr_bench.metrics.precision_recall import (
    average_precision,
    pr_auc,
    pr_auc_matched,
    precision_recall_curve,
    recall_at_100_precision,
)
from vpr_bench.metrics.ranking import accuracy, recall_at_k

ALL = (pr_auc, pr_auc_matched, average_precision, recall_at_100_precision)


def test_curve_by_hand(make):
    # Scores 4 (right), 3 (right and wrong tie), 2 (wrong), 1 (right); five queries.
    # TP 1 2 2 3, FP 0 1 2 2.
    answers = make([1, 1, 0, 0, 1], [4, 3, 3, 2, 1])
    recall, precision, thresholds = precision_recall_curve(answers)
    assert thresholds.tolist() == [np.inf, 4, 3, 2, 1]
    assert recall == pytest.approx([0, 1 / 5, 2 / 5, 2 / 5, 3 / 5])
    assert precision == pytest.approx([1, 1, 2 / 3, 2 / 4, 3 / 5])
    # Trapezoids of one true positive each: 1, (1 + 2/3) / 2 and (1/2 + 3/5) / 2: 143/60 in all.
    assert pr_auc(answers) == pytest.approx(143 / 60 / 5)
    assert pr_auc_matched(answers) == pytest.approx(143 / 60 / 3)
    assert average_precision(answers) == pytest.approx((1 + 2 / 3 + 3 / 5) / 3)
    assert recall_at_100_precision(answers) == pytest.approx(1 / 5)


def test_perfect_and_worst(make):
    perfect, worst = make([1, 1, 1], [3, 2, 2]), make([0, 0, 0], [3, 2, 2])
    for metric in ALL:
        assert (metric(perfect), metric(worst)) == (1, 0)


def test_a_wrong_answer_that_ties_with_the_best_takes_the_flawless_recall_away(make):
    assert recall_at_100_precision(make([1, 1, 0], [2, 2, 2])) == 0
    assert recall_at_100_precision(make([1, 1, 0], [2, 2, 1])) == pytest.approx(2 / 3)


def test_undefined_without_a_query_that_has_a_match(make):
    for answers in (make([], []), make([0, 0], [1, 2], has_match=[0, 0], unmatched="reject")):
        assert all(np.isnan(metric(answers)) for metric in ALL)
    assert all(metric(make([0, 0], [1, 2], has_match=[0, 0], unmatched="miss")) == 0 for metric in ALL)


@given(data=st.data())
def test_as_scikit_learn(data, any_answers):
    answers = data.draw(any_answers())
    assume(answers.correct.any())
    score = np.where(answers.answered, answers.score, -99)  # scikit-learn refuses -inf
    precision, recall, _ = oracle.precision_recall_curve(answers.correct, score)
    assert pr_auc_matched(answers) == pytest.approx(oracle.auc(recall, precision))
    assert average_precision(answers) == pytest.approx(oracle.average_precision_score(answers.correct, score))
    found = answers.correct.sum() / answers.expected.sum()
    assert pr_auc(answers) == pytest.approx(oracle.auc(recall * found, precision))
    assert recall_at_100_precision(answers) == pytest.approx((recall * found)[precision == 1].max())


@given(data=st.data())
def test_curve_has_the_points_of_scikit_learn(data, any_answers):
    answers = data.draw(any_answers(all_matched=True))
    assume(answers.correct.any())
    precision, recall, thresholds = oracle.precision_recall_curve(answers.correct, answers.score)
    curve = precision_recall_curve(answers)
    assert curve.precision == pytest.approx(precision[::-1])
    assert curve.recall == pytest.approx(recall[::-1] * answers.correct.mean())
    assert curve.thresholds[1:].tolist() == thresholds[::-1].tolist()


@given(data=st.data())
def test_the_headline_is_the_published_area_times_recall(data, any_answers):
    answers = data.draw(any_answers())
    assume(answers.expected.any())
    assert pr_auc(answers) == pytest.approx(pr_auc_matched(answers) * recall_at_k(answers, 1))
    assert pr_auc(answers) <= pr_auc_matched(answers)


@given(data=st.data())
def test_the_headline_is_the_published_area_times_accuracy_where_all_have_a_match(data, any_answers):
    answers = data.draw(any_answers(all_matched=True))
    assume(len(answers))
    assert pr_auc(answers) == pytest.approx(pr_auc_matched(answers) * accuracy(answers))


@given(data=st.data())
def test_recall_at_100_precision_lies_on_the_curve(data, any_answers):
    answers = data.draw(any_answers())
    assume(answers.expected.any())
    curve = precision_recall_curve(answers)
    assert recall_at_100_precision(answers) == curve.recall[curve.precision == 1].max()
