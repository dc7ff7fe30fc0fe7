import gymnasium
import numpy as np
import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.error import InvalidAction, ResetNeeded
from gymnasium.vector import AutoresetMode
from gymnasium.wrappers.vector import RecordEpisodeStatistics

from vpr_bench.errors import UsageError

ORDER = np.random.default_rng(3).permutation(5)


def by_brightness(env, observation):
    """Answer each row with the place that its colour is from."""
    indices = np.full(env.action_space["indices"].shape, -1)
    indices[:, 0] = (observation[:, 0, 0, 0].astype(int) - 12) // 20
    return {"indices": indices, "scores": np.zeros(indices.shape, np.float32)}


@pytest.mark.parametrize("in_memory", [False, True])
def test_batches_ask_what_the_single_environment_asks(make_env, in_memory):
    env = make_env(num_envs=2, in_memory=in_memory)
    for _ in range(2):  # the second time from memory
        observation, info = env.reset(seed=3)
        assert set(info) == {"size", "_size", "mask"}
        asked, over = [], np.zeros(2, bool)
        while not over.any():
            assert observation in env.observation_space
            observation, rewards, over, truncated, info = env.step(by_brightness(env, observation))
            asked.append((info["query"] + 1) * info["_query"])
            assert rewards.tolist() == [float(query not in (0, 5)) for query in asked[-1]]
            assert not truncated.any()
        assert np.concatenate(asked).tolist() == [*(ORDER + 1).tolist(), 0]
        assert over.all() and not info["mask"].any() and not observation.any()


def test_the_last_batch_is_filled_up(make_env):
    env = make_env(num_envs=4)
    observation, info = env.reset(seed=3)
    assert info["mask"].tolist() == [True] * 4
    observation, _, _, _, info = env.step(by_brightness(env, observation))
    assert info["mask"].tolist() == info["_size"].tolist() == [True, False, False, False]
    assert not observation[1:].any() and info["size"].tolist() == [[6, 8], [0, 0], [0, 0], [0, 0]]
    nonsense = {"indices": np.full((4, 8), 99), "scores": np.full((4, 8), np.nan)}
    nonsense["indices"][0] = -1  # the only query is not answered
    _, rewards, over, _, info = env.step(nonsense)
    assert rewards.tolist() == [0] * 4 and over.all()
    assert info["_correct"].tolist() == [True, False, False, False]
    assert info["truth"].shape == (4, 3)


def test_one_batch_that_is_larger_than_the_queries(make_env):
    env = make_env(num_envs=7)
    _, info = env.reset(seed=3)
    assert info["mask"].sum() == 5
    assert env.step(env.action_space.sample())[2].all()


def test_what_the_step_after_the_last_one_does(make_env):
    env = make_env(num_envs=5)
    assert env.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP
    observation, _ = env.reset(seed=3)
    env.step(by_brightness(env, observation))
    observation, rewards, over, _, info = env.step(None)
    assert info["mask"].all() and not rewards.any() and not over.any() and "query" not in info
    assert observation.any()


@pytest.mark.parametrize("mode", ["Disabled", AutoresetMode.DISABLED])
def test_or_it_is_an_error(make_env, mode):
    env = make_env(num_envs=5, autoreset_mode=mode)
    assert env.metadata["autoreset_mode"] is AutoresetMode.DISABLED
    with pytest.raises(ResetNeeded):
        env.step(env.action_space.sample())
    observation, _ = env.reset(seed=3)
    env.step(by_brightness(env, observation))
    with pytest.raises(ResetNeeded):
        env.step(env.action_space.sample())
    env.reset(options={"reset_mask": np.ones(5, bool)})
    with pytest.raises(UsageError, match="together"):
        env.reset(options={"reset_mask": np.arange(5) == 0})


def test_spaces(make_env):
    env = make_env(num_envs=3)
    assert env.observation_space.shape == (3, *env.single_observation_space.shape)
    assert env.action_space.sample() in env.action_space
    assert env.single_action_space.sample() in env.single_action_space


def test_the_wrong_row_is_an_error(make_env):
    env = make_env(num_envs=5)
    env.reset(seed=3)
    action = env.action_space.sample()
    action["indices"][3] = 0
    with pytest.raises(InvalidAction, match="only once"):
        env.step(action)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"num_envs": 0}, "num_envs must be"),
        ({"num_envs": 1.5}, "num_envs must be"),
        ({"num_envs": 2, "autoreset_mode": "SameStep"}, "NextStep or Disabled"),
        ({"num_envs": 2, "render_mode": "ascii"}, "render_mode must be rgb_array or ansi"),
    ],
)
def test_settings_that_are_none(make_env, settings, words):
    with pytest.raises(UsageError, match=words):
        make_env(**settings)


def test_the_spec_survives_json(tiny_dataset):
    env = gymnasium.make_vec("vpr_bench/Place-v0", dataset="tiny", num_envs=3, radius=2)
    spec = EnvSpec.from_json(env.spec.to_json())
    again = gymnasium.make_vec(spec)
    assert again.num_envs == 3 and type(again) is type(env)
    assert np.array_equal(again.reset(seed=1)[0], env.reset(seed=1)[0])


def test_gymnasiums_own_vector_environment_works_too(tiny_dataset):
    env = gymnasium.make_vec("vpr_bench/Place-v0", dataset="tiny", num_envs=2, vectorization_mode="sync")
    env.reset(seed=0)
    for _ in range(14):  # past the end
        _, rewards, _, _, info = env.step(env.action_space.sample())
    assert rewards.shape == (2,) and info["truth"].shape == (2, 3)


def test_gymnasiums_vector_wrappers_work(make_env):
    env = RecordEpisodeStatistics(make_env(num_envs=2))
    observation, _ = env.reset(seed=3)
    over = np.zeros(2, bool)
    while not over.all():
        observation, _, over, _, info = env.step(by_brightness(env, observation))
    assert info["episode"]["r"].sum() == 4 and info["episode"]["l"].tolist() == [3, 3]


def test_rendering(make_env):
    env = make_env(num_envs=2, render_mode="ansi")
    observation, _ = env.reset(seed=3)
    assert env.render() == ("plain/summer-winter@1f: 5 queries, none answered yet",) * 2
    env.step(by_brightness(env, observation))
    assert [line[:3] for line in env.render()] == ["1/5", "2/5"]
    env = make_env(num_envs=4, render_mode="rgb_array")
    observation, _ = env.reset(seed=3)
    shapes = {picture.shape for picture in env.render()}
    observation, *_ = env.step(by_brightness(env, observation))
    env.step(by_brightness(env, observation) | {"indices": np.full((4, 8), -1)})
    assert len(env.render()) == 4 and {picture.shape for picture in env.render()} == shapes
    env = make_env(num_envs=2)
    env.reset()
    assert env.render() is None
