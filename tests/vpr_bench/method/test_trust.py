import pytest

from vpr_bench.errors import UsageError
from vpr_bench.method.build import build_method
from vpr_bench.method.trust import UntrustedError, registered_only

MINE = """
open("ran", "w").close()

class Mine:
    version = "1"

    def fit(self, references): ...

    def match(self, image, k): ...
"""


@pytest.fixture
def mine(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text(MINE)
    return tmp_path / "ran"


def test_code_is_not_run_for_its_name_alone(mine):
    for name in ("mine.py:Mine", "os:system", "subprocess:Popen"):
        with registered_only(), pytest.raises(UntrustedError, match="is not installed"):
            build_method(name)
    for inner in ("mine.py:Mine", {"method": "mine.py:Mine", "parameters": {}}, '{"method": "mine.py:Mine"}'):
        with registered_only(), pytest.raises(UntrustedError):
            build_method("seqslam", {"inner": inner})
    assert not mine.exists()


def test_what_is_installed_may_be_named(mine):
    with registered_only():
        assert build_method("seqslam", {"inner": "hog"}).id == "seqslam"
        assert build_method("hog:thesis").id == "hog:thesis"
        with pytest.raises(UsageError, match="Did you mean 'hog'"):
            build_method("hogg")


def test_the_user_may_name_anything(mine):
    with registered_only(["mine.py:Mine"]):
        build_method("mine.py:Mine")
        with pytest.raises(UntrustedError):
            build_method("other.py:Mine")
    build_method("mine.py:Mine")
    assert mine.exists()
