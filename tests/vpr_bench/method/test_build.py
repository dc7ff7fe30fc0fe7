import importlib
import re
import sys
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
import pytest
from pydantic import Field

from vpr_bench.errors import UsageError, VprBenchError
from vpr_bench.method.build import METHODS, build_method
from vpr_bench.registry import Entry
from vpr_bench.types.match import Match

if TYPE_CHECKING:
    from some_package import Thing


class Fitted:
    def fit(self, references): ...

    def match(self, image, k): ...


@dataclass
class Typed(Fitted):
    """A method with a parameter of every kind."""

    count: Annotated[int, Field(ge=1)] = 3
    share: float = 0.5
    fast: bool = False
    kind: Literal["cosine", "l1"] = "cosine"
    limit: int | None = None
    layers: list[int] = field(default_factory=lambda: [1, 2])
    seed: int = 0


@dataclass
class Picky(Fitted):
    size: int

    def __post_init__(self):
        if self.size % 2:
            raise ValueError(f"size must be even. Got {self.size} instead.")


class Plain(Fitted):
    """As a third party may write it: no annotations, and nothing stored under the parameter's name."""

    def __init__(self, depth=5, *others, **more):
        self._depth = depth


class Hinted(Fitted):
    def __init__(self, thing: "Thing" = None, image: np.dtype | None = None, other: Fitted | None = None):
        self.thing, self.image, self.other = thing, image, other


class MeanColour:
    """Mean RGB with cosine similarity."""

    def fit(self, references):
        self.database_ = np.stack([self._describe(image) for image in references])

    def match(self, image, k):
        return Match.from_scores(self.database_ @ self._describe(image), k)

    def _describe(self, image):
        return image.mean(axis=(0, 1), dtype=np.float32)


class Free(Fitted):
    def __init__(self, size=3, name="x", anything=None):
        self.size = size


class Half:
    def fit(self, references): ...


@pytest.fixture(autouse=True)
def _registered(monkeypatch):
    """Register the methods of this file by their names in lower case."""
    ours = {cls.__name__.lower(): cls for cls in (Typed, Picky, Plain, Hinted, MeanColour, Free, Half)}
    entries = {name: [Entry(name, f"plugins_of_this_test:{cls.__name__}", "test 1.0")] for name, cls in ours.items()}
    module = type(sys)("plugins_of_this_test")
    vars(module).update({cls.__name__: cls for cls in ours.values()})
    monkeypatch.setitem(sys.modules, "plugins_of_this_test", module)
    monkeypatch.setitem(vars(METHODS), "_found", {**METHODS._found, **entries})


def test_strings_are_converted_to_the_annotated_types():
    given = {"count": "7", "share": "1e-3", "fast": "true", "kind": "l1", "limit": "4"}
    method = build_method("typed", given).method
    assert (method.count, method.share, method.fast, method.kind, method.limit) == (7, 0.001, True, "l1", 4)
    assert [type(getattr(method, name)) for name in given] == [int, float, bool, str, int]


def test_values_of_the_right_type_stay_as_they_are():
    method = build_method("typed", {"count": 7, "limit": None, "layers": [5]}).method
    assert (method.count, method.limit, method.layers) == (7, None, [5])


def test_all_parameters_are_in_the_result_and_only_the_changed_ones_in_the_label():
    built = build_method("typed", {"share": "0.5", "count": "7"}, seed=4)
    assert built.parameters == {
        "count": 7,
        "share": 0.5,
        "fast": False,
        "kind": "cosine",
        "limit": None,
        "layers": [1, 2],
        "seed": 4,
    }
    assert built.label == "typed(count=7)"
    assert build_method("typed").label == "typed"
    assert build_method("typed", {"layers": [9]}).label == "typed(layers=[9])"


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ({"count": "0"}, "'count' of 'typed': .*greater than or equal to 1. Got '0' instead"),
        ({"count": -3}, "'count' of 'typed': .*greater than or equal to 1. Got -3 instead"),
        ({"count": "2.5"}, "'count' of 'typed': .*integer.*Got '2.5' instead"),
        ({"share": "half"}, "'share' of 'typed': .*number.*Got 'half' instead"),
        ({"fast": "perhaps"}, "'fast' of 'typed': .*boolean.*Got 'perhaps' instead"),
        ({"kind": "l2"}, "'kind' of 'typed': .*'cosine' or 'l1'. Got 'l2' instead"),
        ({"limit": "none"}, "'limit' of 'typed': .*Got 'none' instead"),
        ({"cout": 7}, "The method 'typed' has no parameter 'cout'. Did you mean 'count'?"),
        ({"xyz": 7}, "no parameter 'xyz'. Known: count, fast, kind, layers, limit, seed, share."),
    ],
)
def test_a_wrong_parameter_says_what_it_got(parameters, message):
    with pytest.raises(UsageError, match=message) as caught:
        build_method("typed", parameters)
    assert str(caught.value).count("\n") <= 1


def test_what_the_method_itself_refuses_is_passed_on():
    with pytest.raises(UsageError, match=r"'picky' refuses its parameters: size must be even. Got 3 instead"):
        build_method("picky", {"size": "3"})
    with pytest.raises(UsageError, match=r"'picky' refuses its parameters: .*missing.*'size'"):
        build_method("picky")


def test_a_required_parameter_is_always_in_the_label():
    assert build_method("picky", {"size": 4}).label == "picky(size=4)"


