import threading

import pytest

from vpr_bench.timing import collect_stages, stage


@pytest.fixture
def clock(monkeypatch):
    """A clock that is moved by hand."""

    class Clock:
        now = 0.0

        def perf_counter(self):
            return self.now

    clock = Clock()
    monkeypatch.setattr("vpr_bench.timing.time", clock)
    return clock


def test_stages_are_timed_apart_and_those_of_one_name_add_up(clock):
    with collect_stages() as seconds:
        for name, took in (("encode", 2.0), ("match", 0.5), ("match", 0.25)):
            with stage(name):
                clock.now += took
        clock.now += 10  # outside every stage
    assert seconds == {"encode": 2.0, "match": 0.75}


def test_a_stage_that_fails_is_timed_all_the_same(clock):
    with collect_stages() as seconds, pytest.raises(RuntimeError), stage("encode"):
        clock.now += 3
        raise RuntimeError
    assert seconds == {"encode": 3.0}


def test_a_stage_outside_is_not_collected():
    with stage("before"), collect_stages() as seconds:
        pass
    with stage("after"):
        pass
    assert seconds == {}


def test_collections_do_not_mix():
    with collect_stages() as outer:
        with collect_stages() as inner, stage("inner"):
            pass
        with stage("outer"):
            pass
    assert list(inner) == ["inner"] and list(outer) == ["outer"]


def test_another_thread_does_not_disturb():
    def work():
        with stage("elsewhere"):
            pass

    with collect_stages() as seconds:
        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
    assert seconds == {}
