import math
from pathlib import Path

import pytest

from vpr_bench.gate.metric_change import MetricChange
from vpr_bench.gate.rules import Rule
from vpr_bench.gate.verdict import Judgement, Verdict


@pytest.mark.parametrize(
    ("outcomes", "code"),
    [
        ([], 1),
        (["new"], 1),
        (["pass", "new"], 0),
        (["pass", "fail"], 1),
        (["missing"], 1),
        (["fail", "error", "missing"], 3),
    ],
)
def test_the_worst_decides_how_a_command_ends(outcomes, code):
    assert Judgement([Verdict("a", "b", outcome) for outcome in outcomes]).exit_code == code


def test_an_error_ends_as_its_fault_deserves():
    assert Judgement([Verdict("a", "b", "error", code=2)]).exit_code == 2


def test_better_is_what_rose_and_passed():
    rose = MetricChange("recall@1", 0.5, 0.6, Rule())
    appeared = MetricChange("roc_auc", math.nan, 0.6, Rule())
    assert Verdict("a", "b", "pass", metrics=[rose]).improved
    assert not Verdict("a", "b", "fail", metrics=[rose]).improved
    assert not Verdict("a", "b", "pass", metrics=[appeared]).improved


def test_what_was_left_out_is_said():
    assert Judgement([Verdict("a", "b", "pass")], left_out=4).summary() == "1 passed, 4 not asked about"
    assert Judgement([], skipped=[Path("a")]).summary() == "1 partial skipped, nothing was judged"


def test_who_records_need_judge_nothing():
    judgement = Judgement([Verdict("a", "b", "new")], recording=True)
    assert (judgement.exit_code, judgement.summary()) == (0, "1 new")


def test_undefined_numbers_are_null_in_json():
    change = MetricChange("roc_auc", math.nan, 0.6, Rule(tolerance=0.1)).as_dict()
    assert (change["before"], change["difference"], change["after"]) == (None, None, 0.6)
