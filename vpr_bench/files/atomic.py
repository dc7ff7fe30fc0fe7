"""Writing files so that nobody ever sees half of one."""

import secrets
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError
from vpr_bench.files.disk import disk_errors


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Yield a temporary path beside ``path`` that takes its place if the ``with`` block ends well.

    Raises
    ------
    DataError
        If the disk refuses.
    """
    temporary = path.with_name(f".{path.name}.{secrets.token_hex(4)}.tmp")
    with disk_errors(path):
        try:
            yield temporary
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)


def write_bytes(path: Path, content: bytes) -> None:
    """Write a file under a temporary name, then rename it into place."""
    with replacing(path) as temporary:
        temporary.write_bytes(content)


def write_arrays(path: Path, arrays: Mapping[str, NDArray[np.generic]]) -> None:
    """Write arrays as an ``.npz``; the same arrays give the same bytes."""
    with replacing(path) as temporary, temporary.open("wb") as file:
        np.savez(file, allow_pickle=False, **dict(arrays))


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
