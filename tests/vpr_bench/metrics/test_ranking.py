import dataclasses

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from sklearn import metrics as oracle

from vpr_bench.metrics.answers import NEVER
from vpr_bench.metrics.ranking import accuracy, recall_at_k, roc_auc


def test_recall_at_k_by_hand(make):
    answers = make([1, 0, 0, 0], [4, 3, 2, 1], has_match=[1, 1, 1, 0], rank=[0, 2, NEVER, NEVER], unmatched="reject")
    assert [recall_at_k(answers, k) for k in (1, 2, 3, 10)] == pytest.approx([1 / 3, 1 / 3, 2 / 3, 2 / 3])
    missed = dataclasses.replace(answers, unmatched="miss")
    assert recall_at_k(missed, 3) == 2 / 4


def test_recall_deeper_than_the_answers_is_unknown(make):
    answers = dataclasses.replace(make([1, 0], [2, 1]), depth=5)
    assert recall_at_k(answers, 5) == 0.5
    assert np.isnan(recall_at_k(answers, 6))


def test_recall_is_undefined_without_a_query_that_has_a_match(make):
    assert np.isnan(recall_at_k(make([], []), 1))


def test_accuracy_by_hand(make):
    # Right; wrong; unmatched and answered; unmatched and left unanswered; unanswered although it has a match.
    columns = [1, 0, 0, 0, 0], [4, 3, 2, -np.inf, -np.inf], [1, 1, 0, 0, 1]
    assert accuracy(make(*columns, unmatched="miss")) == 1 / 5
    assert accuracy(make(*columns, unmatched="reject")) == 2 / 5
    assert np.isnan(accuracy(make([], [])))


@given(data=st.data())
def test_accuracy_is_recall_at_1_unless_queries_are_to_be_rejected(data, any_answers):
    answers = data.draw(any_answers())
    assume(len(answers) and answers.unmatched != "reject")
    assert accuracy(answers) == recall_at_k(answers, 1)


@given(data=st.data())
def test_roc_auc_as_scikit_learn(data, any_answers):
    answers = data.draw(any_answers())
    assume(0 < answers.correct.sum() < len(answers))
    score = np.where(answers.answered, answers.score, -99)  # scikit-learn refuses -inf
    assert roc_auc(answers) == pytest.approx(oracle.roc_auc_score(answers.correct, score))


def test_roc_auc_by_hand(make):
    assert roc_auc(make([1, 1, 0], [3, 2, 1])) == 1
    assert roc_auc(make([1, 1, 0], [1, 2, 3])) == 0
    assert roc_auc(make([1, 0, 0], [2, 2, 1])) == 0.75  # one tie, which counts half, and one win
    for one_class in ([1, 1], [0, 0], []):
        assert np.isnan(roc_auc(make(one_class, range(len(one_class)))))
