from types import SimpleNamespace

import pytest

from vpr_bench.check.examination import Examination
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.check.suite import Suite, check
from vpr_bench.errors import UsageError


@check("first")
def first(subject):
    """Check that it has a floor.

    More about it.
    """
    subject.ran.append("first")
    if "first" in subject.faults:
        raise Failed("it\nhas \x1b[31mno floor")


@check("second", "first")
def second(subject):
    """Check that it has walls."""
    if "second" in subject.faults:
        raise KeyError("wall")


@check("third", "second")
def third(subject):
    """Check that it has a roof."""
    if "third" in subject.faults:
        raise SystemExit(0)


@check("fourth")
def fourth(subject):
    """Check that the chimney smokes."""
    raise Skipped("there is no chimney")


SUITE = Suite((first, second), (third, fourth))


def examine(*faults, only=None, **declared):
    return Examination(SUITE, SimpleNamespace(faults=faults, ran=[], expected_failures=declared), only)


def told(examination):
    return {one.id: (found.result, found.reason) for one in SUITE for found in [examination.outcome(one.id)]}


def test_what_holds_passes_and_what_does_not_apply_is_skipped():
    assert told(examine()) == {
        "first": ("pass", ""),
        "second": ("pass", ""),
        "third": ("pass", ""),
        "fourth": ("skip", "there is no chimney"),
    }


def test_a_failure_has_its_reason_fit_to_print_and_excuses_what_builds_on_it():
    assert told(examine("first", "third")) == {
        "first": ("fail", "it has [31mno floor"),
        "second": ("pass", ""),
        "third": ("skip", "it builds on first, which fails"),
        "fourth": ("skip", "there is no chimney"),
    }


@pytest.mark.parametrize(("faults", "result"), [(["first"], ("expected failure", "it hangs")), ([], ("pass", ""))])
def test_an_excused_failure_may_happen_or_not(faults, result):
    excused = SimpleNamespace(faults=faults, ran=[], excused_failures={"first": "it hangs"})
    found = Examination(SUITE, excused).outcome("first")
    assert (found.result, found.reason) == result


def test_foreign_errors_are_failures_that_say_where():
    found = examine("second").outcome("second")
    assert found.result == "fail"
    assert found.reason.startswith("KeyError: 'wall' (test_examination.py, line ")
    assert isinstance(found.error, KeyError)


def test_who_exits_has_failed():
    assert examine("third").outcome("third").reason == "it exits the process"


def test_a_foundation_that_nobody_asked_for_excuses_nothing():
    found = examine("first", "third", only=["third"]).outcome("third")
    assert (found.result, found.reason) == ("fail", "it exits the process")


def test_each_check_runs_once():
    examination = examine("first", "second")
    told(examination)
    told(examination)
    assert examination.subject.ran == ["first"]


def test_a_declared_failure_is_expected():
    found = examine("second", second="it is a tent").outcome("second")
    assert (found.result, found.reason) == ("expected failure", "it is a tent")


def test_a_declared_failure_that_passes_is_a_failure():
    found = examine(second="it is a tent").outcome("second")
    assert found.result == "fail"
    assert "it is a tent" in found.reason and "take it out of expected_failures" in found.reason


def test_a_declared_failure_that_does_not_apply_is_skipped():
    assert examine(fourth="it is a tent").outcome("fourth").result == "skip"


def test_to_declare_a_check_that_is_none_is_an_error():
    with pytest.raises(UsageError, match=r"'secund', which expected_failures names\. Did you mean 'second'"):
        examine(secund="it is a tent").outcome("first")


def test_checks_are_found_by_their_ids():
    assert [one.id for one in SUITE.chosen(["third", "first"])] == ["first", "third"]
    assert SUITE.foundations("third") == ["first", "second"]
    with pytest.raises(UsageError, match=r"no check 'thrid'\. Did you mean 'third'"):
        SUITE.chosen(["thrid"])


def test_a_check_says_what_must_hold():
    assert SUITE["first"].summary == "it has a floor"


@pytest.mark.parametrize("groups", [((first, first),), ((second, first),)], ids=["twice", "builds on a later one"])
def test_suites_that_make_no_sense(groups):
    with pytest.raises(ValueError, match="is there already, or builds on"):
        Suite(*groups)


def test_an_outcome_as_json():
    facts = examine("first").outcome("first").as_dict()
    assert facts.pop("seconds") >= 0
    assert facts == {"check": "first", "result": "fail", "reason": "it has [31mno floor"}
