import base64
import io
import os
import pickle
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import DataError
from vpr_bench.files.restricted_pickle import read_object_array


def table(rows, make=lambda row: row):
    """An (n, 2) object array of [number, references], as VPR-Bench writes it."""
    array = np.empty((len(rows), 2), dtype=object)
    for number, row in enumerate(rows):
        array[number, 0], array[number, 1] = number, make(row)
    return array


def plain(value):
    """The same in lists, whatever arrays are in it."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    return [plain(one) for one in value] if isinstance(value, list | tuple) else value


def with_header(content, shape=(3, 2)):
    """An .npy of objects whose pickle is this one."""
    stream = io.BytesIO()
    np.lib.format.write_array_header_1_0(stream, {"descr": "|O", "fortran_order": False, "shape": shape})
    return stream.getvalue() + content


@pytest.fixture
def file(tmp_path):
    return tmp_path / "ground_truth_new.npy"


def refused(file, content):
    """The one-line message with which a file of this content is refused."""
    file.write_bytes(content)
    with pytest.raises(DataError) as raised:
        read_object_array(file)
    message = str(raised.value)
    assert str(file) in message and "\n" not in message and len(message) < 600
    return message


ROWS = [[0, 1], [-1], [7, 200]]


@pytest.mark.parametrize("make", [list, tuple, np.array, lambda row: np.array(row, dtype=">i4")])
@pytest.mark.parametrize("protocol", range(5))
def test_what_this_python_writes(file, make, protocol):
    file.write_bytes(with_header(pickle.dumps(table(ROWS, make), protocol)))
    read = read_object_array(file)
    assert read.shape == (3, 2) and read.dtype == object and type(read) is np.ndarray
    assert plain(read) == plain(table(ROWS, list))


@given(st.lists(st.lists(st.integers(-(2**70), 2**70), max_size=4), max_size=6), st.booleans())
def test_any_lists_come_back(tmp_path_factory, rows, fortran):
    file = tmp_path_factory.getbasetemp() / "any.npy"
    array = table(rows)
    np.save(file, np.asfortranarray(array) if fortran else array)
    assert plain(read_object_array(file)) == plain(array)


# Written by Python 2.7 with NumPy 1.16, packed.
LISTS_OF_PYTHON_2 = (
    "eNqdirFOwzAURW2nUPBXeLORogywoC5sHfpEipAyMESV4zxEpTaJX5xKEUViAcTMT/WvStryBdzhSvfc85Nm9w9PnG3Yqy6xdaQnSm/nOlb6ua"
    "ZAtlrUVOIBT+2qxYG3L7bBYZubWF1fxepN/T/yXbiqWzd94mrCZN2twtIS2V4uCF1dtYE6F6TnJ0tW5en1AthHxouvRx8Z4BCB+PxTytA3KP0o"
    "E/NbYMAH5cxAlPFtmqaz/ZBjwV0ovnN/boDlfmwOJgLP/cXxtSByf2lgDDvEUCS/wKZXSw=="
)
ARRAYS_OF_PYTHON_2 = (
    "eNqdjs1KxDAUhZNUnTG68BGyS4TShW5EBHcuDHZkIAsXZUjTSAc6bZOmQnEENzMya1/Kt9L+ibhw41ncyz3343DeQ3F3/wDBE3imia6UpZeErm"
    "fUJ/SxsM7KfFHYRHf2jcwq3fpVKkvd3uzcJ2enPnkh/xd+RSqvV2UTqMLqYFVnbimtlQ1eWK2KvHK2Vg4bOFA4T4avQRxsBIzf5sZjHHKPo+2I"
    "JK4pNTZ7As0uOOCwRfYZ9wRch2F4+9mqH/zaxbvIHDAOIjNhHak5jMy0/8o/WlVKZtJic5i2+cvvfNznX/3OBy4WUwQGbefmKIXpT+vjrjXapH"
    "gnTiYj9DFuF2sXB1/oVXjB"
)
ARRAYS_AS_TEXT_OF_PYTHON_2 = (
    "eNqdUMFKw0AQrdf5itw2Qg27mzZJxbOQg6kYPAiFstmssZAmy2YrLdav8Ied3YaChyoYmGTy3ryZN/NVPD88vlxN3icfpFaDNOQ2IMclmQbktT"
    "fWiG7dm1o5+F60g0J8eBNa4X8YTwN+PQ0+g/8/ILvdVh8i2RsVbXet3QhjxAHWRsm+G6zZSQuaQniqg64+8ZpBmFOwmkNJKgI6xnwGT3qOuONi"
    "yDlCyTgAanvQCnQKYUmWGQoyQD2WWr1AGaNeU5IjUoxBURT5DQMfievNOFQ5xapWs9hJhctmPsMuwr8cNPciIS4sNkjRCoMzEggb72bj3LD0bI"
    "dlzs9i9HOHJKc//Pi1GVQlWe0px6CXwmndFXiMLfkMRIMLNOfTzaFxq/HEsel4OF+fQYMO3L5+SPrbkNVeZn+ZWGDTmEIl8IPOo28uEaIl"
)


@pytest.mark.parametrize("packed", [LISTS_OF_PYTHON_2, ARRAYS_OF_PYTHON_2, ARRAYS_AS_TEXT_OF_PYTHON_2])
def test_what_python_2_wrote(file, packed):
    file.write_bytes(zlib.decompress(base64.b64decode(packed)))
    assert plain(read_object_array(file)) == plain(table(ROWS))


@pytest.mark.parametrize("array", [np.arange(6).reshape(3, 2), np.eye(3), np.zeros((0, 2), bool)])
def test_plain_numbers_are_read_too(file, array):
    np.save(file, array)
    assert np.array_equal(read_object_array(file), array)


class Calls:
    """Pickles as a call."""

    def __init__(self, function, *arguments):
        self.call = function, arguments

    def __reduce__(self):
        return self.call


@pytest.mark.parametrize("protocol", range(6))
@pytest.mark.parametrize(
    ("function", "arguments", "name"),
    [
        (os.system, ("touch {}",), f"{os.system.__module__}.system"),
        (eval, ("open('{}', 'w')",), "eval"),
        (exec, ("open('{}', 'w')",), "exec"),
        (subprocess.Popen, (["touch", "{}"],), ".Popen"),
        (np.load, ("{}",), "numpy.load"),
        (getattr, ("text", "join"), "getattr"),
        (np.frombuffer, (b"x" * 8,), "frombuffer"),
    ],
)
def test_a_call_is_refused_by_name_and_not_made(file, tmp_path, function, arguments, name, protocol):
    trace = tmp_path / "trace"
    written = [[part.format(trace) for part in one] if isinstance(one, list) else one for one in arguments]
    written = [one.format(trace) if isinstance(one, str) else one for one in written]
    array = table([[1], [2], Calls(function, *written)])
    message = refused(file, with_header(pickle.dumps(array, protocol)))
    assert name in message and "Nothing of it was run" in message
    assert not trace.exists()


def test_an_object_of_some_class_is_refused_by_its_name(file):
    assert "pathlib.PosixPath" in refused(file, with_header(pickle.dumps(table([Path("x")] * 3)))) or os.name == "nt"
    assert "collections.OrderedDict" in refused(file, with_header(b"ccollections\nOrderedDict\n(tR."))
    assert "os.system" in refused(file, with_header(b"(S'true'\nios\nsystem\n."))


@pytest.mark.parametrize("name", ["dtype.type", "ndarray.__new__", "core.multiarray._reconstruct.__globals__"])
def test_no_name_leads_on_from_an_allowed_one(file, name):
    content = b"\x80\x04" + pickle.dumps("numpy", 4)[2:-1] + pickle.dumps(name, 4)[2:-1] + b"\x93."
    assert f"numpy.{name}" in refused(file, with_header(content))


def test_what_may_be_called_cannot_be_changed(file):
    changes = b"cnumpy\ndtype\n(N(lt" + b"b."
    assert "changing what it may call" in refused(file, with_header(changes))
    np.save(file, table(ROWS))
    assert plain(read_object_array(file)) == plain(table(ROWS))


RECONSTRUCT = b"cnumpy.core.multiarray\n_reconstruct\n(cnumpy\nndarray\n(I0\ntS'b'\ntR"
INT64 = b"cnumpy\ndtype\n(S'i8'\nI0\nI1\ntR(I3\nS'<'\nNNNI-1\nI-1\nI0\ntb"


def array_of(state):
    return with_header(RECONSTRUCT + state + b"b.", (1,))


def test_a_type_that_would_make_numpy_read_foreign_memory_is_refused(file):
    fields = b"cnumpy\ndtype\n(S'V8'\nI0\nI1\ntR"
    assert "the numpy type 'V8'" in refused(file, array_of(b"(I1\n(I1\nt" + fields + b"I00\nS'12345678'\nt"))
    subarray = b"cnumpy\ndtype\n(S'i8'\nI0\nI1\ntR(I3\nS'<'\n(I9\ntNNI-1\nI-1\nI0\ntb"
    assert "the numpy type i8" in refused(file, array_of(b"(I1\n(I1\nt" + subarray + b"I00\nS'12345678'\nt"))


@pytest.mark.parametrize("shape", [b"(I1000000000000\nt", b"(I-1\nt", b"(I2\nt", b"(F1.0\nt", b"N"])
def test_an_array_that_promises_more_than_it_holds_is_damaged(file, shape):
    assert "is damaged" in refused(file, array_of(b"(I1\n" + shape + INT64 + b"I00\nS'12345678'\nt"))
    objects = b"cnumpy\ndtype\n(S'O8'\nI0\nI1\ntR"
    assert "is damaged" in refused(file, array_of(b"(I1\n" + shape + objects + b"I00\n(lt"))


def test_scalars_are_numbers_and_nothing_else(file):
    file.write_bytes(with_header(pickle.dumps(table([[np.int64(5)], [np.float32(2)], [np.uint8(1)]], tuple), 2)))
    assert plain(read_object_array(file)) == [[0, [5]], [1, [2.0]], [2, [1]]]
    objects = b"cnumpy.core.multiarray\nscalar\n(cnumpy\ndtype\n(S'O8'\nI0\nI1\ntRS'12345678'\ntR."
    assert "a scalar that is an object" in refused(file, with_header(objects))


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"\x80\x05\x96" + struct.pack("<Q", 2**60) + b".", "BYTEARRAY8"),
        (b"}.", "EMPTY_DICT"),
        (b"\x8f.", "EMPTY_SET"),
        (b"P0\n.", "PERSID"),
        (b"\x82\x01.", "EXT1"),
        (b"\x8e" + struct.pack("<Q", 2**62) + b".", "damaged"),
        (b"\x95" + struct.pack("<Q", 2**62) + b".", "damaged"),
        (b"T\xff\xff\xff\x7fab.", "damaged"),
        (b"I" + b"9" * 100_000 + b"\n.", "damaged"),
        (b"]" * 300_000 + b"a" * 299_999 + b".", "holds another"),
        (b"]2a.", "DUP"),
        (b"(" * 1000, "damaged"),
        (b"", "damaged"),
        (b"\xff\xfe", "damaged"),
        (b"N.", "holds another"),
    ],
)
def test_odd_pickles_are_refused(file, content, words):
    assert words in refused(file, with_header(content))


def test_a_huge_number_in_the_memo_costs_no_memory(file):
    # The reader that is written in C would reserve two pointers for each number below it: 64 GB.
    limited = (
        "import resource, sys; resource.setrlimit(resource.RLIMIT_AS, (4 * 10**9,) * 2);"
        "from pathlib import Path; from vpr_bench.files.restricted_pickle import read_object_array;"
        "print(read_object_array(Path(sys.argv[1])).tolist())"
    )
    content = pickle.dumps(table(ROWS), 2)
    file.write_bytes(with_header(content[:-1] + b"r\xff\xff\xff\xff."))
    done = subprocess.run([sys.executable, "-c", limited, str(file)], capture_output=True, text=True, check=False)
    assert done.stdout.strip() == str(plain(table(ROWS))), done.stderr


def test_sharing_makes_no_bomb(file):
    # One string of a megabyte, and a hundred arrays of it.
    shared = b"T" + struct.pack("<i", 8 * 125_000) + b"x" * 1_000_000 + b"p1\n"
    one = RECONSTRUCT + b"(I1\n(I125000\nt" + INT64 + b"I00\ng1\ntb"
    content = b"(" + shared + one * 100 + b"l."
    assert "more of its content than the content is" in refused(file, with_header(content))


def test_a_list_in_itself_does_no_harm(file):
    array = table([[], [], []])
    array[0, 1].append(array[0, 1])
    np.save(file, array)
    read = read_object_array(file)
    assert read[0, 1][0] is read[0, 1]


@pytest.mark.parametrize(
    "header",
    [
        b"{'descr': '|O', 'fortran_order': False, 'shape': (-1, 2), }",
        b"{'descr': [('a', '|O')], 'fortran_order': False, 'shape': (1,), }",
        b"{'descr': '<i8', 'fortran_order': False, 'shape': (1000000000000,), }",
        b"{'descr': '<i8', 'fortran_order': False, 'shape': (0, 1000000000000), }",
        b"{'descr': '<M8[s]', 'fortran_order': False, 'shape': (1,), }",
        b"{'descr': '|V0', 'fortran_order': False, 'shape': (1000000000000,), }",
        b"{'descr': '<i8'}",
        b"(" * 5000,
        b"__import__('os').getcwd()",
    ],
)
def test_odd_headers_are_refused(file, header):
    refused(file, b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header) + 1) + header + b"\n" + b"x" * 8)


def test_other_files_are_refused(file, tmp_path):
    assert "is no .npy file" in refused(file, b"")
    assert "is no .npy file" in refused(file, b"\x93NUMPY\x03\x00" + b"x" * 20)
    assert "is no .npy file" in refused(file, pickle.dumps([1]))
    for missing in (tmp_path / "none.npy", tmp_path):
        with pytest.raises(DataError, match="is missing"):
            read_object_array(missing)


def test_a_file_that_is_too_large_is_not_read(file):
    np.save(file, np.zeros(1000))
    with pytest.raises(DataError, match=r"it has more than 1\.0 kB"):
        read_object_array(file, limit=1000)