def test_the_seed_goes_to_methods_that_have_one_and_is_not_in_the_label():
    built = build_method("typed", seed=5)
    assert built.method.seed == 5 and built.label == "typed"
    assert build_method("typed", {"seed": "6"}, seed=5).method.seed == 6
    assert "seed" not in build_method("meancolour", seed=5).parameters


def test_a_class_without_annotations_is_built_and_described():
    built = build_method("plain", {"depth": 7})
    assert built.method._depth == 7
    assert built.parameters == {"depth": 7} and built.label == "plain(depth=7)"


def test_a_default_that_is_not_stored_is_in_the_result_all_the_same():
    built = build_method("plain")
    assert built.parameters == {"depth": 5} and built.label == "plain"


def test_parameters_that_a_class_collects_cannot_be_set_by_name():
    with pytest.raises(UsageError, match="no parameter 'more'"):
        build_method("plain", {"more": 1})


def test_hints_that_mean_nothing_at_run_time_are_passed_by():
    assert build_method("hinted", {"thing": "x", "image": "uint8", "other": "y"}).method.thing == "x"


def test_the_smallest_third_party_class_is_a_method():
    built = build_method("meancolour")
    built.method.fit([np.full((2, 2, 3), level, np.uint8) for level in (10, 200)])
    assert built.method.match(np.full((2, 2, 3), 200, np.uint8), 1).indices.tolist() == [1]
    assert built.weights is None and built.parameters == {}


@pytest.mark.parametrize("name", ["half", "math:pi", "math:sqrt"])
def test_what_cannot_fit_and_match_is_no_method(name):
    with pytest.raises(UsageError, match=f"'{name}' is not a method: .* must be a class with fit and match"):
        build_method(name)


def test_an_unknown_method_suggests_the_closest():
    with pytest.raises(UsageError, match=r"There is no method 'twostag'. Did you mean 'twostage\'\?"):
        build_method("twostag")


def test_the_version_is_the_declared_one_or_that_of_the_source(monkeypatch):
    assert re.fullmatch(r"source:[0-9a-f]{16}", build_method("typed").version)
    monkeypatch.setattr(Typed, "version", "7", raising=False)
    assert build_method("typed").version == "7"


def test_edited_code_has_another_version(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    path = tmp_path / "edited_method.py"
    versions = []
    for answer in ("1", "2", "1"):
        path.write_text(f"class Edited:\n    def fit(self, r): ...\n    def match(self, i, k): return {answer}\n")
        importlib.invalidate_caches()
        sys.modules.pop("edited_method", None)
        built = build_method("edited_method:Edited")
        assert built.id == "edited_method:Edited"
        versions.append(built.version)
    sys.modules.pop("edited_method", None)
    assert versions[0] == versions[2] != versions[1]


def test_a_class_that_has_no_source_file_is_known_by_its_package(monkeypatch):
    monkeypatch.setattr(Typed, "__module__", "plugins_of_this_test")
    assert build_method("typed").version == "test 1.0"


@pytest.mark.parametrize("name", ["hog", "twostage"])
def test_our_own_methods_are_built_from_strings(name):
    built = build_method(name, seed=3)
    assert built.id == built.label == name
    text = {key: str(value) for key, value in built.parameters.items() if value is not None}
    assert build_method(name, text).parameters == built.parameters


def test_the_pre_trained_weights_are_in_the_result():
    built = build_method("twostage")
    assert re.fullmatch(r"efficientnet-lite0 \(ImageNet\) sha256:57934424[0-9a-f]{56}", built.weights)
    assert build_method("hog").weights is None


@pytest.mark.parametrize(
    "parameters",
    [
        {"n_components": "0"},
        {"answers_per_component": "-1"},
        {"whitening": "1.5"},
        {"threshold": "nan"},
        {"n_clusters": "0"},
        {"width": "31"},
        {"penalty": "0"},
        {"seed": "-1"},
        {"backbone": "resnet"},
    ],
    ids=str,
)
def test_the_two_stage_system_refuses_what_it_cannot_use(parameters):
    with pytest.raises(UsageError, match=f"Got '{next(iter(parameters.values()))}' instead"):
        build_method("twostage", parameters)


@pytest.mark.parametrize("value", [float("nan"), np.float32(2), {1, 2}])
def test_a_value_that_cannot_be_written_into_a_result_is_refused(value):
    with pytest.raises(UsageError, match="'anything' of 'free' cannot stand in a result"):
        build_method("free", {"anything": value})


def test_without_a_hint_the_default_tells_the_type():
    parameters = {"size": "5", "name": "7", "anything": "null"}
    assert build_method("free", parameters).parameters == {"size": 5, "name": "7", "anything": "null"}
    with pytest.raises(UsageError, match="Got 'many' instead"):
        build_method("free", {"size": "many"})


def test_a_constructor_may_raise_anything(monkeypatch):
    def fail(self, size=3, name="x", anything=None):
        raise KeyError("gone")

    monkeypatch.setattr(Free, "__init__", fail)
    with pytest.raises(VprBenchError, match="'free' cannot be made: KeyError: 'gone'"):
        build_method("free")


def test_edited_helpers_make_another_version(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    package = tmp_path / "helped"
    package.mkdir()
    (package / "__init__.py").touch()
    (package / "method.py").write_text("class M:\n    def fit(self, r): ...\n    def match(self, i, k): ...\n")
    (package / "helper.py").write_text("x = 1\n")
    first = build_method("helped.method:M").version
    (package / "helper.py").write_text("x = 2\n")
    assert build_method("helped.method:M").version != first
