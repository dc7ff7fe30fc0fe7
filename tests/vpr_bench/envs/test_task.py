from pathlib import Path

import numpy as np
import pytest

from vpr_bench.envs.task import DEFAULT_K, Task
from vpr_bench.errors import UsageError
from vpr_bench.method.build import BuiltMethod
from vpr_bench.runner.run import RunOptions, run_key


@pytest.mark.parametrize("seed", [0, 7])
def test_queries_are_asked_in_the_order_of_a_run(make_case, seed):
    case = make_case()
    asked = Task.of(case).questions(np.random.default_rng(seed))
    assert np.array_equal(asked, np.random.default_rng(seed).permutation(len(case.queries)))
    assert Task.of(case, order="sequential").questions(np.random.default_rng(seed)).tolist() == [0, 1, 2, 3, 4]


def test_as_many_places_as_in_a_run(make_case):
    case = make_case()
    built = BuiltMethod("one", "1", {}, None, "one", object())
    assert Task.of(case).k == run_key(case, built, RunOptions()).k == min(DEFAULT_K, len(case.references))


def test_queries_and_map_are_stretched_together(make_case):
    task = Task.of(make_case(sizes=[(6, 8), (9, 5)]), size=(4, 4))
    assert task.frames.shape == (4, 4, 3)
    assert {image.shape for image in task.case.references} == {(4, 4, 3)}


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"k": 0}, "k must lie between 1 and 8"),
        ({"k": 9}, "k must lie between 1 and 8"),
        ({"k": "3"}, "k must lie between 1 and 8"),
        ({"k": True}, "k must lie between 1 and 8"),
        ({"order": "shuffle"}, "Did you mean 'shuffled'?"),
        ({"size": (0, 3)}, "size must be"),
    ],
)
def test_settings_that_are_none(make_case, settings, words):
    with pytest.raises(UsageError, match=words.replace("?", r"\?")):
        Task.of(make_case(), **settings)


@pytest.mark.parametrize("wrong", [{"dataset": Path("walk")}, {"protocol": 3}, {"edition": 3}], ids=str)
def test_names_must_fit_into_a_spec(wrong):
    names = {"dataset": "plain", "protocol": None, "edition": "auto", **wrong}
    with pytest.raises(UsageError, match=f"{next(iter(wrong))} must be text"):
        Task.load(**names, radius=None, unmatched=None, k=None, order="shuffled", size=None, in_memory=False)
