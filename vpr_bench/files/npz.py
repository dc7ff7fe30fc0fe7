"""Arrays out of an ``.npz`` that anybody may have made: nothing is unpacked before it is known how large it is."""

import math
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from vpr_bench.errors import DataError, blaming
from vpr_bench.files.disk import disk_errors, readable_size
from vpr_bench.files.npy import Npy

LIMIT = 4_000_000_000
"""Bytes: a larger array is not read."""

_HEADER = 65_536  # bytes; numpy reads headers of up to 10,000
_PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # all that numpy writes


def array_names(path: Path) -> list[str]:
    """Return the names of the arrays in a file.

    Raises
    ------
    DataError
        If it is missing or damaged.
    """
    with _opened(path) as stored:
        return [name.removesuffix(".npy") for name in stored.namelist() if name.endswith(".npy")]


def array_shape(path: Path, name: str) -> tuple[int, ...]:
    """Return the shape of an array, as its header states it; the array is not unpacked.

    Raises
    ------
    DataError
        If the file is missing or damaged, or there is no such array in it.
    """
    with _opened(path) as stored, stored.open(_member(stored, path, name)) as member:
        return tuple(Npy(member.read(_HEADER), f"{name} in {path}").shape)


def read_numbers(path: Path, name: str) -> NDArray[Any]:
    """Read an array of numbers.

    Raises
    ------
    DataError
        If the file is missing or damaged, or the array is not in it, holds something else, or is too large.
    """
    with _opened(path) as stored:
        info = _member(stored, path, name)
        with stored.open(info) as member:
            header = Npy(member.read(_HEADER), f"{name} in {path}")
        size = header.body + math.prod(header.shape) * header.dtype.itemsize
        if size != info.file_size or size > LIMIT:
            raise DataError(
                f"{path} is refused: {name} is {header.shape} {header.dtype}, {readable_size(size)}, and "
                f"{readable_size(min(info.file_size, LIMIT))} were expected. Get it again."
            )
        with stored.open(info) as member:
            return Npy(member.read(size), f"{name} in {path}").numbers()


@contextmanager
def _opened(path: Path) -> Iterator[zipfile.ZipFile]:
    with disk_errors(path, "read"):
        if not path.is_file():  # a pipe would never end
            raise DataError(f"The file {path} is missing. Restore it, or fetch the dataset again.")
        # zipfile raises whatever a damaged archive makes it do, RuntimeError for an encrypted one among it.
        with blaming(f"{path} is damaged; get it again", DataError), zipfile.ZipFile(path) as stored:
            yield stored


def _member(stored: zipfile.ZipFile, path: Path, name: str) -> zipfile.ZipInfo:
    info = next((one for one in stored.infolist() if one.filename == f"{name}.npy"), None)
    if info is None:
        found = ", ".join(one.filename for one in stored.infolist()[:5])
        raise DataError(f"{path} holds no array {name}. Found {found!r:.100}.")
    if info.compress_type not in _PACKED:
        raise DataError(f"{path} is refused: {name} is packed in a way that numpy does not write.")
    return info
