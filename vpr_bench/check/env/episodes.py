"""Whether episodes are fair and repeat."""

from itertools import zip_longest
from typing import Any

import gymnasium
import numpy as np
from gymnasium.utils.env_checker import data_equivalence

from vpr_bench.check.env.subject import EnvSubject
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.check.suite import check
from vpr_bench.envs.agent import bare

_STEPS = 20
_TOLD_BEFORE = {"size"}
"""All that ``info`` may hold before an answer."""

_Step = tuple[Any, float, bool, dict[str, Any]]


def _steps(env: gymnasium.Env[Any, Any], actions: list[Any] | None = None) -> list[_Step]:
    """Return the start of an episode, answered at random or as it is said."""
    observation, info = env.reset(seed=1)
    env.action_space.seed(1)
    steps: list[_Step] = [(observation, 0.0, False, info)]
    for number in range(_STEPS if actions is None else len(actions)):
        action = env.action_space.sample() if actions is None else actions[number]
        observation, reward, terminated, truncated, info = env.step(action)
        steps.append((observation, float(reward), terminated or truncated, info))
        if terminated or truncated:
            break
    return steps


@check("episodes-repeat", "gymnasium-checker")
def episodes_repeat(subject: EnvSubject) -> None:
    """Check that the same seed and answers make the same episode, also in a new environment."""
    with subject.make() as env, subject.make() as other:
        first = _steps(env)
        for what, again in (("a second time", _steps(env)), ("in a new environment", _steps(other))):
            for number, (one, two) in enumerate(zip_longest(first, again)):
                if not data_equivalence(one, two):
                    raise Failed(f"{what}, step {number} of an episode of the same seed is another one")


@check("nothing-told-before", "gymnasium-checker")
def nothing_told_before(subject: EnvSubject) -> None:
    """Check that before an answer nothing tells which query it is, nor the truth."""
    with subject.make() as env:
        _, info = env.reset(seed=0)
        told = info.keys() - _TOLD_BEFORE
        if told:
            raise Failed(f"before the first answer, info holds {', '.join(sorted(map(str, told)))}")


@check("reward-is-truth", "episodes-repeat")
def reward_is_truth(subject: EnvSubject) -> None:
    """Check that a right answer earns 1 and a wrong one 0, by the ground truth of the protocol."""
    with subject.make() as env:
        case, k = bare(env).case, bare(env).k
        if case.ground_truth.soft is not None:
            raise Skipped("soft matches are passed over")
        queries = [int(step[3]["query"]) for step in _steps(env)[1:]]
        truths = [case.ground_truth[query] for query in queries]
        everywhere = np.arange(len(case.references))
        for right in (True, False):
            chosen = [truth if right else np.setdiff1d(everywhere, truth) for truth in truths]
            actions = [_answer(int(one[0]) if len(one) else -1, k) for one in chosen]
            steps = _steps(env, actions)[1:]
            for query, truth, one, (_, reward, _, info) in zip(queries, truths, chosen, steps, strict=True):
                if not len(one):
                    continue  # there is no such answer
                if reward != float(right):
                    raise Failed(f"{'a right' if right else 'a wrong'} answer to query {query} earns {reward:g}")
                shown = np.asarray(info["truth"])
                if info["query"] != query or not np.array_equal(shown[shown >= 0], truth):
                    raise Failed(f"info tells another truth about query {query} than the protocol")


def _answer(reference: int, k: int) -> dict[str, Any]:
    indices, scores = np.full(k, -1, dtype=np.int64), np.full(k, -np.inf, dtype=np.float32)
    indices[0], scores[0] = reference, 0.0 if reference >= 0 else -np.inf
    return {"indices": indices, "scores": scores}


CHECKS = (episodes_repeat, nothing_told_before, reward_is_truth)
