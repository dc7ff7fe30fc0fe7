from pathlib import Path

import pytest

from vpr_bench.errors import UsageError
from vpr_bench.method.build import build_method
from vpr_bench.method.rebuild import called, places_of, rebuilding

MINE = """
from vpr_bench.method.interfaces import Method

class Outer:
    version = "1"

    def __init__(self, inner: Method | str = "hog") -> None:
        self.inner = inner

    def fit(self, references): ...

    def match(self, image, k): ...


class Inner(Outer):
    def __init__(self, size: int = 1) -> None:
        self.size = size
"""


@pytest.fixture
def mine(tmp_path, monkeypatch):
    """Return the file of two methods, which is not in the current folder."""
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    file = tmp_path / "methods" / "mine.py"
    file.parent.mkdir()
    file.write_text(MINE)
    return file


@pytest.mark.parametrize("written", ["as parameters", "as in a result"])
def test_methods_are_made_again_by_their_names_in_results(mine, written):
    names = {f"{mine}:{one}": f"mine.py:{one}" for one in ("Outer", "Inner")}
    made = build_method(f"{mine}:Outer", {"inner": f"{mine}:Inner", "inner.size": 5})
    parameters = {"inner": "mine.py:Inner", "inner.size": 5} if written == "as parameters" else made.parameters
    with rebuilding(places_of(names)):
        again = build_method("mine.py:Outer", parameters)
    assert (again.label, again.parameters) == (made.label, made.parameters)


@pytest.mark.parametrize("named", [["Outer"], ["Inner"], []])
def test_each_of_them_has_to_be_named(mine, named):
    places = {f"mine.py:{one}": f"{mine}:{one}" for one in named}
    with pytest.raises(UsageError, match="say where it is with --method"), rebuilding(places):
        build_method("mine.py:Outer", {"inner": "mine.py:Inner"})


def test_what_a_file_names_is_not_what_the_user_named(mine):
    Path("mine.py").write_text("raise SystemExit('was run')")
    with rebuilding({"mine.py:Inner": f"{mine}:Inner"}):
        assert build_method("mine.py:Inner").id == "mine.py:Inner"
    with pytest.raises(UsageError, match="not installed"), rebuilding({"mine.py:Inner": f"{mine}:Inner"}):
        build_method("./mine.py:Inner")


def test_outside_the_block_names_mean_what_they_say(mine):
    with rebuilding({"hog": "sad"}):
        assert build_method("hog").id == "sad"
    assert build_method("hog").id == "hog"


def test_what_methods_are_called_in_results(mine):
    assert called(f"{mine}:Inner") == "mine.py:Inner"
    assert called("hog:thesis") == "hog:thesis"
    with pytest.raises(UsageError, match="no method 'hogg'"):
        called("hogg")


def test_two_of_one_name_are_refused():
    with pytest.raises(UsageError, match=r"'a/m\.py:M' and 'b/m\.py:M' are both called 'm\.py:M'"):
        places_of({"a/m.py:M": "m.py:M", "b/m.py:M": "m.py:M"})
