import pickle
import sys

import pytest

from vpr_bench.errors import UsageError
from vpr_bench.importing import import_object


@pytest.fixture(autouse=True)
def _clean(monkeypatch):
    """Forget what a test imports, and where from."""
    monkeypatch.setattr(sys, "path", sys.path.copy())
    before = set(sys.modules)
    yield
    for name in set(sys.modules) - before:
        del sys.modules[name]


@pytest.fixture
def write(tmp_path):
    def write(name, source):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(source, "utf-8")
        return path

    return write


def test_an_object_is_imported_from_a_module_or_a_file(write):
    assert import_object("math:pi", "pi") == import_object(f"{write('mine.py', 'pi = 3.141592653589793')}:pi", "pi")


def test_a_file_can_import_what_lies_beside_it_and_no_installed_module_is_replaced(write):
    write("helper_of_mine.py", "size = 4")
    write("cv2.py", "raise RuntimeError('not the installed one')")
    path = write("mine.py", "import cv2, helper_of_mine\nsize = helper_of_mine.size")
    assert import_object(f"{path}:size", "it") == 4


def test_the_same_file_is_imported_once_and_an_edited_one_again(write):
    path = write("mine.py", "class Mine: pass")
    first = import_object(f"{path}:Mine", "it")
    assert import_object(f"{path}:Mine", "it") is first
    write("mine.py", "class Mine: edited = True")
    assert import_object(f"{path}:Mine", "it").edited


def test_files_of_one_name_do_not_meet(write):
    one, other = write("a/mine.py", "x = 1"), write("b/mine.py", "x = 2")
    assert (import_object(f"{one}:x", "it"), import_object(f"{other}:x", "it")) == (1, 2)


def test_what_a_file_defines_is_found_by_its_module(write):
    path = write("my.own.py", "from dataclasses import dataclass\n@dataclass\nclass Mine:\n    size: int = 3")
    mine = import_object(f"{path}:Mine", "it")
    assert pickle.loads(pickle.dumps(mine(4))) == mine(4)  # noqa: S301


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("import os\n\n1 / 0", "mine.py, line 3: ZeroDivisionError: division by zero"),
        ("import os\nclass Mine(:", "mine.py, line 2: SyntaxError: invalid syntax"),
        ("import no_such_thing", "mine.py, line 1: ModuleNotFoundError: No module named 'no_such_thing'"),
        ("raise SystemExit(0)", "mine.py, line 1: SystemExit: 0"),
        ("import json\njson.loads('{')", "JSONDecodeError"),
        ("class Mien: pass", "there is no 'Mine' in it. Did you mean 'Mien'?"),
        ("from math import pi", "there is no 'Mine' in it. Known: none."),
        ("\0", "SyntaxError: source code string cannot contain null bytes"),
    ],
)
def test_what_is_wrong_with_a_file_is_said_with_the_line(write, source, said):
    path = write("mine.py", source)
    for _ in range(2):  # a module that failed is not kept
        with pytest.raises(UsageError, match=r"The method cannot be loaded from ") as caught:
            import_object(f"{path}:Mine", "The method")
        assert said in str(caught.value) and str(path) in str(caught.value)


def test_a_missing_file_or_a_folder_is_named(tmp_path):
    (tmp_path / "folder.py").mkdir()
    for name in ("gone.py", "folder.py"):
        with pytest.raises(UsageError, match=rf"{name}:Mine: there is no such file"):
            import_object(f"{tmp_path / name}:Mine", "The method")


def test_a_module_that_fails_says_where(write, monkeypatch):
    monkeypatch.syspath_prepend(write("breaks_here.py", "\nraise RuntimeError('no licence')").parent)
    with pytest.raises(UsageError, match=r"breaks_here.py, line 2: RuntimeError: no licence"):
        import_object("breaks_here:Thing", "It")
