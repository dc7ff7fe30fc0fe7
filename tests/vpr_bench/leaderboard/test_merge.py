import pytest

from vpr_bench.errors import DamagedError, DataError
from vpr_bench.leaderboard import merge as merge_module
from vpr_bench.leaderboard.merge import merge

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


def test_what_is_there_already_is_not_computed_again(make_run, monkeypatch):
    runs = [make_run("hog"), make_run("sift")]
    entries = merge([], runs).entries
    collected = []
    collect = merge_module.collect
    monkeypatch.setattr(
        merge_module, "collect", lambda run, *on: collected.append(run.record.label) or collect(run, *on)
    )
    assert merge(entries, runs).entries == entries
    assert collected == []
    merge(entries, [*runs, make_run("random")])
    assert collected == ["random"]


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


def test_and_refused_if_nobody_does(make_run, damaged):
    with pytest.raises(DataError, match="broken"):
        merge([], [make_run(), damaged])


def test_a_run_of_no_time_is_damaged(make_run):
    with pytest.raises(DamagedError, match="'soon' is no time"):
        merge([], [make_run(created="soon")])
