from contextlib import contextmanager

import pytest

from vpr_bench.progress import listen, task, track


class Bars:
    """A listener that keeps what it is told."""

    def __init__(self):
        self.opened, self.steps, self.closed = [], [], 0

    @contextmanager
    def __call__(self, description, total):
        self.opened.append((description, total))
        try:
            yield self.steps.append
        finally:
            self.closed += 1


def test_a_loop_reports_its_length_and_every_step():
    bars = Bars()
    with listen(bars):
        assert list(track("abc", "Spelling")) == ["a", "b", "c"]
    assert bars.opened == [("Spelling", 3)]
    assert bars.steps == [1, 1, 1] and bars.closed == 1


def test_the_length_of_a_generator_is_unknown_unless_it_is_told():
    bars = Bars()
    with listen(bars):
        list(track(iter("abc"), "Unknown"))
        list(track(iter("abc"), "Told", total=3))
    assert bars.opened == [("Unknown", None), ("Told", 3)]


def test_a_task_reports_the_steps_it_is_given():
    bars = Bars()
    with listen(bars), task("Downloading", total=100) as advance:
        advance(60)
        advance(40)
    assert bars.opened == [("Downloading", 100)] and bars.steps == [60, 40]


def test_the_bar_is_closed_when_the_work_fails():
    bars = Bars()
    with pytest.raises(RuntimeError), listen(bars), task("Failing"):
        raise RuntimeError
    assert bars.closed == 1


def test_nobody_is_told_outside_the_block():
    bars = Bars()
    with listen(bars):
        pass
    assert list(track([1], "Quiet")) == [1]
    assert bars.opened == []


def test_the_inner_listener_is_told_and_then_the_outer_one_again():
    outer, inner = Bars(), Bars()
    with listen(outer):
        with listen(inner):
            list(track([1], "Inner"))
        list(track([1], "Outer"))
    assert inner.opened == [("Inner", 1)] and outer.opened == [("Outer", 1)]


def test_nothing_to_do_opens_no_bar():
    bars = Bars()
    with listen(bars):
        assert list(track([], "Nothing")) == []
    assert not bars.opened
