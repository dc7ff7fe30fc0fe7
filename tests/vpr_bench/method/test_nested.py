import json
import sys
from dataclasses import dataclass
from types import ModuleType

import numpy as np
import pytest

from vpr_bench.errors import UsageError
from vpr_bench.method.build import METHODS, build_method, method_parameters
from vpr_bench.method.interfaces import Method
from vpr_bench.registry import Entry


class Fitted:
    version = "3"

    def fit(self, references): ...

    def match(self, image, k): ...


@dataclass
class Inner(Fitted):
    size: int = 8
    seed: int = 0

    def weights_digest(self):
        return f"inner sha256:{self.size}"


@dataclass
class Bare(Fitted):
    pass


@dataclass
class Outer(Fitted):
    inner: Method | str = "inner"
    past: int = 10
    seed: int = 0


@dataclass
class Strict(Fitted):
    inner: Method


@pytest.fixture(autouse=True)
def _registered(monkeypatch):
    ours = {cls.__name__.lower(): cls for cls in (Inner, Bare, Outer, Strict)}
    module = ModuleType("nested_of_this_test")
    vars(module).update({cls.__name__: cls for cls in ours.values()})
    monkeypatch.setitem(sys.modules, "nested_of_this_test", module)
    entries = {name: [Entry(name, f"nested_of_this_test:{cls.__name__}", "test 1.0")] for name, cls in ours.items()}
    monkeypatch.setitem(vars(METHODS), "_found", {**METHODS._found, **entries})


def test_a_method_inside_is_made_by_its_name_with_parameters_of_its_own():
    built = build_method("outer", {"inner": "inner", "inner.size": "16", "past": "4"}, seed=7)
    assert built.method == Outer(Inner(16, 7), 4, 7)
    assert built.label == "outer(inner=inner(size=16), past=4)"


def test_the_result_says_everything_about_it():
    built = build_method("outer", {"inner.size": 16}, seed=7)
    assert built.parameters == {
        "inner": {
            "method": "inner",
            "version": "3",
            "parameters": {"size": 16, "seed": 7},
            "weights": "inner sha256:16",
        },
        "past": 10,
        "seed": 7,
    }
    assert built.weights == "inner sha256:16"
    assert build_method("outer", {"inner": "bare"}).weights is None


def test_it_is_in_the_label_even_by_default():
    assert build_method("outer").label == "outer(inner=inner)"


def test_it_is_built_again_from_what_stands_in_the_result():
    built = build_method("outer", {"inner.size": 16, "past": 3}, seed=7)
    again = build_method("outer", json.loads(json.dumps(built.parameters)))
    assert (again.method, again.parameters) == (built.method, built.parameters)
    text = {"inner": json.dumps(built.parameters["inner"]), "inner.size": "4"}
    assert build_method("outer", text).method.inner == Inner(4, 7)


def test_it_may_hold_one_itself():
    built = build_method("outer", {"inner": "outer", "inner.inner": "bare", "inner.past": 1})
    assert built.method == Outer(Outer(Bare(), 1), 10)
    assert built.label == "outer(inner=outer(inner=bare, past=1))"


def test_presets_can_be_inside(monkeypatch):
    monkeypatch.setattr(Inner, "presets", {"large": {"size": 64}}, raising=False)
    built = build_method("outer", {"inner": "inner:large"})
    assert (built.method.inner.size, built.label) == (64, "outer(inner=inner:large)")


def test_a_method_inside_may_be_required():
    assert build_method("strict", {"inner": "bare"}).method == Strict(Bare())
    with pytest.raises(UsageError, match="'inner' must be the name of a method"):
        build_method("strict")


@pytest.mark.parametrize(
    ("parameters", "said"),
    [
        ({"inner": "iner"}, "There is no method 'iner'. Did you mean 'inner'?"),
        ({"inner.sise": 3}, "The method 'inner' has no parameter 'sise'. Did you mean 'size'?"),
        ({"inner.size": "wide"}, "The parameter 'size' of 'inner': .*Got 'wide' instead"),
        ({"past.size": 3}, "The method 'outer' has no parameter 'past.size'"),
        ({"inner": 3}, "'inner' must be the name of a method. Got 3 instead"),
        ({"inner": Inner()}, "'inner' must be the name of a method. Got Inner"),
        ({"inner": '{"size": 3}'}, "'inner' must be the name of a method"),
        ({"inner": "{size"}, "There is no method '{size'"),
    ],
)
def test_what_is_wrong_inside_is_said(parameters, said):
    with pytest.raises(UsageError, match=said):
        build_method("outer", parameters)


def test_the_parameters_of_a_method_are_its_own():
    assert method_parameters("outer") == ["inner", "past", "seed"]


def test_plain_methods_are_built_as_ever():
    assert isinstance(build_method("inner").method, Inner)
    assert np.int64(build_method("inner", {"size": np.int64(3)}).method.size) == 3
