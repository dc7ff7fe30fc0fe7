import json

import numpy as np
import pytest
from filelock import FileLock, Timeout

from vpr_bench.errors import DamagedError, DataError
from vpr_bench.gate.baseline import Baseline, being_updated, read_baseline, write_baseline
from vpr_bench.gate.recording import record_cell
from vpr_bench.gate.rules import Rule, Rules

ID = "gardens/day_left-day_right@0f made-up"


@pytest.fixture
def baseline(store):
    return Baseline().with_cells([record_cell(store()), record_cell(store(label="another"))])


@pytest.fixture
def path(baseline, tmp_path):
    path = tmp_path / "leaderboards" / "baseline.json"
    write_baseline(baseline, path)
    return path


def edit(path, change):
    """Let ``change`` edit the file's content."""
    content = json.loads(path.read_text())
    change(content)
    path.write_text(json.dumps(content))


def test_what_is_written_is_read(baseline, path):
    assert read_baseline(path) == baseline


def test_nothing_new_is_not_written(baseline, path):
    before = path.stat().st_mtime_ns
    assert not write_baseline(baseline, path)
    assert path.stat().st_mtime_ns == before


def test_a_cell_of_200_queries_is_small(store):
    one = Baseline().with_cells([record_cell(store())])
    assert len(one.text()) < 4000


def test_the_file_shows_what_moved(store, made_up_answers, shift):
    indices, scores = made_up_answers()
    right = next(query for query in range(40, 60) if indices[query, 0] == query)
    old = Baseline().with_cells([record_cell(store())]).text().splitlines()
    new = Baseline().with_cells([record_cell(store(shift(indices, [right]), scores, version="2"))]).text().splitlines()
    moved = [line.split('"')[1] for line, other in zip(old, new, strict=True) if line != other]
    assert sum(line.startswith("40: ") for line in moved) == 2  # its best answer, and the rank of the right one
    assert {"recall@1", "digest", "version"} < set(moved)
    assert not {"n_queries", "label", "k"} & set(moved)


def test_rules_may_be_edited(path):
    def loosen(content):
        content["rules"]["metrics"]["recall@1"]["tolerance"] = 0.1
        content["cells"][ID]["rules"] = {"exact": True}

    edit(path, loosen)
    found = read_baseline(path)
    rules = found.rules_of(found.cells[ID])
    assert rules.exact is True
    assert rules.metrics["recall@1"] == Rule(tolerance=0.1, significance=0.05)


def test_a_cells_rules_are_kept_in_the_file(baseline, tmp_path):
    cell = baseline.cells[ID].model_copy(update={"rules": Rules(latency_ratio=2.0)})
    write_baseline(baseline.with_cells([cell]), tmp_path / "one.json")
    assert read_baseline(tmp_path / "one.json").cells[ID].rules == Rules(latency_ratio=2.0)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda cell: cell["metrics"].update({"recall@1": 0.9}), "recall@1 is 0.9 in the file, and 0."),
        (lambda cell: cell["metrics"].update({"recall@1": None}), "recall@1 is undefined in the file"),
        (lambda cell: cell["metrics"].update({"recal@1": 0.9}), "no metric 'recal@1'"),
        (lambda cell: cell["answers"]["best"].pop(), "answers.best: there are 180 values for 200 queries"),
        (lambda cell: cell["answers"]["rank"].reverse(), "answers.rank: each line must be"),
        (lambda cell: cell["answers"]["best"].__setitem__(0, "0: " + " ".join("1" * 20)), "its digest is another one"),
        (lambda cell: cell.update(dataset="sha256:" + "1" * 64), "its digest is another one"),
        (lambda cell: cell.update(seed="0"), "valid integer"),
        (lambda cell: cell.update(protocol="nonsense"), "it holds 'nonsense made-up'"),
        (lambda cell: cell.update(n_queries=10**30), "n_queries"),
        (lambda cell: cell.update(n_references=7), "no whole number below 7"),
        (lambda cell: cell.update(surprise=1), "surprise"),
        (lambda cell: cell.pop("digest"), "its digest is another one"),
        (lambda cell: cell["latency"].update(total_p50=-1.0), "total_p50"),
        (lambda cell: cell.update(rules={"metrics": {"pr_auc_pairs": {"tolerance": 0.1}}}), "scores of all pairs"),
    ],
)
def test_an_edited_cell_is_named(path, change, said):
    edit(path, lambda content: change(content["cells"][ID]))
    with pytest.raises(DamagedError) as refused:
        read_baseline(path)
    assert str(path) in str(refused.value)
    assert ID in str(refused.value)
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


