import xml.etree.ElementTree as ET
from dataclasses import replace

import pytest

from vpr_bench.gate.junit import to_junit
from vpr_bench.gate.verdict import Judgement, Verdict


def parsed(judgement):
    return ET.fromstring(to_junit(judgement).encode())  # noqa: S314 - it is our own


def test_one_test_case_per_cell(failing):
    root = parsed(failing)
    suite = root.find("testsuite")
    assert {name: suite.get(name) for name in ("tests", "failures", "errors", "skipped")} == {
        "tests": "4",
        "failures": "2",
        "errors": "0",
        "skipped": "1",
    }
    assert float(suite.get("time")) > 0
    cases = {case.get("name"): case for case in suite}
    assert cases["fails"].get("classname") == "gardens/day_left-day_right@0f"
    assert "recall@1 fell" in cases["fails"].find("failure").get("message")
    assert "day_right/Image000.jpg" in cases["fails"].find("failure").text
    assert cases["absent"].find("failure").get("type") == "missing"
    assert cases["fresh"].find("skipped") is not None
    assert [child.tag for child in cases["passes"]] == ["properties"]
    facts = {one.get("name"): one.get("value") for one in cases["fails"].iter("property")}
    assert float(facts["recall@1"]) < float(facts["recall@1 in the baseline"])


def test_an_error_is_an_error():
    root = parsed(Judgement([Verdict("a stored run", "", "error", reasons=["damaged"])]))
    assert root.get("errors") == "1"
    assert root.find(".//error").get("message") == "damaged"


def test_whatever_names_hold_it_can_be_read(failing, hostile):
    verdicts = [replace(one, label=hostile, reasons=[hostile], notes=[hostile]) for one in failing.verdicts]
    root = parsed(replace(failing, verdicts=verdicts))
    assert {case.get("name") for case in root.iter("testcase")} == {
        "<script>alert(1)</script>|`*_[x](y)[31m\n# big&amp;\"'"
    }


@pytest.mark.parametrize("verdicts", [[], [Verdict("a", "b", "new")]])
def test_nothing_to_judge_is_a_failure(verdicts):
    root = parsed(Judgement(verdicts))
    assert root.get("failures") == "1"
    assert root.find(".//failure").get("message") == "no cell of the baseline was judged"
