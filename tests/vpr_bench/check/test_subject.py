import re
from dataclasses import dataclass
from functools import partial

import pytest

from vpr_baselines.hog import Hog
from vpr_bench.check import Failed
from vpr_bench.check.method import Subject
from vpr_bench.errors import UsageError


def made_hog():
    return Hog(cell=32)


def test_by_name_with_the_seed():
    subject = Subject.of("random", seed=7)
    assert (subject.id, subject.make().seed) == ("random", 7)
    assert subject.make() is not subject.make()


def test_by_name_or_class_with_parameters():
    for what, called in (("hog", "hog"), (Hog, "Hog")):
        subject = Subject.of((what, {"cell": 32}))
        assert (subject.id, subject.make().cell) == (f"{called}(cell=32)", 32)


def test_a_class_that_no_module_holds():
    @dataclass
    class Local(Hog):
        cell: int = 64

    subject = Subject.of((Local, {"bins": "4"}))
    assert (subject.id, type(subject.make()), subject.make().bins) == ("Local(bins=4)", Local, 4)


@pytest.mark.parametrize(("what", "called"), [(made_hog, "made_hog"), (partial(Hog, cell=32), "partial")])
def test_by_a_function(what, called):
    subject = Subject.of(what)
    assert (subject.id, subject.make().cell, subject.build()) == (called, 32, None)


def test_a_function_must_make_new_methods():
    one = Hog()
    for factory in (lambda: one, lambda: "hog"):
        with pytest.raises(Failed, match="must make a new method"):
            Subject.of(factory).make()


@pytest.mark.parametrize("what", [Hog(), 3, (made_hog, {"cell": 32})], ids=["instance", "number", "with parameters"])
def test_other_things(what):
    with pytest.raises(UsageError, match=re.escape("by its name, its class or a function")):
        Subject.of(what)


def test_what_cannot_be_made_declares_nothing():
    subject = Subject.of(("hog", {"cell": "wide"}))
    assert subject.expected_failures == subject.excused_failures == {}


def test_the_failures_of_a_method_inside_are_excused():
    subject = Subject.of(("seqslam", {"inner": "random"}))
    assert subject.expected_failures == {}
    assert subject.excused_failures == {
        "finds-the-same-image": "answers have nothing to do with what is seen (the method inside)"
    }
