"""Telling pickles from other files."""

import bz2
import gzip
import io
import lzma
import zipfile
import zlib
from collections.abc import Callable, Iterator

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
        return b"|O'" in content[12:].partition(b"\n")[0]  # the header is one line after magic, version and length
    try:
        return any(is_pickle(inner) for inner in _inside(content))
    except (OSError, EOFError, ValueError, zipfile.BadZipFile, zlib.error, lzma.LZMAError):
        return False  # it only begins like an archive


def _inside(content: bytes) -> Iterator[bytes]:
    """Yield what is packed in an archive, nothing for other files."""
    if content.startswith(_ZIP):
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            yield from (archive.read(name) for name in archive.namelist())
    for magic, unpack in _UNPACK.items():
        if content.startswith(magic):
            yield unpack(content)
