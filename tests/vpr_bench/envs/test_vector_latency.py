import time

import numpy as np
import pytest

from vpr_bench.envs import MethodAgent, RecordVectorLatency, evaluate


def nothing(envs):
    return envs.action_space.sample()


def test_the_time_between_observations_and_actions(make_env):
    envs = RecordVectorLatency(make_env(num_envs=2))
    envs.reset(seed=0)
    for _ in range(3):
        time.sleep(0.01)
        envs.step(nothing(envs))
    assert envs.queries == [2, 2, 1]  # the last batch is filled up
    assert all(0.01 <= taken < 1 for taken in envs.seconds)
    assert envs.summary()["latency_batch_p50"] == pytest.approx(1000 * np.median(envs.seconds))


def test_a_query_has_its_share_of_the_batch(make_env):
    envs = RecordVectorLatency(make_env(num_envs=2))
    envs.seconds, envs.queries = [0.010, 0.010, 0.001], [2, 2, 1]
    summary = envs.summary()
    assert summary["latency_query_p50"] == pytest.approx(5)
    assert summary["latency_query_p99"] == pytest.approx(5)
    assert summary["latency_batch_p50"] == pytest.approx(10)


def test_before_the_first_batch_there_is_nothing_to_tell(make_env):
    envs = RecordVectorLatency(make_env(num_envs=2))
    envs.reset(seed=0)
    assert np.isnan(list(envs.summary().values())).all()


def test_the_next_episode_begins_anew(make_env):
    envs = RecordVectorLatency(make_env(num_envs=5))
    envs.reset(seed=0)
    envs.step(nothing(envs))
    assert envs.queries == [5]
    envs.step(nothing(envs))  # resets
    assert envs.queries == []
    envs.step(nothing(envs))
    assert envs.queries == [5]
    envs.reset(seed=0)
    assert envs.queries == []


def test_environments_of_one_query_each_have_no_mask(make_env):
    envs = RecordVectorLatency(make_env(num_envs=2, vectorization_mode="sync"))
    envs.reset(seed=0)
    envs.step(nothing(envs))
    assert envs.queries == [2]


def test_it_changes_no_answer(make_env, brightness):
    results = []
    for envs in (make_env(num_envs=2), RecordVectorLatency(make_env(num_envs=2))):
        agent = MethodAgent(brightness)
        agent.fit(envs)
        results.append(evaluate(envs, agent, seed=3))
    assert np.array_equal(results[0].indices, results[1].indices)
