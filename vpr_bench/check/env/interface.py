"""Whether it is an environment as Gymnasium has them."""

import warnings

import gymnasium
import numpy as np
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env

from vpr_bench.check.env.subject import EnvSubject
from vpr_bench.check.outcome import Failed
from vpr_bench.check.suite import check
from vpr_bench.dataset.load import DatasetWarning


@check("gymnasium-checker")
def gymnasium_checker(subject: EnvSubject) -> None:
    """Check that Gymnasium's own checker has nothing to say, not even as a warning."""
    with subject.make() as env, warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("default", DatasetWarning)  # about images, not about the environment
        check_env(env.unwrapped)


@check("spec-round-trips")
def spec_round_trips(subject: EnvSubject) -> None:
    """Check that its spec, written as JSON and read again, makes the same environment."""
    with subject.make() as env:
        if env.spec is None:
            raise Failed("it has no spec")
        with gymnasium.make(EnvSpec.from_json(env.spec.to_json())) as again:
            if (env.observation_space, env.action_space) != (again.observation_space, again.action_space):
                raise Failed("made again of its spec, it has other spaces")
            if not np.array_equal(env.reset(seed=0)[0], again.reset(seed=0)[0]):
                raise Failed("made again of its spec, it begins with another observation")


CHECKS = (gymnasium_checker, spec_round_trips)
