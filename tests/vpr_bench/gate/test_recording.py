import numpy as np
import pytest

from vpr_bench.errors import UsageError
from vpr_bench.gate.recording import changed_parameters, record_cell
from vpr_bench.report.rows import score_run
from vpr_bench.types.protocol import Protocol


def test_a_cell_holds_what_the_run_was(store):
    run = store(weights="sha256:w", seed=3, parameters={"size": 8, "seed": 3})
    cell = record_cell(run)
    cell.check()
    assert (cell.label, cell.method, cell.seed, cell.k, cell.weights) == ("made-up", "made-up", 3, 5, "sha256:w")
    assert cell.parameters == {}
    assert cell.latency == {"encode_p50": 15.0, "encode_p95": 15.0, "total_p50": 30.0, "total_p95": 30.0}
    metrics = score_run(run, ["recall@1", "pr_auc"]).metrics
    assert {name: cell.metrics[name] for name in metrics} == pytest.approx(metrics, abs=1e-6)


@pytest.mark.parametrize("policy", ["", "~miss", "~reject"])
def test_queries_without_a_true_match(store, policy):
    cell = record_cell(store(protocol=f"gardens/day_left-day_right@0f{policy}", unasked=25))
    cell.check()
    assert cell.answered.has_match.sum() == 175
    assert len(cell.judged) == (200 if policy else 175)


def test_another_radius_and_more_metrics(store):
    run = store()
    wider = record_cell(run, Protocol.parse("gardens/day_left-day_right@5f"), ["recall@3"])
    wider.check()
    assert wider.metrics["recall@1"] >= record_cell(run).metrics["recall@1"]
    assert wider.metrics["recall@3"] is not None
    assert wider.metrics["recall@10"] is None  # only five answers are known


def test_a_partial_run_is_refused(store):
    with pytest.raises(UsageError, match="only some of the queries"):
        record_cell(store(limit=20))


def test_parameters_are_written_as_for_the_command_line(store):
    inner = {"method": "hog", "version": "1", "parameters": {"cell": 32, "bins": 9}, "weights": None}
    run = store(label="seqslam(inner=hog(cell=32), past=5)", parameters={"inner": inner, "past": 5, "contrast": 80})
    assert changed_parameters(run.record) == {"inner": "hog", "inner.cell": 32, "past": 5}


def test_a_seed_of_its_own_is_a_parameter(store):
    run = store(parameters={"seed": 7})
    assert changed_parameters(run.record) == {"seed": 7}


def test_scores_are_kept_up_to_their_order(store, made_up_answers):
    indices, scores = made_up_answers()
    plain = record_cell(store(indices, scores, version="1"))
    rescaled = record_cell(store(indices, np.exp(5 * scores), version="2"))
    assert plain.answers == rescaled.answers
