"""Telling pickles from other files."""

import bz2
import gzip
import io
import lzma
import zipfile
import zlib
from collections.abc import Callable

_NPY, _ZIP = b"\x93NUMPY", b"PK\x03\x04"
_UNPACK: dict[bytes, Callable[[bytes], bytes]] = {
    b"\x1f\x8b": gzip.decompress,
    b"BZh": bz2.decompress,
    b"\xfd7zXZ": lzma.decompress,
    b"\x78\x01": zlib.decompress,
    b"\x78\x9c": zlib.decompress,
    b"\x78\xda": zlib.decompress,
}


def is_pickle(content: bytes) -> bool:
    """Say whether a file is a pickle of protocol 2 or later, or holds one: in a zip, compressed, or as object arrays.

    Examples
    --------
    >>> import json, pickle
    >>> is_pickle(pickle.dumps([1])), is_pickle(zlib.compress(pickle.dumps([1]))), is_pickle(json.dumps([1]).encode())
    (True, True, False)
    """
    if content[:1] == b"\x80" and content[1:2] in b"\x02\x03\x04\x05" and content[-1:] == b".":
        return True
    if content.startswith(_NPY):
        return b"|O'" in content[:128]
    if content.startswith(_ZIP):
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            return any(is_pickle(archive.read(name)) for name in archive.namelist())
    for magic, unpack in _UNPACK.items():
        if content.startswith(magic):
            try:
                return is_pickle(unpack(content))
            except (OSError, EOFError, ValueError, zlib.error, lzma.LZMAError):
                return False  # it only begins like one
    return False
