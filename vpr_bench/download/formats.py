"""Zip and tar, read as the same kind of thing: entries that can be opened."""

import bz2
import gzip
import lzma
import stat
import struct
import tarfile
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import IO, cast

from vpr_bench.download.members import Member
from vpr_bench.errors import DataError
from vpr_bench.files.disk import disk_errors

_DAMAGE = (
    EOFError,
    NotImplementedError,  # a compression that Python does not know
    OSError,  # only those without errno, from the decompressors, get as far as here
    OverflowError,
    ValueError,
    lzma.LZMAError,
    struct.error,
    tarfile.TarError,
    zipfile.BadZipFile,
    zlib.error,
)
_LARGEST_READ = 16 * 1024 * 1024  # bytes
_ZIP_KINDS = {0: "file", stat.S_IFREG: "file", stat.S_IFDIR: "folder", stat.S_IFLNK: "symbolic link"}


@contextmanager
def open_archive(path: Path) -> Iterator[Iterator[Member]]:
    """Open a zip or tar (plain, gz, bz2, xz) archive, told by its content; give its entries one by one.

    Whatever the formats raise inside the ``with`` block, there and in what the entries' ``open`` returns,
    becomes a :class:`DataError` that calls the archive damaged.
    """
    with disk_errors(path, "read"), path.open("rb") as file:
        start = file.read(512)
    try:
        if start.startswith((b"PK\x03\x04", b"PK\x05\x06")):
            with zipfile.ZipFile(path) as archive:
                yield _zip_members(archive)
        else:
            with _opener(start)(path) as file:
                stream = _Guarded(file)
                with tarfile.open(fileobj=cast(IO[bytes], stream), mode="r:") as tar:
                    yield _tar_members(tar, stream)
    except _DAMAGE as error:
        if isinstance(error, OSError) and error.errno is not None:
            raise
        raise DataError(_explain(path, start, error)) from error


def _explain(path: Path, start: bytes, error: Exception) -> str:
    if start.lstrip().lower().startswith((b"<!doctype html", b"<html")):
        return f"{path.name} is a web page and not an archive. Check the address that it came from."
    return (
        f"{path.name} is damaged, incomplete, or neither a zip nor a tar archive "
        f"({error or type(error).__name__}). Get it again."
    )


def _zip_members(archive: zipfile.ZipFile) -> Iterator[Member]:
    for info in archive.infolist():
        if info.flag_bits & 0x1:
            raise DataError("The archive is encrypted. Decrypt it by hand and put the files in place.")
        kind = _ZIP_KINDS.get(stat.S_IFMT(info.external_attr >> 16), "special file")
        if kind == "file" and info.is_dir():
            kind = "folder"
        # orig_filename is what the archive says; zipfile cuts filename at NUL and changes its separators
        yield Member(info.orig_filename, info.file_size, kind, partial(archive.open, info))


def _tar_members(archive: tarfile.TarFile, stream: "_Guarded") -> Iterator[Member]:
    for info in archive:
        yield Member(info.name, info.size, _tar_kind(info), partial(_open_tar_member, archive, info))
    _check_tar_end(archive.offset, stream)


def _tar_kind(info: tarfile.TarInfo) -> str:
    if info.isreg():
        return "file"
    if info.isdir():
        return "folder"
    return "symbolic link" if info.issym() else "hard link" if info.islnk() else "special file"


def _open_tar_member(archive: tarfile.TarFile, info: tarfile.TarInfo) -> IO[bytes]:
    return cast(IO[bytes], archive.extractfile(info))


def _check_tar_end(offset: int, stream: "_Guarded") -> None:
    """Look for the end mark: tarfile takes a damaged header, or none, for the end of the archive."""
    stream.seek(offset)
    if stream.read(tarfile.BLOCKSIZE) != bytes(tarfile.BLOCKSIZE):
        raise tarfile.ReadError("it ends without an end mark")
    if len(stream.read(_LARGEST_READ)) == _LARGEST_READ:  # padding, and the decompressor's own checksum
        raise tarfile.ReadError("something follows its end")


class _Guarded:
    """A file for tarfile that refuses absurd reads, which a header of a few bytes can make it ask for."""

    def __init__(self, file: IO[bytes]) -> None:
        self.seek = file.seek
        self.tell = file.tell
        self._file = file

    def read(self, size: int) -> bytes:
        if not 0 <= size <= _LARGEST_READ:
            raise tarfile.ReadError(f"a header of {size} bytes")
        return self._file.read(size)


def _opener(start: bytes) -> Callable[[Path], IO[bytes]]:
    """Return what opens and decompresses a file that begins with ``start``."""
    for magic, opener in ((b"\x1f\x8b", gzip.open), (b"BZh", bz2.open), (b"\xfd7zXZ\x00", lzma.open)):
        if start.startswith(magic):
            return cast(Callable[[Path], IO[bytes]], opener)
    return lambda path: path.open("rb")
