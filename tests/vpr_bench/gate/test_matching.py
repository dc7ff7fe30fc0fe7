from dataclasses import dataclass

import pytest

from vpr_bench.gate.matching import asked_for, choose, without_cell
from vpr_bench.gate.recording import record_cell
from vpr_bench.method.build import METHODS
from vpr_bench.registry import Entry
from vpr_bench.types.protocol import Protocol

NEW, OLD = "2026-05-01T00:00:00+00:00", "2026-02-01T00:00:00+00:00"


@dataclass
class MadeUp:
    version = "2"

    def fit(self, references):
        pass

    def match(self, image, k):
        pass


@pytest.fixture
def cell(store):
    return record_cell(store())


@pytest.fixture
def installed(monkeypatch):
    """Let the method be installed, in its version 2."""
    entry = Entry("made-up", "nowhere:MadeUp", "a package 1.0")
    monkeypatch.setattr(Entry, "load", lambda self: MadeUp)
    monkeypatch.setitem(vars(METHODS), "_found", {"made-up": [entry]})


def test_the_newest_run_is_taken(cell, store):
    runs = [store(created=NEW, threads=1), store(created=OLD, threads=3)]
    assert choose(cell, runs) == runs[0]


def test_of_several_versions_the_present_one_is_taken(cell, store, installed):
    runs = [store(created=OLD, version="2"), store(created=NEW, version="3", threads=1)]
    assert choose(cell, runs) == runs[0]


def test_of_several_versions_of_an_absent_method_the_newest_is_taken(cell, store):
    runs = [store(created=OLD, version="2"), store(created=NEW, version="3", threads=1)]
    assert choose(cell, runs) == runs[1]


@pytest.mark.parametrize(
    "facts",
    [
        {"seed": 1},
        {"k": 4},
        {"limit": 5},
        {"label": "made-up(size=9)"},
        {"parameters": {"size": 8, "seed": 5}},
        {"protocol": "gardens:simulated/day_left-day_right@0f"},
        {"protocol": "gardens/day_left-night_right@0f"},
    ],
    ids=str,
)
def test_a_run_of_something_else_is_not_taken(cell, store, facts):
    assert choose(cell, [store(**facts, threads=1)]) is None


def test_one_run_serves_every_radius(cell, store):
    assert choose(cell, [store(protocol="gardens/day_left-day_right@3f", threads=1)]) is not None


def test_new_are_the_newest_whole_runs_that_no_cell_is_about(cell, store):
    first, second = store(label="b", created=OLD), store(label="b", created=NEW, seed=3)
    runs = [store(seed=4), first, second, store(label="c", limit=3), store(label="a")]
    assert [run.record.label for run in without_cell([cell], runs)] == ["a", "b"]
    assert without_cell([cell], runs)[1] == second


def test_another_radius_is_new_only_if_somebody_named_it(cell, store):
    run = store(threads=1)
    wider = asked_for(run, Protocol.parse("gardens/day_left-day_right@3f"))
    assert (wider.folder, wider.record.key) == (run.folder, run.record.key)
    assert without_cell([cell], [run, wider]) == []
    assert without_cell([cell], [run, wider], named=True) == [wider]
