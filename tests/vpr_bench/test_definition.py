import sys

import pytest

from vpr_bench.definition import Definition

BASE = """
raise ImportError("must not be imported")
class Root:
    length: int = 7
    presets: ClassVar[dict[str, dict[str, int]]] = {"long": {"length": 9}}
class Base(Root):
    '''What all share.'''
    metric: str = "cosine"
    index: str = "exact"
"""
METHOD = """
from heavy_base import Base as Parent, Missing
from typing import Protocol
class Method(Parent, Protocol):
    '''One line.

    More.
    '''
    version: ClassVar[str] = "1"
    size: int
    metric: str = "manhattan"
class Generic(Parent[int], Missing, no.such.Thing):
    presets: ClassVar[dict] = {"small": {"size": 2 + 2}}
class Plain(Method):
    def __init__(self, depth=5, *, wide: bool = True): ...
def function(x): "Makes one."
"""


@pytest.fixture(autouse=True)
def _modules(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / "heavy_base.py").write_text(BASE)
    (tmp_path / "heavy_package").mkdir()
    (tmp_path / "heavy_package" / "__init__.py").write_text("raise ImportError")
    (tmp_path / "heavy_package" / "method.py").write_text(METHOD)


def test_inherited_parameters_come_last_and_a_class_overrides_its_base():
    parameters = Definition.find("heavy_package.method:Method").parameters()
    assert list(parameters.items()) == [
        ("size", "required"),
        ("metric", "'manhattan'"),
        ("index", "'exact'"),
        ("length", "7"),
    ]
    assert not {"heavy_base", "heavy_package"} & sys.modules.keys()


def test_a_constructor_says_all():
    assert Definition.find("heavy_package.method:Plain").parameters() == {"depth": "5", "wide": "True"}


def test_a_function_has_no_parameters_to_set():
    function = Definition.find("heavy_package.method:function")
    assert function.summary() == "Makes one." and function.parameters() == {}


def test_constants_are_inherited_and_only_literals_are_read():
    assert Definition.find("heavy_package.method:Method").constant("presets") == {"long": {"length": 9}}
    assert Definition.find("heavy_package.method:Method").constant("version") == "1"
    assert Definition.find("heavy_package.method:Generic").constant("presets") is None
    assert Definition.find("heavy_package.method:Method").constant("nothing") is None


@pytest.mark.parametrize(
    "target", ["", "sys:path", "no_such:Thing", "heavy_package.none:X", "heavy_package.method:None"]
)
def test_what_cannot_be_read_is_none(target):
    assert Definition.find(target) is None


def test_methods_of_a_class_its_own_and_inherited(tmp_path):
    (tmp_path / "clustering.py").write_text(
        "class Base:\n    def cluster(self): ...\nclass Method(Base):\n    def fit(self): ...\ndef made(): ...\n"
    )
    method = Definition.find("clustering:Method")
    assert method.defines("fit") and method.defines("cluster") and not method.defines("match")
    assert not Definition.find("clustering:made").defines("fit")
