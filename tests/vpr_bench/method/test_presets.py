import json
import sys
from dataclasses import dataclass
from typing import ClassVar

import pytest

from vpr_bench.errors import UsageError
from vpr_bench.method.build import METHODS, build_method, find_method
from vpr_bench.method.presets import written_presets
from vpr_bench.registry import Entry


@dataclass
class Sized:
    """A method with presets."""

    presets: ClassVar = {"small": {"size": 2, "kind": "plain"}, "seeded": {"seed": 9}, "wrong": {"sise": 3}}

    size: int = 5
    kind: str = "fancy"
    seed: int = 0

    def fit(self, references): ...

    def match(self, image, k): ...


class Crooked(Sized):
    presets: ClassVar = ["small"]


@pytest.fixture(autouse=True)
def _registered(monkeypatch):
    module = type(sys)("plugins_of_this_test")
    vars(module).update(Sized=Sized, Crooked=Crooked)
    monkeypatch.setitem(sys.modules, "plugins_of_this_test", module)
    entries = {name: [Entry(name, f"plugins_of_this_test:{name.title()}", "test 1.0")] for name in ("sized", "crooked")}
    monkeypatch.setitem(vars(METHODS), "_found", {**METHODS._found, **entries})


def test_a_preset_sets_its_parameters_and_stands_in_the_id():
    built = build_method("sized:small", seed=4)
    assert (built.method.size, built.method.kind, built.method.seed) == (2, "plain", 4)
    assert built.id == built.label == "sized:small"
    assert built.parameters == {"size": 2, "kind": "plain", "seed": 4}


def test_the_label_names_what_differs_from_the_preset():
    assert build_method("sized:small", {"size": "7"}).label == "sized:small(size=7)"
    assert build_method("sized:small", {"kind": "fancy"}).label == "sized:small(kind=fancy)"
    assert build_method("sized:small", {"size": "2"}).label == "sized:small"
    assert build_method("sized", {"size": "2", "kind": "plain"}).label == "sized(size=2, kind=plain)"


def test_a_seed_in_a_preset_is_not_the_runs():
    assert build_method("sized:seeded", seed=4).method.seed == 9


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("sized:smal", "The method 'sized' has no preset 'smal'. Did you mean 'small'"),
        ("sized:", "The method 'sized' has no preset ''. Known: seeded, small, wrong"),
        ("twostage:thesys", "The method 'twostage' has no preset 'thesys'"),
        ("crooked:small", "The presets of 'crooked' must be a dict of dicts"),
        ("sized:wrong", "The method 'sized:wrong' has no parameter 'sise'. Did you mean 'size'"),
    ],
)
def test_a_wrong_preset_is_a_usage_error(name, message):
    with pytest.raises(UsageError, match=message):
        build_method(name)


def test_a_class_of_a_module_is_still_a_method():
    assert build_method("plugins_of_this_test:Sized", {"size": 3}).label == "plugins_of_this_test:Sized(size=3)"
    assert find_method("plugins_of_this_test:Sized")[1] is None


def test_what_was_built_is_built_again_from_its_result():
    built = build_method("hog:thesis", {"bins": "8"})
    again = build_method(built.id, built.parameters)
    assert (
        (again.label, again.parameters) == (built.label, built.parameters) == ("hog:thesis(bins=8)", built.parameters)
    )


@pytest.mark.parametrize("name", [entry.name for entry in METHODS.entries()])
def test_our_presets_are_read_from_the_source_as_they_are(name):
    entry = METHODS.entry(name)
    presets = getattr(entry.load(), "presets", {})
    assert written_presets(entry) == presets
    json.dumps(presets)
    for preset, parameters in presets.items():
        called = f"{name}:{preset}"
        if "weights" in parameters:  # which may not be here
            assert build_method(called, {"weights": "random"}).label == f"{called}(weights=random)"
        else:
            assert build_method(called).label == called
