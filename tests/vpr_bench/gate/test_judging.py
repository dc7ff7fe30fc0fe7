import json

import numpy as np
import pytest

from vpr_bench.gate import Baseline, Overrides, Rules, judge, record_cell


@pytest.fixture
def baseline(store, tmp_path):
    return Baseline().with_cells([record_cell(store(root=tmp_path / "old"))])


def test_exact_finds_just_what_changed(baseline, store, made_up_answers, shift):
    indices, scores = made_up_answers()
    moved = np.sort(np.random.default_rng(3).choice(200, 6, replace=False))  # 3 %
    was_right = [int(query) for query in moved if indices[query, 0] == query]
    verdict = judge(baseline, [store(shift(indices, moved), scores)], Overrides(exact=True)).verdicts[0]
    assert verdict.outcome == "fail"
    assert [one.query for one in verdict.changed] == moved.tolist()
    assert [(one.before, one.after) for one in verdict.changed] == [
        (indices[query, 0], (indices[query, 0] + 30) % 200) for query in moved
    ]
    assert verdict.lost == was_right
    assert list(verdict.gained) == []
    assert "6 of 200 queries have another best answer" in verdict.reasons[-1]


def test_gained_queries_are_told_apart(baseline, store, made_up_answers):
    indices, scores = made_up_answers()
    wrong = np.flatnonzero(indices[:, 0] != np.arange(200))[:4]
    better = indices.copy()
    better[wrong] = np.roll(better[wrong], -1, axis=1)
    verdict = judge(baseline, [store(better, scores)]).verdicts[0]
    assert verdict.outcome == "pass"
    assert verdict.improved
    assert (list(verdict.lost), list(verdict.gained)) == ([], wrong.tolist())
    assert "recall@1 rose by 0.020" in verdict.notes


def test_five_points_of_recall_fail_by_the_default_rules(baseline, store, made_up_answers, shift):
    indices, scores = made_up_answers()
    right = np.flatnonzero(indices[:, 0] == np.arange(200))[:10]
    verdict = judge(baseline, [store(shift(indices, right), scores)]).verdicts[0]
    assert verdict.outcome == "fail"
    assert [change.metric for change in verdict.metrics if change.faults] == ["pr_auc", "recall@1"]
    assert list(verdict.lost) == right.tolist()


def test_the_same_answers_pass_by_the_strictest_rules(baseline, store):
    strict = Overrides({"recall@1": 0.0, "pr_auc": 0.0, "roc_auc": 0.0}, 0.9, exact=True)
    judgement = judge(baseline, [store()], strict)
    assert judgement.exit_code == 0
    assert judgement.verdicts[0].notes == []


def test_a_cell_without_a_run_is_missing(baseline):
    judgement = judge(baseline, [])
    assert judgement.exit_code == 1
    assert judgement.verdicts[0].outcome == "missing"
    assert "--run" in judgement.verdicts[0].reasons[0]


def test_why_runs_are_not_those_of_a_missing_cell(baseline, store):
    verdict = judge(baseline, [store(seed=1, parameters={"size": 8, "seed": 1}), store(limit=5)]).verdicts[0]
    assert "its seed is 1, the baseline's 0" in " ".join(verdict.reasons)
    assert "--limit" in " ".join(verdict.reasons)


def test_a_run_without_a_cell_is_new_and_fails_nothing(baseline, store):
    judgement = judge(baseline, [store(), store(label="fresh")])
    assert [one.outcome for one in judgement.verdicts] == ["pass", "new"]
    assert judgement.verdicts[1].metrics[1].after > 0.5
    assert judgement.exit_code == 0


def test_other_images_are_an_error_that_names_both(baseline, store):
    judgement = judge(baseline, [store(dataset_digest="sha256:" + "1" * 64)])
    verdict = judgement.verdicts[0]
    assert (verdict.outcome, judgement.exit_code) == ("error", 3)
    assert "sha256:" + "0" * 64 in verdict.reasons[0]
    assert "sha256:" + "1" * 64 in verdict.reasons[0]


def test_what_cannot_be_read_is_an_error(baseline, store):
    run = store()
    (run.folder / "labels.npz").write_bytes(b"")
    judgement = judge(baseline, [run])
    assert (judgement.verdicts[0].outcome, judgement.exit_code) == ("error", 3)


def test_changes_around_the_answers_are_noted(baseline, store, machine):
    other = machine.model_copy(update={"processor": "Q", "libraries": {"vpr-bench": "9.9"}})
    verdict = judge(baseline, [store(version="2", weights="sha256:w", machine=other)]).verdicts[0]
    assert verdict.outcome == "pass"
    notes = "\n".join(verdict.notes)
    assert "version of the method: 1 → 2" in notes
    assert "weights: none → sha256:w" in notes
    assert "vpr-bench: 0.1.0 → 9.9" in notes
    assert "machine: P" in notes


def test_slower_answers_fail_only_if_times_are_judged(baseline, store):
    run = store(total=0.9)
    unasked = judge(baseline, [run]).verdicts[0]
    assert unasked.outcome == "pass"
    assert "30.00 times as long" in unasked.notes[0]
    verdict = judge(baseline, [run], Overrides(latency_ratio=2)).verdicts[0]
    assert "times as long" in verdict.reasons[0]
    loud = store(total=0.9, elsewhere=0.6, root=run.folder.parents[5] / "loud")
    verdict = judge(baseline, [loud], Overrides(latency_ratio=2)).verdicts[0]
    assert verdict.outcome == "pass"
    assert "times are not judged" in verdict.notes[-1]


def test_rules_that_allow_everything_do_not_pass(baseline, store):
    verdict = judge(baseline.model_copy(update={"rules": Rules()}), [store()]).verdicts[0]
    assert verdict.outcome == "fail"
    assert "allow everything" in verdict.reasons[0]


def test_everything_is_in_the_json(failing):
    content = json.loads(json.dumps(failing.as_dict(), allow_nan=False))
    cells = {cell["method"]: cell for cell in content["cells"]}
    assert {name: cell["verdict"] for name, cell in cells.items()} == {
        "absent": "missing",
        "fails": "fail",
        "passes": "pass",
        "fresh": "new",
    }
    assert content["passed"] is False
    assert len(cells["fails"]["changed"]) == 40
    assert len(cells["fails"]["lost"]) > 20
    assert cells["fails"]["lost"][0]["name"].startswith("day_right/")
    assert cells["fails"]["metrics"]["recall@1"]["tolerance"] == 0.02
