"""What is drawn of a run is what its metrics say."""

import math

import numpy as np
import pytest

from vpr_bench.metrics.definitions import compute
from vpr_bench.page.curves import POINTS, curves_of
from vpr_bench.report.rows import answers_of
from vpr_bench.types.protocol import Protocol


@pytest.fixture(scope="module")
def run(make_run):
    return make_run("some", wrong=4, seed=5, steps=True)


def test_every_radius_has_its_metrics_and_the_curve_ends_at_recall_at_1(run):
    curves = curves_of(run, run.protocol)
    assert [one.radius for one in curves.at] == [0, 1, 2, 5, 10]
    for one in curves.at:
        expected = compute(["recall@1", "pr_auc"], answers_of(run, run.protocol.with_radius(one.radius)))
        assert (one.recall_at_1, one.pr_auc) == (expected["recall@1"], expected["pr_auc"])
        assert one.recall[-1] == one.recall_at_1
        assert (one.recall[0], one.precision[0]) == (0, 1)
        area = np.trapezoid(one.precision, one.recall)
        assert area == pytest.approx(one.pr_auc)


def test_recall_is_known_as_deep_as_answers_are(run):
    curves = curves_of(run, run.protocol)
    names = [f"recall@{k}" for k in range(1, 6)]
    assert curves.recalls == list(compute(names, answers_of(run)).values())


def test_precision_is_looked_up_at_recalls(run):
    reached = curves_of(run, run.protocol).reached  # 8 of 12 are right, and those have the highest scores
    assert reached[:3] == [1, 1, 1]
    assert math.isnan(reached[3]) and math.isnan(reached[4])


def test_losses_and_what_was_found_add_up(run):
    steps = curves_of(run, run.protocol).steps
    assert [step.name for step in steps] == ["clusters", "ranking"]
    assert sum(step.lost.value for step in steps) + steps[-1].recall.value == pytest.approx(1)


def test_a_protocol_without_a_radius_has_one_curve(make_run):
    run = make_run("some", seed=6)
    assert len(curves_of(run, Protocol.parse("tiny/day_left-day_right@2nearest")).at) == 4
    assert len(curves_of(run, Protocol.parse("tiny/day_left-day_right@pair")).at) == 1


def test_what_the_script_gets_is_rounded_and_no_longer_than_needed(run):
    content = curves_of(run, run.protocol).as_dict()
    recall, precision = content["curves"][1]
    assert len(recall) == len(precision) <= POINTS
    assert all(value == round(value, 4) for value in recall + precision)
