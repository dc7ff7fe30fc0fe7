"""Digests of many files, computed once and remembered as long as the files are not touched.

Reading tens of thousands of images to find out that they are still the same costs minutes. As version control and
build tools do, a file whose size and time of modification have not changed is taken to be the same; what verifies
images reads every byte.
"""

import hashlib
import json
import time
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from vpr_bench.errors import DataError
from vpr_bench.files.atomic import write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.files.disk import disk_errors
from vpr_bench.progress import track

_SETTLED_NS = 2_000_000_000
"""A file changed less than this long ago might be changed again within the clock's resolution: not remembered."""

_WORTH_A_BAR = 1000


def sha256_of_files(paths: Iterable[Path], cache: Path | None) -> list[str]:
    """Return the digest of each file, as ``sha256:<hex>``.

    Parameters
    ----------
    paths : iterable of Path
        The files.
    cache : Path, optional
        Folder in which digests are remembered, one file per folder of images; None reads every file.

    Raises
    ------
    DataError
        If a file cannot be read.
    """
    files = list(paths)
    remembered = {folder: _Remembered(cache, folder) for folder in {file.parent for file in files}}
    shown = track(files, "Computing digests") if len(files) >= _WORTH_A_BAR else files
    digests = [remembered[file.parent].digest(file) for file in shown]
    for one in remembered.values():
        one.save()
    return digests


class _Remembered:
    """What is known about the files of one folder."""

    def __init__(self, cache: Path | None, folder: Path) -> None:
        name = hashlib.sha256(str(folder.absolute()).encode()).hexdigest()[:24]
        self._file = None if cache is None else cache / f"{name}.json"
        self._entries: dict[str, list[int | str]] = {}
        self._changed = False
        if self._file is not None:
            with suppress(OSError, ValueError):
                loaded = json.loads(self._file.read_text("utf-8"))
                entries = loaded.items() if isinstance(loaded, dict) else ()
                self._entries = {name: entry for name, entry in entries if _is_entry(entry)}

    def digest(self, path: Path) -> str:
        with disk_errors(path, "read"):
            facts = path.stat()
        entry = self._entries.get(path.name)
        if entry is not None and entry[:2] == [facts.st_size, facts.st_mtime_ns]:
            return str(entry[2])
        digest = sha256_of_file(path)
        if self._file is not None and time.time_ns() - facts.st_mtime_ns > _SETTLED_NS:
            self._entries[path.name] = [facts.st_size, facts.st_mtime_ns, digest]
            self._changed = True
        return digest

    def save(self) -> None:
        if self._file is not None and self._changed:
            with suppress(DataError, OSError):  # without a cache everything works, only slower
                self._file.parent.mkdir(parents=True, exist_ok=True)
                write_bytes(self._file, json.dumps(self._entries).encode())


def _is_entry(entry: object) -> bool:
    """Tell whether something is a size, a time and a digest: a cache may be damaged like any other file."""
    return isinstance(entry, list) and [type(part) for part in entry] == [int, int, str]
