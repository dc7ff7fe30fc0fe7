import gymnasium
import numpy as np
import pytest

from vpr_bench.envs.agent import Agent, MethodAgent, bare
from vpr_bench.errors import UsageError, VprBenchError
from vpr_bench.types.match import Match


class Failing:
    def fit(self, references):
        pass

    def match(self, image, k):
        raise RuntimeError("told to fail")


def test_a_method_is_shown_images_as_they_are(make_env, make_case, brightness):
    case = make_case(sizes=[(6, 8), (9, 5), (2, 2)])
    seen = []
    brightness.may_answer_fewer = "only the first counts here"
    brightness.match = lambda image, k: seen.append(image) or Match([0], [1.0])
    for settings in ({}, {"num_envs": 2}):
        env = make_env(case, order="sequential", **settings)
        agent = MethodAgent(brightness)
        agent.fit(env)
        assert isinstance(agent, Agent)
        seen.clear()
        observation, info = env.reset()
        over = False
        while not over:
            observation, _, terminated, _, info = env.step(agent.act(observation, info))
            over = np.all(terminated)
        assert len(seen) == 5
        assert all(np.array_equal(image, query) for image, query in zip(seen, case.queries, strict=True))
        assert all(image.flags.c_contiguous for image in seen)


def test_fewer_places_than_the_environment_takes(make_env, brightness):
    env = make_env(k=5)
    agent = MethodAgent(brightness, k=2)
    agent.fit(env)
    observation, info = env.reset(seed=0)
    action = agent.act(observation, info)
    assert action in env.action_space and (action["indices"] >= 0).sum() == 2
    with pytest.raises(UsageError, match="1 to 5 places"):
        MethodAgent(brightness, k=6).fit(env)


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (Match([0], [1.0]), "1 reference where 3 were asked for"),
        (Match(range(4), np.zeros(4)), "4 references where 3 were asked for"),
        (Match([8, 1, 2], [3.0, 2.0, 1.0]), "reference 8 of a map of 8"),
        ([1, 2, 3], "a list instead of a Match"),
    ],
)
def test_what_is_no_answer_in_a_run_is_none_here(make_env, brightness, answer, said):
    env = make_env(k=3)
    agent = MethodAgent(brightness)
    agent.fit(env)
    brightness.match = lambda image, k: answer
    with pytest.raises(VprBenchError, match=f"Brightness answered a query with {said}"):
        agent.act(*env.reset(seed=0))


def test_a_method_by_its_name(make_env):
    agent = MethodAgent("hog")
    agent.fit(make_env(size=(64, 64)))
    assert type(agent.method).__name__ == "Hog"


def test_a_method_that_fails_is_named(make_env):
    with pytest.raises(VprBenchError, match="Failing failed while warming up: RuntimeError: told to fail"):
        MethodAgent(Failing()).fit(make_env())


def test_other_environments_are_refused(brightness):
    with pytest.raises(UsageError, match="Got CartPoleEnv"):
        MethodAgent(brightness).fit(gymnasium.make("CartPole-v1"))


def test_wrappers_are_looked_through(make_env):
    env = make_env()
    assert bare(env) is env.unwrapped
