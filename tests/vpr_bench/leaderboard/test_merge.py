from contextlib import contextmanager

import pytest

from vpr_bench.errors import DamagedError, DataError
from vpr_bench.leaderboard import merge as merge_module
from vpr_bench.leaderboard.merge import merge
from vpr_bench.progress import listen

LATER = "2026-02-02T00:00:00+00:00"


def methods(entries):
    return [entry.method for entry in entries]


def test_rows_whose_runs_are_not_here_stay(make_run, make_entry):
    old = make_entry("sift")
    merged = merge([old], [make_run("hog")])
    assert methods(merged.new) == ["hog"]
    assert merged.kept == [old]
    assert sorted(methods(merged.entries)) == ["hog", "sift"]


def test_a_newer_run_of_the_same_cell_replaces(make_run):
    first = merge([], [make_run(right=3)])
    second = merge(first.entries, [make_run(right=8, seed=1, created=LATER)])
    assert methods(second.replaced) == ["hog"]
    assert [entry.right.sum() for entry in second.entries] == [8]


def test_an_older_run_does_not(make_run):
    first = merge([], [make_run(right=8, created=LATER)])
    second = merge(first.entries, [make_run(right=3, seed=1)])
    assert second.entries == first.entries == second.kept


def test_of_two_runs_of_a_cell_the_newer_one_counts_in_either_order(make_run):
    runs = [make_run(right=3), make_run(right=8, seed=1, created=LATER)]
    for order in (runs, runs[::-1]):
        assert [entry.right.sum() for entry in merge([], order).entries] == [8]


def test_another_machine_has_a_row_of_its_own(make_run):
    first = merge([], [make_run()])
    second = merge(first.entries, [make_run(seed=1, processor="Another", created=LATER)])
    assert methods(second.new) == ["hog"]
    assert len(second.entries) == 2


@pytest.mark.parametrize("newer_is_larger", [False, True])
def test_a_run_that_kept_more_answers_comes_first_whenever_it_was_made(make_run, newer_is_larger):
    larger = make_run(right=8, k=5, **({"created": LATER} if newer_is_larger else {}))
    smaller = make_run(right=3, k=2, **({} if newer_is_larger else {"created": LATER}))
    for order in ([larger, smaller], [smaller, larger]):
        assert [entry.k for entry in merge([], order).entries] == [5]
    entries = merge([], [larger]).entries
    assert merge(entries, [smaller]).entries == entries
    replaced = merge(merge([], [smaller]).entries, [larger]).entries
    assert [entry.metrics["recall@5"].value for entry in replaced] == [entries[0].metrics["recall@5"].value]


def test_all_queries_come_before_many_answers(make_run):
    assert [entry.k for entry in merge([], [make_run(k=2), make_run(k=5, asked=4)]).entries] == [2]


@pytest.fixture
def collected(monkeypatch):
    """Return the labels of the runs that have been scored."""
    labels = []
    collect = merge_module.collect
    monkeypatch.setattr(merge_module, "collect", lambda run, *on: labels.append(run.record.label) or collect(run, *on))
    return labels


def test_what_is_there_already_is_not_computed_again(make_run, collected):
    runs = [make_run("hog"), make_run("sift")]
    entries = merge([], runs).entries
    collected.clear()
    assert merge(entries, runs).entries == entries
    assert collected == []
    merge(entries, [*runs, make_run("random")])
    assert collected == ["random"]


def test_a_partial_run_is_not_computed_where_another_machine_has_a_complete_one(make_run, collected):
    runs = [make_run(), make_run(asked=4, processor="Another", created=LATER)]
    entries = merge([], runs).entries
    assert merge(entries, runs).entries == entries
    assert collected == ["hog"]


def test_a_protocol_that_the_places_do_not_serve_is_not_computed(make_run, collected):
    # The ten places by hand lie within nine metres.
    run = make_run(protocol="berlin-a100:simulated/a100_2-a100_1@5nearest")
    assert [entry.protocol.reach for entry in merge([], [run]).entries] == ["5nearest"]
    assert collected == ["hog"]


def test_a_partial_run_gives_way_to_a_complete_one(make_run):
    partial, whole = make_run(asked=4, created=LATER), make_run()
    first = merge([], [partial])
    assert [entry.partial for entry in first.entries] == [True]
    second = merge(first.entries, [whole])
    assert [entry.partial for entry in second.entries] == [False]
    assert methods(second.replaced) == ["hog"]
    assert merge(second.entries, [partial]).entries == second.entries


def test_a_partial_run_gives_way_to_a_complete_one_on_another_machine(make_run):
    first = merge([], [make_run(asked=4)])
    second = merge(first.entries, [make_run(processor="Another")])
    assert [entry.partial for entry in second.entries] == [False]
    assert methods(second.dropped) == ["hog"]


@pytest.fixture
def damaged(make_run):
    run = make_run("broken")
    (run.folder / "matches.npz").write_bytes(b"nothing")
    return run


def test_a_run_that_cannot_be_scored_is_left_out_if_somebody_listens(make_run, damaged):
    told = []
    merged = merge([], [damaged, make_run()], told.append)
    assert methods(merged.entries) == ["hog"]
    assert [str(damaged.folder) in str(error) for error in told] == [True]


def test_and_told_once_however_many_protocols_it_serves(make_run):
    run = make_run(protocol="gardens/day_left-night_right@0f")
    (run.folder / "labels.npz").write_bytes(b"nothing")
    told = []
    assert merge([], [run], told.append).entries == []
    assert len(told) == 1


def test_and_refused_if_nobody_does(make_run, damaged):
    with pytest.raises(DataError, match="broken"):
        merge([], [make_run(), damaged])


def test_a_run_of_no_time_is_damaged(make_run):
    with pytest.raises(DamagedError, match="'soon' is no time"):
        merge([], [make_run(created="soon")])


def test_where_nothing_is_to_be_scored_no_progress_is_shown(make_run):
    shown, run = [], make_run()

    @contextmanager
    def listener(description, total):
        shown.append((description, total))
        yield lambda steps: None

    with listen(listener):
        rows = merge([], [run]).entries
        merge(rows, [run])
    assert shown == [("Scoring", 1)]
