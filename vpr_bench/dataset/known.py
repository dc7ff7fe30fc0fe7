"""Digests of images that no card vouches for: recorded on first contact, and compared from then on."""

import json
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.folders import state_root
from vpr_bench.errors import DataError, blaming
from vpr_bench.files.atomic import write_bytes
from vpr_bench.files.disk import disk_errors
from vpr_bench.files.lock import held

_FILE = "known_digests.json"


def known_digest(name: str) -> str | None:
    """Return the digest under which something was first met, None if it never was.

    Parameters
    ----------
    name : str
        ``dataset/traverse``, ``dataset:edition/traverse``, or the address of an archive.

    Raises
    ------
    DataError
        If the record cannot be read.
    """
    entry = _read(state_root() / _FILE).get(name)
    return None if entry is None else str(entry["digest"])


def remember_digest(name: str, digest: str, folder: Path) -> None:
    """Record a digest, in place of an older one of the same name.

    Raises
    ------
    DataError
        If it cannot be written.
    """
    file = state_root() / _FILE
    with held(file.with_name(_FILE + ".lock"), "Waiting for another process that records digests"):
        entries = _read(file)
        when = datetime.now(UTC).isoformat(timespec="seconds")
        entries[name] = {"digest": digest, "folder": str(folder), "first_seen": when}
        write_bytes(file, json.dumps(entries, indent=2, sort_keys=True).encode())


def vouched_digest(one: TraverseCard, source: str | None) -> tuple[str | None, str]:
    """Return the digest that a traverse should have, and who says so; None if nobody does.

    Parameters
    ----------
    one : TraverseCard
        The card's own digest comes first.
    source : str, optional
        Dataset, with its edition; None for images of which no record is kept.
    """
    if one.digest is not None or source is None:
        return one.digest, "the card knows"
    return known_digest(f"{source}/{one.name}"), "was met here first"


def _read(file: Path) -> dict[str, dict[str, Any]]:
    if not file.exists():
        return {}
    with disk_errors(file, "read"), blaming(f"{file} is damaged; delete it to record anew", DataError):
        entries = json.loads(file.read_text("utf-8"))
        return {str(name): {"digest": str(entry["digest"]), **entry} for name, entry in entries.items()}
