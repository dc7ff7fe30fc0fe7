import time

import gymnasium
import pytest
from gymnasium.envs.registration import EnvSpec

from vpr_bench.envs.latency import RecordLatency


def test_the_time_between_observation_and_action(make_env, answer):
    env = RecordLatency(make_env())
    env.reset(seed=0)
    for _ in range(4):
        time.sleep(0.01)
        env.step(answer(env.unwrapped, 0))
    env.step(answer(env.unwrapped, 0))
    assert len(env.seconds) == 5
    assert all(0.01 <= taken < 1 for taken in env.seconds[:4])
    assert env.summary()["latency_total_p50"] == pytest.approx(10, abs=9)
    env.reset(seed=0)
    assert env.seconds == []


def test_infos_hold_no_clock(make_env, answer):
    env, bare = RecordLatency(make_env()), make_env()
    assert set(env.reset(seed=0)[1]) == set(bare.reset(seed=0)[1])
    assert set(env.step(answer(env.unwrapped, 0))[4]) == set(bare.step(answer(bare, 0))[4])


def test_it_stands_in_the_spec(tiny_dataset):
    env = RecordLatency(gymnasium.make("vpr_bench/Place-v0", dataset="tiny"))
    again = gymnasium.make(EnvSpec.from_json(env.spec.to_json()))
    assert isinstance(again, RecordLatency)
