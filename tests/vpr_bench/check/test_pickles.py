import bz2
import gzip
import io
import json
import lzma
import pickle
import zipfile

import numpy as np
import pytest

from vpr_bench.check.method.pickles import is_pickle

PICKLE = pickle.dumps({"a": 1})


def stored(save, *arguments, **named):
    buffer = io.BytesIO()
    save(buffer, *arguments, **named)
    return buffer.getvalue()


def zipped(content):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr("archive/data.pkl", content)
    return buffer.getvalue()


OBJECTS, NUMBERS = np.array([{}], dtype=object), np.arange(3)


@pytest.mark.parametrize(
    "content",
    [
        *(pickle.dumps([1], protocol) for protocol in (2, 3, 4, 5)),
        gzip.compress(PICKLE),
        bz2.compress(PICKLE),
        lzma.compress(PICKLE),
        zipped(PICKLE),
        stored(np.save, OBJECTS),
        stored(np.savez_compressed, numbers=NUMBERS, objects=OBJECTS),
    ],
    ids=["protocol 2", "3", "4", "5", "gzip", "bz2", "xz", "torch", "npy", "npz"],
)
def test_pickles(content):
    assert is_pickle(content)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\x80",
        json.dumps({"a": 1}).encode(),
        stored(np.save, NUMBERS),
        stored(np.savez, numbers=NUMBERS, words=np.array(["|O'"])),
        gzip.compress(b"text"),
        b"\x1f\x8b no gzip",
        b"\x78\x9c no zlib",
        b"PK\x03\x04 no zip",
    ],
    ids=["empty", "one byte", "json", "npy", "npz", "gzip", "no gzip", "no zlib", "no zip"],
)
def test_other_files(content):
    assert not is_pickle(content)
