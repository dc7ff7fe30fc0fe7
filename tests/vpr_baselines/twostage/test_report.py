import numpy as np
import pytest
from pydantic import ValidationError

from vpr_baselines.twostage.report import PartReport, TrainingReport, accuracy_and_precision


def part(test=10, accuracy=0.5, **changes):
    fields = {"classes": 3, "training": 80, "validation": 10, "rounds": 4, "stopped": "converged"}
    return PartReport(**{**fields, "test": test, "accuracy": accuracy, "average_precision": accuracy, **changes})


def test_it_survives_json():
    report = TrainingReport(stage_one=part(), components=(part(), part(0, None)))
    assert TrainingReport.model_validate_json(report.model_dump_json()) == report


def test_components_count_as_often_as_they_were_tested():
    report = TrainingReport(stage_one=part(), components=(part(30, 1.0), part(10, 0.2), part(0, None)))
    assert report.components_accuracy == pytest.approx(0.8)
    assert report.components_average_precision == pytest.approx(0.8)


def test_without_tests_nothing_is_claimed():
    report = TrainingReport(stage_one=part(0, None), components=(part(0, None),))
    assert report.components_accuracy is None and report.components_average_precision is None


@pytest.mark.parametrize(
    "wrong", [{"accuracy": 1.5}, {"accuracy": float("nan")}, {"stopped": "bored"}, {"classes": 0}, {"extra": 1}]
)
def test_what_cannot_be_is_refused(wrong):
    with pytest.raises(ValidationError):
        part(**wrong)


def test_a_perfect_classifier_and_one_that_confuses_two_classes():
    labels = np.array([0, 1, 2, 2])
    assert accuracy_and_precision(np.eye(3, dtype=np.float32)[labels] * 9, labels) == (1.0, 1.0)
    accuracy, precision = accuracy_and_precision(np.eye(3, dtype=np.float32)[[1, 0, 2, 2]] * 9, labels)
    assert accuracy == 0.5 and 1 / 3 < precision < 1


def test_classes_that_do_not_occur_are_left_out():
    assert accuracy_and_precision(np.array([[9, 0, 0]], np.float32), np.array([0])) == (1.0, 1.0)


def test_nothing_is_measured_without_samples():
    assert accuracy_and_precision(np.empty((0, 3), np.float32), np.empty(0, np.int64)) == (None, None)
