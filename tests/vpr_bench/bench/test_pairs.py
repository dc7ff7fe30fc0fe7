import json

import numpy as np

from vpr_bench.bench.pairs import route, run


def test_a_small_run_reports_what_it_measured():
    result = run(queries=300, dimensions=16, radius=3)
    assert json.loads(json.dumps(result)) == result
    assert result["pairs"] == 300 * 300
    assert result["true_pairs"] == 300 * 7 - 2 * (1 + 2 + 3)  # the ends of the route lack 3 + 2 + 1 each
    assert result["seconds"] > 0 and result["peak_rss_bytes"] > 10_000_000
    assert 0 < result["pr_auc_pairs"] < 1


def test_the_made_up_route_repeats_and_resembles_itself():
    queries, references = route(400, dimensions=64, smoothness=5.0, seed=1)
    assert queries.dtype == references.dtype == np.float32
    assert np.array_equal(queries, route(400, dimensions=64, smoothness=5.0, seed=1)[0])
    similarity = queries @ references.T
    near = np.abs(np.subtract.outer(np.arange(400), np.arange(400))) <= 2
    assert similarity[near].mean() > similarity[~near].mean() + 0.1
