"""What an archive claims to hold, judged before anything of it is written."""

import re
import unicodedata
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import IO

from vpr_bench.errors import DataError
from vpr_bench.files.disk import readable_size

_ADVICE = "Nothing was unpacked. Get the archive from its publisher, or unpack it by hand if you trust it."
_LONGEST_NAME = 4096  # characters


@dataclass(frozen=True)
class Limits:
    """How much an archive may unpack to; beyond it, it counts as a decompression bomb."""

    max_bytes: int = 200 * 10**9
    """Size of all files together."""
    max_files: int = 2_000_000
    """Number of files and folders."""
    max_ratio: float = 200.0
    """Size of all files together, relative to the archive's own size."""
    harmless_bytes: int = 100 * 10**6
    """Up to this size of all files together, the ratio does not matter."""


@dataclass(frozen=True)
class Member:
    """One entry of an archive, of either format."""

    name: str
    """As the archive has it."""
    size: int
    """Bytes that it claims to unpack to."""
    kind: str
    """``file``, ``folder``, or what else it is, in words."""
    open: Callable[[], IO[bytes]]
    """Opens a file's content."""


def plan(members: Iterable[Member], packed_size: int, limits: Limits) -> list[tuple[PurePosixPath, Member]]:
    """Choose what to unpack, and where, or refuse the whole archive.

    Refused are names that lead out of the folder or mean different things on different systems, everything
    that is neither file nor folder, names that collide (also where case is ignored), and bombs. What macOS
    adds (``__MACOSX/``, ``.DS_Store``, ``._*``) is left out.

    Parameters
    ----------
    members
        The archive's entries; read no further than the first that is refused.
    packed_size
        Bytes of the archive itself.
    limits
        How much it may unpack to.

    Returns
    -------
    list of (PurePosixPath, Member)
        Relative paths, and the entries that belong there, in the archive's order.

    Raises
    ------
    DataError
        If the archive is refused, or holds no files.
    """
    chosen = []
    names = _Names()
    total = 0
    for count, member in enumerate(members, start=1):
        total += _declared_size(member)
        _refuse_bomb(count, total, packed_size, limits)
        path = _relative_path(member)
        if path.parts and not _is_junk(path):
            names.add(path, is_folder=member.kind == "folder")
            chosen.append((path, member))
    if not any(member.kind == "file" for _, member in chosen):
        raise DataError("The archive holds no files. Check that it is the right one.")
    return chosen


def _declared_size(member: Member) -> int:
    if member.kind not in ("file", "folder"):
        raise DataError(f"The archive holds a {member.kind}, {_quoted(member.name)}. {_ADVICE}")
    if member.size < 0:
        raise DataError(f"The archive gives {_quoted(member.name)} the size {member.size}. {_ADVICE}")
    return member.size if member.kind == "file" else 0


def _refuse_bomb(count: int, total: int, packed_size: int, limits: Limits) -> None:
    if count > limits.max_files:
        raise DataError(f"The archive holds more than {limits.max_files} files. {_ADVICE}")
    if total > limits.max_bytes:
        raise DataError(f"The archive unpacks to more than {readable_size(limits.max_bytes)}. {_ADVICE}")
    if total > max(limits.harmless_bytes, limits.max_ratio * packed_size):
        raise DataError(
            f"The archive of {readable_size(packed_size)} unpacks to more than {limits.max_ratio:g} times "
            f"its size, like a decompression bomb. {_ADVICE}"
        )


def _relative_path(member: Member) -> PurePosixPath:
    name = member.name
    path = PurePosixPath(name)  # drops "." and empty parts
    if not name or "\0" in name or len(name) > _LONGEST_NAME:
        problem = "an unusable name"
    elif "\\" in name:
        problem = "a backslash in a name"
    elif path.is_absolute() or re.match(r"[A-Za-z]:", name):
        problem = "an absolute path"
    elif ":" in name or any(part != part.rstrip(". ") for part in path.parts if part != ".."):
        problem = "a name that some systems take for another one"
    elif ".." in path.parts:
        problem = "a path that leads out of its folder"
    elif not path.parts and member.kind == "file":
        problem = "a file without a name"
    else:
        return path
    raise DataError(f"The archive holds {problem}, {_quoted(name)}. {_ADVICE}")


def _is_junk(path: PurePosixPath) -> bool:
    return "__MACOSX" in path.parts or path.name == ".DS_Store" or path.name.startswith("._")


class _Names:
    """The paths seen so far, by what they are called where case is ignored."""

    def __init__(self) -> None:
        self._seen: dict[str, tuple[PurePosixPath, bool]] = {}

    def add(self, path: PurePosixPath, *, is_folder: bool) -> None:
        for parent in reversed(path.parents[:-1]):
            self._add(parent, is_folder=True)
        self._add(path, is_folder=is_folder)

    def _add(self, path: PurePosixPath, *, is_folder: bool) -> None:
        key = unicodedata.normalize("NFC", str(path)).casefold()
        other, other_is_folder = self._seen.setdefault(key, (path, is_folder))
        if other is path or (other == path and is_folder and other_is_folder):
            return
        raise DataError(
            f"The archive holds names that collide, {_quoted(str(other))} and {_quoted(str(path))}. {_ADVICE}"
        )


def _quoted(name: str) -> str:
    """Write a name that may hold anything, control characters and megabytes included."""
    return repr(name if len(name) <= 100 else f"{name[:100]}…")
