"""Digests of what a traverse's files contain, so that a result says which images it was measured on."""

import hashlib
import json
import os
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from vpr_bench.dataset.folders import cache_root
from vpr_bench.dataset.recording import Recording
from vpr_bench.files.digest_cache import sha256_of_files
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.places import Places
from vpr_bench.types.traverse import Traverse


def traverse_digest(traverse: Traverse, *, afresh: bool = False) -> str:
    """Return ``sha256:…`` over the name-sorted listing that ``sha256sum *`` prints for the traverse's files.

    Parameters
    ----------
    traverse : Traverse
        Its images.
    afresh : bool
        Read every file, and not only those that were touched since they were read last.

    Raises
    ------
    DataError
        If a file cannot be read.
    """
    listing = hashlib.sha256()
    for name, digest in sorted(_file_digests(traverse, None if afresh else cache_root() / "digests")):
        listing.update(f"{digest}  {name}\n".encode())
    return f"sha256:{listing.hexdigest()}"


def case_digest(parts: Iterable[tuple[Recording, str]], given: GroundTruth | None = None) -> str:
    """Return one digest over recordings, each with the :func:`traverse_digest` of its files, and what they share.

    The order of the images and what is done to them after decoding count too: a loader that is mended makes
    another case of the same files.
    """
    total = hashlib.sha256()
    for recording, digest in parts:
        traverse, labels = recording.traverse, recording.labels
        names = _names(traverse)
        convert = getattr(traverse.convert, "__qualname__", repr(traverse.convert))
        total.update(json.dumps([digest, names, convert, None if labels is None else labels.shape]).encode())
        for column in (labels, recording.compass):
            if column is not None:
                total.update(np.ascontiguousarray(column, dtype="<f8").tobytes())
    for name, array in Places(given=given).arrays().items():
        total.update(name.encode() + np.ascontiguousarray(array, dtype="<i8").tobytes())
    return f"sha256:{total.hexdigest()}"


def _file_digests(traverse: Traverse, cache: Path | None) -> list[tuple[str, str]]:
    files = [source for source in traverse.sources if isinstance(source, Path)]
    digests = iter(sha256_of_files(files, cache))
    named = []
    for index, (name, source) in enumerate(zip(_names(traverse), traverse.sources, strict=True)):
        if isinstance(source, np.ndarray):
            named.append((f"{index:09d}", hashlib.sha256(source.tobytes()).hexdigest()))
        else:
            named.append((name, next(digests).removeprefix("sha256:")))
    return named


def _names(traverse: Traverse) -> list[str]:
    """Return what tells the images apart: paths from the innermost folder that holds them all, or sizes in memory."""
    folders = {source.parent for source in traverse.sources if isinstance(source, Path)}
    if len(folders) <= 1:
        return [source.name if isinstance(source, Path) else str(source.shape) for source in traverse.sources]
    common = os.path.commonpath(folders)
    return [
        source.relative_to(common).as_posix() if isinstance(source, Path) else str(source.shape)
        for source in traverse.sources
    ]
