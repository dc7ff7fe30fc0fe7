"""Writing files so that nobody ever sees half of one."""

import hashlib
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError


def write_bytes(path: Path, content: bytes) -> None:
    """Write a file under a temporary name, then rename it into place."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        temporary.write_bytes(content)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def write_arrays(path: Path, arrays: Mapping[str, NDArray[np.generic]]) -> None:
    """Write arrays as an ``.npz``; the same arrays give the same bytes."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp.npz")
    try:
        np.savez(temporary, **dict(arrays), allow_pickle=False)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def read_arrays(path: Path, *names: str) -> dict[str, NDArray[Any]]:
    """Read all arrays of an ``.npz``, in the order in which they were written.

    Parameters
    ----------
    path : Path
        The file.
    *names : str
        Arrays that must be in it.

    Raises
    ------
    DataError
        If the file is missing or damaged, or an array is not in it.
    """
    try:
        with np.load(path, allow_pickle=False) as stored:
            arrays = {name: stored[name] for name in stored.files}
    except Exception as error:  # numpy raises whatever zipfile, zlib and its own parser do
        raise DataError(f"{path} is missing or damaged: {type(error).__name__}: {error}.") from None
    for name in names:
        if name not in arrays:
            raise DataError(f"{path} is damaged: it holds no array {name!r}.")
    return arrays


def digest_of(path: Path) -> str:
    """Return ``sha256:…`` of a file.

    Raises
    ------
    DataError
        If it cannot be read.
    """
    try:
        with path.open("rb") as file:
            return f"sha256:{hashlib.file_digest(file, 'sha256').hexdigest()}"
    except OSError as error:
        raise DataError(f"{path} cannot be read: {error.strerror}.") from None
