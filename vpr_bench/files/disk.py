"""Trouble with the file system, told in one line."""

import errno
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from vpr_bench.errors import DataError

_ELSEWHERE = (
    "choose another folder (by the command's options; of images by VPR_BENCH_DATA, of weights by VPR_BENCH_WEIGHTS, "
    "of rendered images by XDG_CACHE_HOME)"
)
_FULL = {errno.ENOSPC, errno.EDQUOT}
_FORBIDDEN = {errno.EACCES, errno.EPERM, errno.EROFS}
_NOT_A_FOLDER = {errno.ENOTDIR, errno.EEXIST, errno.EISDIR}


class DiskError(DataError):
    """The file system refused: no room, no permission, or something in the way."""


@contextmanager
def disk_errors(path: Path, verb: str = "write") -> Iterator[None]:
    """Turn the operating system's errors inside the ``with`` block into a :class:`DiskError` about ``path``.

    An ``OSError`` without an ``errno`` does not come from the file system (decompressors and HTTP libraries
    raise such ones) and passes through unchanged.

    Examples
    --------
    >>> with disk_errors(Path("data")):
    ...     raise OSError(errno.ENOENT, "No such file or directory")
    Traceback (most recent call last):
    vpr_bench.files.disk.DiskError: Cannot write data: No such file or directory.
    """
    try:
        yield
    except OSError as error:
        if error.errno is None:
            raise
        raise DiskError(_explain(path, verb, error)) from error


def _explain(path: Path, verb: str, error: OSError) -> str:
    if error.errno in _FULL:
        return f"Cannot {verb} {path}: the disk is full. Free some space, or {_ELSEWHERE}."
    if error.errno in _FORBIDDEN:
        return f"Cannot {verb} {path}: {error.strerror}. Change the permissions, or {_ELSEWHERE}."
    if error.errno in _NOT_A_FOLDER:
        return f"Cannot {verb} {path}: {_in_the_way(path, error)} is in the way. Move it, or {_ELSEWHERE}."
    return f"Cannot {verb} {path}: {error.strerror}."


def _in_the_way(path: Path, error: OSError) -> Path:
    """Return the file that lies where a folder is needed; the system names only what is below it."""
    named = [Path(name) for name in (error.filename, error.filename2, path) if isinstance(name, str | Path)]
    candidates = [one for name in named for one in (name, *name.parents)]
    return next((one for one in candidates if one.is_file()), candidates[0])


def require_space(folder: Path, size: int) -> None:
    """Raise :class:`DiskError` unless the disk of ``folder`` (which exists) has ``size`` bytes free."""
    with disk_errors(folder, "read"):
        free = shutil.disk_usage(folder).free
    if size > free:
        raise DiskError(
            f"{readable_size(size)} are needed in {folder} and {readable_size(free)} are free. "
            f"Free some space, or {_ELSEWHERE}."
        )


def readable_size(size: float) -> str:
    """Write a number of bytes for people, in decimal units.

    Examples
    --------
    >>> readable_size(999), readable_size(1_234_567), readable_size(2e12)
    ('999 B', '1.2 MB', '2.0 TB')
    """
    if size < 1000:
        return f"{size:.0f} B"
    for unit in ("kB", "MB", "GB"):
        size /= 1000
        if size < 1000:
            return f"{size:.1f} {unit}"
    return f"{size / 1000:.1f} TB"
