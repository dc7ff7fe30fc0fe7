"""Unpacking an archive that nobody vouches for into a folder that appears whole or not at all."""

import shutil
from collections.abc import Callable
from pathlib import Path, PurePosixPath

from vpr_bench.download.formats import open_archive
from vpr_bench.download.members import Limits, Member, plan
from vpr_bench.errors import DataError
from vpr_bench.files.disk import disk_errors, require_space
from vpr_bench.progress import Advance, task

_CHUNK = 1024 * 1024  # bytes


def extract_archive(
    archive: Path,
    folder: Path,
    *,
    check: Callable[[Path], None] | None = None,
    limits: Limits | None = None,
) -> Path:
    """Unpack a zip or tar (plain, gz, bz2, xz) archive.

    All names are judged first (see :func:`vpr_bench.download.members.plan`); then the files are written to a
    temporary folder beside ``folder``, checked, and moved into place in one step. Modes, owners and times are
    not taken from the archive. Callers that may collide hold a lock: what a killed process left of the
    temporary folder is removed.

    Parameters
    ----------
    archive
        The archive.
    folder
        What to make of it; must not exist, or be empty.
    check
        Called with the temporary folder; raises :class:`DataError` if the contents are not the right ones.
    limits
        How much the archive may unpack to (default: ``Limits()``).

    Returns
    -------
    Path
        ``folder``.

    Raises
    ------
    DataError
        If the archive is damaged, encrypted, unsafe or too large, ``check`` refuses its contents, or
        ``folder`` cannot be written. Nothing is left behind then.
    """
    temporary = folder.with_name(f".{folder.name}.unpacking")
    with disk_errors(folder):
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise DataError(f"{folder} is in the way: it exists and is not empty. Move it and try again.")
        folder.parent.mkdir(parents=True, exist_ok=True)
        if temporary.exists():
            shutil.rmtree(temporary)
        try:
            with open_archive(archive) as members:
                chosen = plan(members, archive.stat().st_size, limits or Limits())
                total = sum(member.size for _, member in chosen if member.kind == "file")
                require_space(folder.parent, total)
                temporary.mkdir()
                with task(f"Unpacking {folder.name}", total) as advance:
                    _write(chosen, temporary, advance)
            if check is not None:
                check(temporary)
            if folder.exists():
                folder.rmdir()
            temporary.replace(folder)
        except BaseException:
            shutil.rmtree(temporary, ignore_errors=True)
            raise
    return folder


def _write(chosen: list[tuple[PurePosixPath, Member]], folder: Path, advance: Advance) -> None:
    for path, member in chosen:
        if member.kind == "folder":
            (folder / path).mkdir(parents=True, exist_ok=True)
        else:
            _write_file(member, folder / path, advance)


def _write_file(member: Member, destination: Path, advance: Advance) -> None:
    destination.parent.mkdir(parents=True, exist_ok=True)
    written = 0
    with member.open() as source, destination.open("xb") as file:
        while chunk := source.read(_CHUNK):
            written += len(chunk)
            if written > member.size:
                break
            file.write(chunk)
            advance(len(chunk))
    if written != member.size:
        raise DataError(f"The archive is damaged: {member.name!r} has not the stated size. Get it again.")
