import numpy as np
import pytest

from vpr_bench.errors import DataError
from vpr_bench.files.atomic import read_arrays, replacing, write_arrays, write_bytes


def test_failure_leaves_the_old_file_and_nothing_else(tmp_path):
    write_bytes(tmp_path / "a", b"old")

    def fail():
        with replacing(tmp_path / "a") as temporary:
            temporary.write_bytes(b"new")
            raise RuntimeError

    with pytest.raises(RuntimeError):
        fail()
    assert [file.name for file in tmp_path.iterdir()] == ["a"]
    assert (tmp_path / "a").read_bytes() == b"old"


def test_same_arrays_same_bytes(tmp_path):
    for name in ("a", "b"):
        write_arrays(tmp_path / name, {"x": np.arange(5), "y": np.ones((2, 2))})
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()


def test_arrays_come_back(tmp_path):
    write_arrays(tmp_path / "a.npz", {"x": np.arange(5), "y": np.ones((2, 2))})
    arrays = read_arrays(tmp_path / "a.npz", "y")
    assert list(arrays) == ["x", "y"]
    assert np.array_equal(arrays["x"], np.arange(5))


def test_missing_array_is_named(tmp_path):
    write_arrays(tmp_path / "a.npz", {"x": np.arange(5)})
    with pytest.raises(DataError, match="no array 'z'"):
        read_arrays(tmp_path / "a.npz", "z")


@pytest.mark.parametrize("content", [None, b"", b"not a zip"])
def test_damaged_file_is_named(tmp_path, content):
    if content is not None:
        (tmp_path / "a.npz").write_bytes(content)
    with pytest.raises(DataError, match=r"a\.npz is missing or damaged"):
        read_arrays(tmp_path / "a.npz")


def test_unwritable_folder(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(DataError, match="in the way"):
        write_bytes(tmp_path / "file" / "a", b"")
