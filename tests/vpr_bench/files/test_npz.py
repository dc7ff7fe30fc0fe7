import io
import struct
import zipfile

import numpy as np
import pytest

from vpr_bench.errors import DataError
from vpr_bench.files.npz import array_names, array_shape, read_numbers


@pytest.fixture
def file(tmp_path):
    return tmp_path / "GT.npz"


def archive(file, members, how=zipfile.ZIP_DEFLATED):
    with zipfile.ZipFile(file, "w", how) as written:
        for name, content in members.items():
            written.writestr(name, content)


def npy(array, shape=None, descr=None):
    """An .npy of this content, whatever its header says."""
    stream = io.BytesIO()
    header = {"descr": descr or array.dtype.str, "fortran_order": False, "shape": shape or array.shape}
    np.lib.format.write_array_header_1_0(stream, header)
    return stream.getvalue() + array.tobytes()


def refused(file, name="a"):
    with pytest.raises(DataError) as raised:
        read_numbers(file, name)
    assert str(file) in str(raised.value) and "\n" not in str(raised.value)
    return str(raised.value)


@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
@pytest.mark.parametrize("kind", ["?", "u1", "f4", ">f8", "f2"])
def test_what_numpy_writes(file, save, kind):
    arrays = {"a": np.arange(6).reshape(2, 3).astype(kind), "b": np.asfortranarray(np.eye(4).astype(kind))}
    save(file, **arrays)
    assert array_names(file) == ["a", "b"] and array_shape(file, "a") == (2, 3)
    for name, array in arrays.items():
        read = read_numbers(file, name)
        assert np.array_equal(read, array) and read.dtype == array.dtype


def test_a_bomb_is_refused_before_it_is_unpacked(file):
    # The header is honest about 1 TB, the zip about what it holds.
    archive(file, {"a.npy": npy(np.zeros(9, np.uint8), (10**6, 10**6))})
    assert array_shape(file, "a") == (10**6, 10**6)
    assert "a is (1000000, 1000000) uint8, 1.0 TB" in refused(file)
    archive(file, {"a.npy": npy(np.zeros(20_000_000, np.uint8), (2, 2))})
    assert "and 20.0 MB were expected" in refused(file)


def test_a_zip_that_lies_about_sizes_is_damaged(file):
    archive(file, {"a.npy": npy(np.zeros(1_000_000, np.uint8), (4,))})
    content = bytearray(file.read_bytes())
    honest = struct.pack("<I", 1_000_128)
    assert content.count(honest) == 2
    file.write_bytes(content.replace(honest, struct.pack("<I", 132)))
    assert "is damaged" in refused(file)


@pytest.mark.parametrize("how", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_other_ways_to_pack_are_refused(file, how):
    archive(file, {"a.npy": npy(np.zeros(4))}, how)
    assert "packed in a way that numpy does not write" in refused(file)


def test_no_pickle_is_read(file):
    np.savez(file, a=np.array([[1], "x", None], dtype=object))
    assert "must hold numbers. It holds object" in refused(file) or "is refused" in refused(file)
    np.savez(file, a=np.array(["text"]))
    assert "must hold numbers" in refused(file)


def test_an_array_that_is_missing_is_named(file):
    np.savez(file, b=np.zeros(3))
    assert "holds no array a. Found 'b.npy'" in refused(file)


@pytest.mark.parametrize("content", [b"", b"PK\x05\x06", b"not a zip", b"PK\x03\x04" + b"\0" * 100])
def test_what_is_no_npz_is_damaged(file, content):
    file.write_bytes(content)
    assert "is damaged" in refused(file)
    with pytest.raises(DataError, match="is damaged"):
        array_names(file)


def test_a_damaged_member_is_damaged(file):
    np.savez_compressed(file, a=np.arange(1000))
    content = bytearray(file.read_bytes())
    content[200:220] = bytes(20)
    file.write_bytes(content)
    assert "is damaged" in refused(file)


def test_a_missing_file_is_named(file, tmp_path):
    assert "is missing" in refused(file)
    assert "is missing" in refused(tmp_path)
