"""The files in which a method keeps what it has learnt: all there, as they were written, and no others."""

from collections.abc import Mapping
from pathlib import Path

from vpr_bench.dataset.folders import cache_root
from vpr_bench.errors import DamagedError
from vpr_bench.files.digest_cache import sha256_of_files
from vpr_bench.files.disk import disk_errors
from vpr_bench.maps.record import StoredFile

SMALL = 8_000_000
"""Bytes: as much is read each time, in a few milliseconds; of more, digests are remembered until a file is touched."""


def describe_state(folder: Path) -> dict[str, StoredFile]:
    """Return the size and digest of every file in a folder, by relative path.

    Raises
    ------
    DataError
        If a file cannot be read.
    """
    files = _files(folder)
    with disk_errors(folder, "read"):
        sizes = [file.stat().st_size for file in files]
    digests = sha256_of_files(files, None)
    return {
        file.relative_to(folder).as_posix(): StoredFile(size=size, digest=digest)
        for file, size, digest in zip(files, sizes, digests, strict=True)
    }


def check_state(folder: Path, files: Mapping[str, StoredFile], *, verify: bool = False) -> None:
    """Check that a folder holds the files it should hold.

    Parameters
    ----------
    folder : Path
        The ``state`` of a map.
    files : mapping
        What it should hold.
    verify : bool
        Read every byte, however much it is and whatever was read before.

    Raises
    ------
    DamagedError
        If a file is missing, one too many, or not as it was written.
    DataError
        If a file cannot be read.
    """
    expected = {folder / name: facts for name, facts in files.items()}
    strange = next((file for file in _files(folder) if file not in expected and not file.name.startswith(".")), None)
    if strange is not None:
        raise DamagedError(f"{strange} is no part of the map. Remove it, or fit the map again.")
    for file, facts in expected.items():
        with disk_errors(file, "read"):
            found = file.stat().st_size if file.is_file() else None
        if found != facts.size:
            what = "missing" if found is None else f"damaged: {facts.size:,} bytes were written, {found:,} are there"
            raise DamagedError(f"{file} is {what}. Fit the map again with --overwrite.")
    small = sum(facts.size for facts in files.values()) <= SMALL
    digests = sha256_of_files(expected, None if verify or small else cache_root() / "digests")
    for (file, facts), digest in zip(expected.items(), digests, strict=True):
        if digest != facts.digest:
            raise DamagedError(f"{file} is damaged: it is not what was written. Fit the map again with --overwrite.")


def _files(folder: Path) -> list[Path]:
    with disk_errors(folder, "read"):
        return sorted(file for file in folder.rglob("*") if not file.is_dir())
