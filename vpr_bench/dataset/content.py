"""Digests of what a traverse's files contain, so that a result says which images it was measured on."""

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.files.digest import sha256_of_file
from vpr_bench.types.traverse import Traverse


def traverse_digest(traverse: Traverse) -> str:
    """Return ``sha256:…`` over the name-sorted listing that ``sha256sum *`` prints for the traverse's files.

    Raises
    ------
    DataError
        If a file cannot be read.
    """
    listing = hashlib.sha256()
    for name, digest in sorted(_file_digests(traverse)):
        listing.update(f"{digest}  {name}\n".encode())
    return f"sha256:{listing.hexdigest()}"


def case_digest(parts: Iterable[tuple[Traverse, NDArray[np.float64], str]]) -> str:
    """Return one digest over traverses, each with its place labels and :func:`traverse_digest`.

    The order of the images and what is done to them after decoding count too: a loader that is mended makes
    another case of the same files.
    """
    total = hashlib.sha256()
    for traverse, labels, digest in parts:
        names = [source.name if isinstance(source, Path) else str(source.shape) for source in traverse.sources]
        convert = getattr(traverse.convert, "__qualname__", repr(traverse.convert))
        total.update(json.dumps([digest, names, convert, labels.shape]).encode())
        total.update(np.ascontiguousarray(labels, dtype="<f8").tobytes())
    return f"sha256:{total.hexdigest()}"


def _file_digests(traverse: Traverse) -> list[tuple[str, str]]:
    digests = []
    for index, source in enumerate(traverse.sources):
        if isinstance(source, np.ndarray):
            digests.append((f"{index:09d}", hashlib.sha256(source.tobytes()).hexdigest()))
        else:
            digests.append((source.name, sha256_of_file(source).removeprefix("sha256:")))
    return digests
