from itertools import pairwise

import gymnasium
import numpy as np
import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.error import InvalidAction, ResetNeeded
from gymnasium.wrappers import FrameStackObservation

from vpr_bench.envs.single import VprEnv
from vpr_bench.errors import UsageError

LOST = 4
FIRST = int(np.random.default_rng(3).permutation(5)[0])


def test_an_episode_asks_every_query_once(make_env, answer):
    env = make_env()
    observation, info = env.reset(seed=3)
    order, asked, over = np.random.default_rng(3).permutation(5).tolist(), [], False
    while not over:
        assert observation in env.observation_space
        brightness = int(observation[0, 0, 0])
        observation, reward, over, truncated, info = env.step(answer(env, (brightness - 12) // 20))
        asked.append(info["query"])
        assert not truncated and info["correct"] == info["has_match"] == bool(reward) == (asked[-1] != LOST)
    assert asked == order
    assert not observation.any() and info["size"].tolist() == [0, 0]


def test_before_an_answer_nothing_tells_where_it_is(make_env, answer):
    env = make_env()
    _, info = env.reset(seed=3)
    assert list(info) == ["size"] and info["size"].tolist() == [6, 8]
    _, _, _, _, info = env.step(answer(env, 0))
    assert set(info) == {"size", "query", "correct", "has_match", "truth"}  # of the query that was answered
    assert info["query"] == FIRST


def test_seeds(make_env):
    env = make_env()
    env.reset(seed=3)
    following = [env.reset()[0] for _ in range(8)]
    assert len({image.tobytes() for image in following}) > 1  # without a seed it is shuffled anew
    env.reset(seed=3)
    assert all(np.array_equal(env.reset()[0], image) for image in following)


def test_in_order(make_env, answer):
    env = make_env(order="sequential")
    env.reset(seed=3)
    assert [env.step(answer(env, 0))[4]["query"] for _ in range(5)] == [0, 1, 2, 3, 4]


def test_the_truth_is_padded_to_one_length(make_env, answer):
    env = make_env(order="sequential")
    env.reset()
    truths = [env.step(answer(env, 0))[4]["truth"].tolist() for _ in range(5)]
    assert truths == [[0, 1, -1], [0, 1, 2], [1, 2, 3], [2, 3, 4], [-1, -1, -1]]


@pytest.mark.parametrize(("unmatched", "reward"), [("exclude", 0.0), ("miss", 0.0), ("reject", 1.0)])
def test_rejecting_is_right_where_the_protocol_says_so(make_env, make_case, answer, unmatched, reward):
    env = make_env(make_case(unmatched=unmatched), order="sequential")
    env.reset()
    rewards = [env.step(answer(env))[1] for _ in range(5)]
    assert rewards == [0, 0, 0, 0, reward]


def test_the_radius_and_places_that_were_asked_for(tiny_dataset, answer):
    env = gymnasium.make("vpr_bench/Place-v0", dataset="tiny", edition="real", radius=3, k=2, unmatched="miss")
    assert str(env.unwrapped.protocol) == "tiny/day_left-day_right@3f~miss"
    assert env.action_space.k == env.unwrapped.k == 2
    assert len(env.unwrapped.references) == 12
    env.reset(seed=0)
    assert len(env.step(answer(env, 0))[4]["truth"]) == 7


def test_the_observation_is_what_a_run_shows(tiny_dataset):
    env = gymnasium.make("vpr_bench/Place-v0", dataset="tiny")
    observation, _ = env.reset(seed=0)
    case = env.unwrapped.case
    assert np.array_equal(observation, case.queries[int(np.random.default_rng(0).permutation(len(case.queries))[0])])


def test_an_invalid_action_can_be_given_again(make_env, answer):
    env = make_env()
    env.reset(seed=3)
    with pytest.raises(InvalidAction, match="only once"):
        env.step({"indices": np.zeros(8, np.int64), "scores": np.zeros(8, np.float32)})
    assert env.step(answer(env, 0))[4]["query"] == FIRST


def test_when_there_is_nothing_to_answer(make_env, answer):
    env = make_env().unwrapped
    with pytest.raises(ResetNeeded, match="call reset"):
        env.step(answer(env, 0))
    env.reset(seed=0)
    assert [env.step(answer(env, 0))[2] for _ in range(5)] == [False] * 4 + [True]
    with pytest.raises(ResetNeeded, match="call reset"):
        env.step(answer(env, 0))


def test_mixed_sizes(make_env, make_case):
    env = make_env(make_case(sizes=[(6, 8), (9, 5)]), order="sequential")
    observation, info = env.reset()
    assert observation.shape == (9, 8, 3) and info["size"].tolist() == [6, 8]
    assert observation[:6, :8].all() and not observation[6:].any()


def test_the_spec_survives_json(tiny_dataset):
    env = gymnasium.make("vpr_bench/Place-v0", dataset="tiny", radius=2, size=(24, 32), order="sequential")
    spec = EnvSpec.from_json(env.spec.to_json())
    again = gymnasium.make(spec)
    assert again.spec.kwargs == {"dataset": "tiny", "radius": 2, "size": [24, 32], "order": "sequential"}
    assert np.array_equal(again.reset()[0], env.reset()[0])


def test_gymnasium_names_a_setting_that_there_is_not(tiny_dataset):
    with pytest.raises(TypeError, match="radios"):
        gymnasium.make("vpr_bench/Place-v0", dataset="tiny", radios=2)
    with pytest.raises(UsageError, match="no dataset 'tinny'"):
        gymnasium.make("vpr_bench/Place-v0", dataset="tinny")


def test_frames_can_be_stacked_for_agents_that_need_the_sequence(make_env, answer):
    env = FrameStackObservation(make_env(order="sequential"), 3)
    observation, _ = env.reset()
    for _ in range(2):
        observation = env.step(answer(env.unwrapped, 0))[0]
    assert observation in env.observation_space
    assert observation[:, 0, 0, 0].tolist() == [12, 32, 52]


def test_text(make_env, answer):
    env = make_env(render_mode="ansi", order="sequential")
    env.reset()
    assert env.render() == "plain/summer-winter@1f: 5 queries, none answered yet"
    env.step(answer(env, 1))
    assert env.render() == "1/5 right       0 (winter[0]) → 1 (summer[1]) 1, truth 0–1"
    env.reset()
    assert "none answered" in env.render()


def test_pictures_keep_their_size(make_env, answer):
    env = make_env(render_mode="rgb_array")
    env.reset(seed=3)
    pictures = [env.render()]
    for _ in range(5):
        env.step(answer(env, 1))
        pictures.append(env.render())
    assert len({picture.shape for picture in pictures}) == 1
    assert all(not np.array_equal(one, other) for one, other in pairwise(pictures))


def test_without_a_mode_nothing_is_rendered(make_env):
    env: VprEnv = make_env().unwrapped
    env.reset()
    assert env.render() is None
