import pytest

from vpr_bench.dataset.folders import cache_root, data_root
from vpr_bench.errors import DataError


def test_the_variable_names_the_data_root(tmp_path, monkeypatch):
    monkeypatch.setenv("VPR_BENCH_DATA", str(tmp_path))
    assert data_root() == tmp_path
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("VPR_BENCH_DATA", ".")
    assert data_root() == tmp_path


def test_the_home_folder_may_be_a_tilde(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    monkeypatch.setenv("VPR_BENCH_DATA", "~")
    assert data_root() == tmp_path


@pytest.mark.parametrize("name", ["missing", "file"])
def test_a_variable_that_names_no_folder_is_a_data_error(tmp_path, monkeypatch, name):
    (tmp_path / "file").write_text("x")
    monkeypatch.setenv("VPR_BENCH_DATA", str(tmp_path / name))
    with pytest.raises(DataError, match=rf"VPR_BENCH_DATA names .*{name}, which is not a folder. Create it or unset"):
        data_root()


@pytest.mark.parametrize("value", [None, ""])
def test_otherwise_it_is_the_users_data_folder(tmp_path, monkeypatch, value):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.delenv("VPR_BENCH_DATA", raising=False)
    if value is not None:
        monkeypatch.setenv("VPR_BENCH_DATA", value)
    assert data_root() == tmp_path / "vpr-bench"
    assert not data_root().exists()  # asking makes nothing


def test_the_cache_is_the_users_cache_folder(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache_root() == tmp_path / "vpr-bench"


def test_the_tests_stay_out_of_the_users_folders(tmp_path_factory):
    ours = tmp_path_factory.getbasetemp()
    assert ours in cache_root().parents and ours in data_root().parents