def test_rules_that_are_wrong_are_told_what_they_may_hold(path):
    edit(path, lambda content: content["cells"][ID].update(rules={"exact": 1}))
    with pytest.raises(DamagedError, match=r'rules\.exact: Input should be a valid boolean\. Rules hold "exact"'):
        read_baseline(path)


def test_a_duplicate_cell_is_named(path):
    text = path.read_text()
    start = text.index('  "gardens')
    path.write_text(text[:start] + f'"{ID}": {{}},\n' + text[start:])
    with pytest.raises(DamagedError, match=f"'{ID}' is there 2 times"):
        read_baseline(path)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is empty. Take it back from version control"),
        (" \n", "is empty"),
        ('{"schema_version": 1,\n<<<<<<< ours\n', "line 2: '<<<<<<<' is the mark of a merge conflict"),
        ('{"schema_version": 1\n"rules": {}}', "line 2, column 1: Expecting ',' delimiter. Mend that line"),
        ('{"schema_version": 1, "rules": {"metrics": {"accuracy": {"tol": 1}}}}', "(0 to 1)"),
        ("[]", "holds no object"),
        ("{}", "has no schema_version"),
        ('{"schema_version": true}', "has no schema_version"),
        ('{"schema_version": 99}', "has schema version 99; this vpr-bench reads 1 to 1"),
        ('{"schema_version": 1, "rules": {"latency_ratio": NaN}}', "NaN is no number"),
        ('{"schema_version": 1, "rules": {"latency_ratio": 1e999}}', "latency_ratio"),
        ('{"schema_version": 1, "rules": {"metrics": {"auc": {}}}}', "no metric 'auc'"),
        ('{"schema_version": 1, "cells": {"a\\u001b[31m": 1}}', "is damaged"),
        ("[" * 100_000, "is damaged"),
        ("\xff", "is damaged"),
    ],
    ids=range(15),
)
def test_what_is_no_baseline_is_refused(tmp_path, text, said):
    path = tmp_path / "baseline.json"
    path.write_bytes(text.encode("latin-1"))
    with pytest.raises(DataError) as refused:
        read_baseline(path)
    assert said in str(refused.value)
    assert "\x1b" not in str(refused.value)


def test_no_baseline_says_how_to_record_one(tmp_path):
    with pytest.raises(DataError, match="--update"):
        read_baseline(tmp_path / "none.json")


def test_a_folder_in_its_place(tmp_path):
    with pytest.raises(DataError, match="Cannot read"):
        read_baseline(tmp_path)


def test_answers_come_back_as_they_were(store, made_up_answers):
    cell = record_cell(store())
    assert np.array_equal(cell.answered.best, made_up_answers()[0][:, 0])


def test_one_process_at_a_time_updates_a_baseline(tmp_path, store):
    path = tmp_path / "ci" / "baseline.json"
    with being_updated(path) as fresh:
        with pytest.raises(Timeout):
            FileLock(tmp_path / "ci" / ".baseline.json.lock").acquire(timeout=0)
        write_baseline(fresh.with_cells([record_cell(store())]), path)
    with being_updated(path) as written:
        assert len(written.cells) == 1
