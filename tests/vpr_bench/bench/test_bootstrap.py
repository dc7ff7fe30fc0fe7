import json

from vpr_bench.bench.bootstrap import made_up_answers, run
from vpr_bench.metrics.definitions import METRICS


def test_a_small_run_reports_what_it_measured():
    result = run(queries=300, resamples=40, seed=1)
    assert json.loads(json.dumps(result)) == result
    assert result["intervals"].keys() == METRICS.keys() - {"pr_auc_pairs"}
    assert result["metrics"] == len(METRICS) - 1 and (result["queries"], result["resamples"]) == (300, 40)
    value, low, high = result["intervals"]["recall@1"]
    assert low < value < high
    assert result["seconds"] > 0 and result["processor_seconds"] > 0 and result["peak_rss_bytes"] > 10_000_000


def test_what_is_undefined_is_null():
    assert json.loads(json.dumps(run(queries=1, resamples=2)))["intervals"]["roc_auc"] == [None, None, None]


def test_the_made_up_answers_repeat_and_their_scores_tell():
    answers = made_up_answers(5000, seed=3)
    assert (answers.correct == made_up_answers(5000, seed=3).correct).all()
    assert answers.score[answers.correct].mean() > answers.score[~answers.correct].mean() + 0.2
    assert 0.45 < answers.correct.mean() < 0.55 and ((answers.rank == 0) == answers.correct).all()
