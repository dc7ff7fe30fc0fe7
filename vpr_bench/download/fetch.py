"""A dataset's folder or a single file, fetched once, however many processes ask for it at once."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

from vpr_bench.download.archive import extract_archive
from vpr_bench.download.http import download
from vpr_bench.download.members import Limits
from vpr_bench.errors import DataError
from vpr_bench.files.digest import check_digest, parse_digest, sha256_of_file
from vpr_bench.files.disk import DiskError, disk_errors
from vpr_bench.files.lock import held


def fetch_archive(
    url: str,
    folder: Path,
    *,
    sha256: str | None,
    check: Callable[[Path], None] | None = None,
    record: Callable[[str], None] | None = None,
    limits: Limits | None = None,
) -> Path:
    """Download an archive and unpack it as ``folder``, unless it is there already.

    A second process waits for the first and finds the work done. What a killed process left is continued
    (the download) or removed (half-unpacked files).

    Parameters
    ----------
    url
        Where the zip or tar archive is, ``http`` or ``https``.
    folder
        What it becomes. If it exists and is not empty, nothing is done and nothing checked.
    sha256
        The archive's digest, as ``sha256:<hex>``; None: not known, nothing is verified.
    check
        Called with the temporary folder of unpacked files; raises :class:`DataError` to refuse them.
    record
        Called with the digest of an archive that was unpacked.
    limits
        How large the archive, and what it unpacks to, may be (default: ``Limits()``).

    Returns
    -------
    Path
        ``folder``.

    Raises
    ------
    UsageError
        If the address is not ``http`` or ``https``, or ``sha256`` is not a digest.
    DataError
        If the archive cannot be had, is not the right one, is damaged or unsafe, or the disk refuses.
    """
    target = folder.resolve()
    if _is_filled(target):
        return folder
    limits = limits or Limits()
    archive = target.with_name(f".{target.name}.archive")
    with _alone(target):
        if _is_filled(target):
            return folder
        if not _is_verified(archive, sha256):
            download(url, archive, sha256=sha256, max_bytes=limits.max_bytes)
        try:
            extract_archive(archive, target, check=check, limits=limits)
        except DataError as error:
            if sha256 is None or not isinstance(error, DiskError):  # else it is verified and used when there is room
                archive.unlink(missing_ok=True)
            raise
        if record is not None:
            record(sha256_of_file(archive))
        archive.unlink(missing_ok=True)
    return folder


def fetch_file(url: str, path: Path, *, sha256: str | None, max_bytes: int | None = None) -> Path:
    """Download a single file, unless it is there already.

    Parameters
    ----------
    url
        Where the file is, ``http`` or ``https``.
    path
        Where it goes. A file that is there already is verified, and never replaced.
    sha256
        The file's digest, as ``sha256:<hex>``; None: not known, nothing is verified.
    max_bytes
        The most that the file may hold.

    Returns
    -------
    Path
        ``path``.

    Raises
    ------
    UsageError
        If the address is not ``http`` or ``https``, or ``sha256`` is not a digest.
    DataError
        If the file cannot be had, has another digest, or the disk refuses.
    """
    target = path.resolve()
    if not target.is_file():
        with _alone(target):
            if not target.is_file():
                download(url, target, sha256=sha256, max_bytes=max_bytes)
                return path
    if sha256 is not None:
        check_digest(target, sha256, advice="Move or delete it, so that it is downloaded again.")
    return path


def _is_filled(folder: Path) -> bool:
    with disk_errors(folder, "read"):
        if folder.is_dir():
            return any(folder.iterdir())
        if folder.exists():
            raise DataError(f"{folder} is a file, and a folder is to be made there. Move it and try again.")
    return False


def _is_verified(archive: Path, sha256: str | None) -> bool:
    """Tell whether an archive whose unpacking broke off is there and the right one."""
    return sha256 is not None and archive.is_file() and sha256_of_file(archive) == parse_digest(sha256)


def _alone(target: Path) -> AbstractContextManager[None]:
    """Keep other processes from fetching the same thing, or wait for the one that does."""
    lock = target.with_name(f".{target.name}.lock")
    return held(lock, f"Waiting for another process that is fetching {target.name}")
