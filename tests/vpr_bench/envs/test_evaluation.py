"""An episode gives the very numbers of a run."""

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import TimeLimit

from vpr_bench.dataset.load import load_case
from vpr_bench.envs import MethodAgent, RecordLatency, evaluate
from vpr_bench.method.build import build_method
from vpr_bench.metrics.definitions import METRICS
from vpr_bench.metrics.definitions import evaluate as evaluate_matches
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.store import RunStore

NAMES = list(METRICS)


def run_of(case, seed, tmp_path):
    """Run with as many threads as the tests have: sums differ in their last digits with more."""
    stored = run(case, build_method("hog"), RunStore(tmp_path / "runs"), RunOptions(seed=seed, threads=1))
    values = evaluate_matches(NAMES, stored.indices, stored.scores, case.ground_truth, case.protocol.unmatched)
    return {"queries": stored.queries, "indices": stored.indices, "scores": stored.scores}, values


@pytest.mark.parametrize(
    ("dataset", "protocol", "seed"),
    [
        ("gardens:simulated", "day_left.every8-day_right.every8", 0),
        ("tiny", "day_left-night_right", 5),
        ("tiny", "day_left.first6-night_right", 0),  # with queries that have no match, which are missed
    ],
)
def test_the_environments_and_the_runner_give_identical_numbers(dataset, protocol, seed, tmp_path, request):
    if dataset == "tiny":
        request.getfixturevalue("tiny_dataset")
    case = load_case(dataset, protocol)
    answers, metrics = run_of(case, seed, tmp_path)
    settings = {"dataset": dataset, "protocol": protocol}
    agent = MethodAgent("hog")
    for env in (
        gymnasium.make("vpr_bench/Place-v0", **settings),
        gymnasium.make_vec("vpr_bench/Place-v0", num_envs=7, **settings),
    ):
        agent.fit(env)
        result = evaluate(env, agent, seed=seed)
        for name, column in result.match_arrays().items():
            assert column.dtype == answers[name].dtype
            assert np.array_equal(column, answers[name]), name
        np.testing.assert_equal(result.metrics(NAMES), metrics)
        assert str(result.protocol) == str(case.protocol)
        if case.protocol.unmatched != "exclude":
            assert result.rewards.mean() == metrics["accuracy"]


def test_it_works_through_wrappers_and_stops_when_they_do(make_env, brightness):
    env = RecordLatency(TimeLimit(make_env(), 3))
    agent = MethodAgent(brightness)
    agent.fit(env)
    result = evaluate(env, agent, seed=3)
    assert result.queries.tolist() == sorted(np.random.default_rng(3).permutation(5)[:3].tolist())
    assert result.ground_truth.n_queries == 3
    assert result.metrics(["recall@1"]) == {"recall@1": 1.0}
    assert len(env.seconds) == 3 and result.order == "shuffled"
