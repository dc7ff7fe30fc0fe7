from pathlib import Path

import pytest

from vpr_bench.errors import DataError, UsageError
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.select import select_run, select_runs


@pytest.fixture
def runs(case, store, built, mean_colour):
    return [run(case, built(mean_colour()), store, RunOptions(seed=seed)) for seed in range(3)]


def folders(found):
    return [one.folder for one in found]


def test_all_oldest_first(runs, store):
    assert {one.folder for one in select_runs(None, store.root)} == set(folders(runs))
    created = [one.record.created for one in select_runs([], store.root)]
    assert created == sorted(created)


def test_named_ones_in_their_order(runs, store):
    names = [str(runs[2].folder), runs[0].folder.name]
    assert folders(select_runs(names, store.root)) == folders([runs[2], runs[0]])


def test_by_the_beginning_of_the_hash(runs, store):
    for one in runs:
        assert select_run(one.folder.name[:6], store.root).folder == one.folder


def test_a_folder_needs_no_root(runs):
    assert select_run(str(runs[0].folder), Path("nowhere")).folder == runs[0].folder


def test_what_is_being_written_or_was_put_aside_is_none(runs, store):
    name = runs[0].folder.name
    runs[0].folder.rename(runs[0].folder.with_name(name + ".damaged"))
    with pytest.raises(UsageError, match=f"no run begins with '{name}'"):
        select_run(name, store.root)


def test_several_begin_so(runs, store):
    shared = runs[0].folder
    shared.rename(shared.with_name(runs[1].folder.name[:3] + "000"))
    with pytest.raises(UsageError, match=r"2 runs begin with .* `vpr-bench show` lists them"):
        select_run(runs[1].folder.name[:3], store.root)


@pytest.mark.parametrize("name", ["zzz", "*", "../x", "", "ABC"])
def test_what_is_no_name(runs, store, name):
    with pytest.raises(UsageError, match="neither a run's folder nor the beginning"):
        select_run(name, store.root)


def test_there_are_none(tmp_path):
    with pytest.raises(DataError, match="There are no runs under"):
        select_runs(None, tmp_path)
