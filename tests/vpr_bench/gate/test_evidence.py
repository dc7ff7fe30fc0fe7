import pytest

from vpr_bench.errors import DataError, UsageError
from vpr_bench.gate import Baseline, Overrides, record_cell
from vpr_bench.gate.evidence import collect, run_and_collect
from vpr_bench.gate.selection import Selection


@pytest.fixture
def baseline(store, elsewhere):
    return Baseline().with_cells(record_cell(store(label=label, root=elsewhere)) for label in ("a", "b"))


def test_only_what_is_asked_about_is_judged(baseline, store, tmp_path):
    for label in ("a", "b", "c"):
        store(label=label)
    evidence = collect(baseline, Selection(methods=["b"]), tmp_path / "runs")
    judgement = evidence.judge(Overrides())
    assert [(one.label, one.outcome) for one in judgement.verdicts] == [("b", "pass")]
    assert judgement.left_out == 1
    judged = collect(baseline, Selection(), tmp_path / "runs").judge(Overrides())
    assert [(one.label, one.outcome) for one in judged.verdicts] == [("a", "pass"), ("b", "pass"), ("c", "new")]


def test_damaged_runs_stand_with_the_rest(baseline, store, tmp_path):
    store(label="a")
    (store(label="b").folder / "matches.npz").unlink()
    judgement = collect(baseline, Selection(), tmp_path / "runs").judge(Overrides())
    assert [(one.label, one.outcome) for one in judgement.verdicts] == [("a", "pass"), ("b", "error")]
    assert judgement.verdicts[1].reasons[0].startswith("its run is damaged: ")
    assert judgement.exit_code == 3
    evidence = collect(baseline, Selection(methods=["a"]), tmp_path / "runs")
    assert [one.label for one in evidence.judge(Overrides()).verdicts] == ["a"]


def test_partial_runs_are_skipped_by_name(baseline, store, tmp_path):
    store(label="a")
    partial = store(label="c", limit=20)
    judgement = collect(baseline, Selection(methods=["a", "c"]), tmp_path / "runs").judge(Overrides())
    assert judgement.skipped == [partial.folder]
    assert judgement.summary() == "1 passed, 1 not asked about, 1 partial skipped"


def test_names_that_mean_nothing(baseline, store, tmp_path):
    store()
    with pytest.raises(UsageError, match="method 'z'"):
        collect(baseline, Selection(methods=["z"]), tmp_path / "runs")
    with pytest.raises(UsageError, match="method 'made-up'"):
        run_and_collect(baseline, Selection(methods=["made-up"]), tmp_path / "runs", print)


def test_no_runs_at_all(baseline, tmp_path):
    with pytest.raises(DataError, match="There are no runs"):
        collect(baseline, Selection(), tmp_path / "nowhere")


def test_what_cannot_be_run_is_no_older_runs_verdict(baseline, store, tmp_path):
    store(label="a")
    said = []
    evidence = run_and_collect(baseline, Selection(), tmp_path / "runs", said.append)
    assert said == []
    verdicts = evidence.judge(Overrides()).verdicts
    assert [(one.label, one.outcome) for one in verdicts] == [("a", "error"), ("b", "error")]
