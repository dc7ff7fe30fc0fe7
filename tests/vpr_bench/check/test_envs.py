from functools import wraps

import numpy as np
import pytest

import vpr_bench  # noqa: F401 - the environments' ids
from vpr_bench.check import Examination
from vpr_bench.check.env import ENV_CHECKS, EnvSubject
from vpr_bench.envs.single import VprEnv
from vpr_bench.errors import UsageError


def results(subject):
    examination = Examination(ENV_CHECKS, subject)
    return {check.id: examination.outcome(check.id) for check in ENV_CHECKS}


def failed(found):
    return {name: one.reason for name, one in found.items() if one.result == "fail"}


def test_what_is_what():
    assert EnvSubject.of("gardens") == EnvSubject("vpr_bench/Gardens-v0")
    assert EnvSubject.of("vpr_bench/Gardens-v0", {"k": 3}) == EnvSubject("vpr_bench/Gardens-v0", {"k": 3})
    assert EnvSubject.of("gardens:simulated").settings == {"dataset": "gardens:simulated"}
    with pytest.raises(UsageError, match="Did you mean 'vpr_bench/Gardens-v0'"):
        EnvSubject.of("vpr_bench/Garden-v0")


@pytest.mark.parametrize("settings", [{}, {"order": "sequential", "k": 3}, {"unmatched": "reject"}])
def test_our_environment(tiny_dataset, settings):
    assert {one.result for one in results(EnvSubject.of("tiny", settings)).values()} == {"pass"}


def change(monkeypatch, name, function):
    plain = getattr(VprEnv, name)

    @wraps(plain)  # Gymnasium looks at the signature
    def changed(self, *arguments, **named):
        return function(plain(self, *arguments, **named))

    monkeypatch.setattr(VprEnv, name, changed)


def test_an_environment_that_tells_which_query_it_is(tiny_dataset, monkeypatch):
    change(monkeypatch, "reset", lambda told: (told[0], {**told[1], "query": 3}))
    reason = "before the first answer, info holds query"
    assert failed(results(EnvSubject.of("tiny"))) == {"nothing-told-before": reason}


def test_an_environment_that_pays_for_everything(tiny_dataset, monkeypatch):
    change(monkeypatch, "step", lambda told: (told[0], 1.0, *told[2:]))
    found = failed(results(EnvSubject.of("tiny")))
    assert list(found) == ["reward-is-truth"]
    assert found["reward-is-truth"].startswith("a wrong answer to query")


def test_an_environment_that_draws_lots(tiny_dataset, monkeypatch):
    change(monkeypatch, "step", lambda told: (told[0] ^ np.random.default_rng().integers(2, dtype=np.uint8), *told[1:]))
    found = failed(results(EnvSubject.of("tiny")))
    assert set(found) <= {"episodes-repeat", "gymnasium-checker"} and found


def test_an_environment_that_gymnasium_does_not_like(tiny_dataset, monkeypatch):
    change(monkeypatch, "reset", lambda told: told[0])
    assert next(iter(failed(results(EnvSubject.of("tiny"))))) == "gymnasium-checker"
