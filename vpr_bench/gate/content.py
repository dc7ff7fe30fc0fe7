"""What stands in a baseline file, before it is known to be a baseline."""

import json
from collections import Counter
from pathlib import Path
from typing import Any

from vpr_bench.errors import DamagedError, one_line
from vpr_bench.files.disk import disk_errors

RESTORE = "Take the file back from version control, or delete the cell and record it anew with --update."
"""What can be done where something is damaged that nobody edits by hand."""

_CONFLICT = (b"<<<<<<<", b"|||||||", b"=======", b">>>>>>>")


def read_content(path: Path) -> dict[str, Any]:
    """Read the file as JSON.

    Raises
    ------
    DamagedError
        If it holds no object, is empty, holds the marks of a merge conflict, or says something twice.
    DataError
        If it cannot be read.
    """
    with disk_errors(path, "read"):
        text = path.read_bytes()
    if not text.strip():
        raise DamagedError(
            f"{path} is empty. Take it back from version control, or delete it and record it anew with --update."
        )
    _check_merged(path, text)
    try:
        content = json.loads(text, object_pairs_hook=_without_duplicates, parse_constant=_refuse)
    except json.JSONDecodeError as error:
        raise DamagedError(
            f"{path} is damaged: line {error.lineno}, column {error.colno}: {error.msg}. "
            "Mend that line, or take the file back from version control."
        ) from None
    except (ValueError, RecursionError) as error:
        raise DamagedError(f"{path} is damaged: {one_line(error):.300}. {RESTORE}") from None
    if not isinstance(content, dict):
        raise DamagedError(f"{path} is no baseline: it holds no object.")
    return content


def _check_merged(path: Path, text: bytes) -> None:
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith(_CONFLICT):
            raise DamagedError(
                f"{path}, line {number}: {line[:7].decode()!r} is the mark of a merge conflict. Keep the cells of both "
                "sides, without the marks; of a cell that both changed keep one, and record it anew with --update."
            )


def _without_duplicates(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    name, times = Counter(name for name, _ in pairs).most_common(1)[0] if pairs else ("", 1)
    if times > 1:
        raise ValueError(f"{name!r:.200} is there {times} times")
    return dict(pairs)


def _refuse(constant: str) -> float:
    raise ValueError(f"{constant} is no number")
