import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import UsageError
from vpr_bench.metrics.definitions import METRICS, compute, evaluate, lookup
from vpr_bench.types.ground_truth import GroundTruth

NAMES = [*METRICS, "recall@2"]


def same(first, second):
    return all(first[name] == pytest.approx(second[name], nan_ok=True) for name in first)


@given(data=st.data())
def test_every_value_lies_between_0_and_1_or_is_undefined(data, any_answers):
    answers = data.draw(any_answers())
    for value in compute(NAMES, answers).values():
        assert math.isnan(value) or -1e-12 <= value <= 1 + 1e-12


@given(data=st.data())
def test_a_strictly_monotone_rescaling_changes_nothing(data, any_answers):
    answers = data.draw(any_answers())
    # Nine distinct scores, -4 to 4, become nine others in the same order.
    steps = data.draw(st.lists(st.floats(0.01, 1e3), min_size=9, max_size=9))
    levels = np.concatenate([np.cumsum(steps) - data.draw(st.floats(-1e4, 1e4)), [-np.inf]])
    position = np.where(answers.answered, answers.score + 4, 9).astype(int)
    rescaled = dataclasses.replace(answers, score=levels[position])
    assert compute(NAMES, rescaled) == pytest.approx(compute(NAMES, answers), nan_ok=True)


@given(data=st.data())
def test_the_order_of_the_queries_does_not_matter(data, any_answers):
    answers = data.draw(any_answers())
    order = np.array(data.draw(st.permutations(range(len(answers)))), dtype=int)
    assert same(compute(NAMES, answers.take(order)), compute(NAMES, answers))


@given(data=st.data())
def test_every_query_twice_changes_nothing(data, any_answers):
    answers = data.draw(any_answers())
    twice = answers.take(np.repeat(np.arange(len(answers)), 2))
    assert same(compute(NAMES, twice), compute(NAMES, answers))


def test_every_metric_is_named_as_it_is_listed_and_defined_in_one_line():
    for name, metric in METRICS.items():
        assert metric.id == name and lookup(name) is metric
        assert metric.definition and "\n" not in metric.definition


def test_recall_at_any_depth(make):
    answers = make([1, 0], [2, 1], rank=[0, 19])
    assert compute(["recall@19", "recall@20"], answers) == {"recall@19": 0.5, "recall@20": 1.0}


@pytest.mark.parametrize("name", ["recall@0", "recall@05", "recall@", "recall@-1", "recall@1.5", "Recall@1x"])
def test_recall_at_an_impossible_depth_is_refused(name):
    with pytest.raises(UsageError, match="There is no metric"):
        lookup(name)


def test_an_unknown_metric_is_refused_with_the_closest_one(make):
    with pytest.raises(UsageError, match=r"no metric 'pr_auk'\. Did you mean 'pr_auc'"):
        compute(["recall@1", "pr_auk"], make([1], [1]))


def test_evaluate_adds_the_pairs_where_all_are_ranked():
    truth = GroundTruth.from_lists([[0], [1]], n_references=2)
    indices, scores = np.array([[0, 1], [0, 1]]), np.array([[0.9, 0.1], [0.8, 0.7]], dtype=np.float32)
    values = evaluate(["recall@1", "pr_auc_pairs"], indices, scores, truth)
    # By falling score the pairs are true, false, true, false: (0, 1), (.5, 1), (.5, .5), (1, .67).
    assert values == {"recall@1": 0.5, "pr_auc_pairs": pytest.approx(0.5 + (1 / 2 + 2 / 3) / 2 / 2)}
    partial = evaluate(["recall@1", "pr_auc_pairs"], indices[:, :1], scores[:, :1], truth)
    assert partial == pytest.approx({"recall@1": 0.5, "pr_auc_pairs": np.nan}, nan_ok=True)
