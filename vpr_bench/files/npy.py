"""The ``.npy`` format, read from files that anybody may have made."""

import io
import math
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from vpr_bench.errors import DataError, one_line
from vpr_bench.files.disk import disk_errors, readable_size

_NUMBERS = "biuf"  # numpy's kinds: bool, int, unsigned, float


class Npy:
    """The header of an ``.npy``, and its content.

    Parameters
    ----------
    content : bytes
        The file, or as much of it as is there; of a beginning, only the header may be asked for.
    called : str
        What to call it in errors.

    Attributes
    ----------
    dtype, shape, fortran
        What the header says; nothing was compared with the content yet.

    Raises
    ------
    DataError
        If the header is damaged.
    """

    def __init__(self, content: bytes, called: str) -> None:
        self.content, self.called = content, called
        stream = io.BytesIO(content)
        try:
            version = npy.read_magic(stream)
            # Version 3.0 is for names of fields, which neither numbers nor objects have.
            read = {(1, 0): npy.read_array_header_1_0, (2, 0): npy.read_array_header_2_0}[version]
            self.shape, self.fortran, self.dtype = read(stream)
        except Exception as error:  # the header is a Python literal: whatever parsing it raises
            raise DataError(f"{called} is no .npy file that can be read: {_why(error)}. Get it again.") from None
        self.body = stream.tell()
        if any(size < 0 for size in self.shape):
            raise DataError(f"{called} is damaged: its shape is {self.shape}. Get it again.")

    def numbers(self) -> NDArray[Any]:
        """Return the array, read-only, if it holds bools, integers or floating-point numbers.

        Raises
        ------
        DataError
            If it holds something else, or not as much as the header says.
        """
        if self.dtype.kind not in _NUMBERS:
            raise DataError(f"{self.called} must hold numbers. It holds {one_line(self.dtype)!s:.60}: get it again.")
        expected = math.prod(self.shape) * self.dtype.itemsize
        if max(self.shape, default=0) > len(self.content) or expected != len(self.content) - self.body:
            raise DataError(
                f"{self.called} is damaged: {self.shape} numbers of {self.dtype} are {expected:,} bytes, "
                f"found {len(self.content) - self.body:,}. Get it again."
            )
        flat = np.frombuffer(self.content, self.dtype, offset=self.body)
        return flat.reshape(self.shape, order="F" if self.fortran else "C")


def read_limited(path: Path, limit: int) -> bytes:
    """Read a file unless it is too large to be what it should be.

    Raises
    ------
    DataError
        If it is missing, not a file, or has more than ``limit`` bytes.
    """
    with disk_errors(path, "read"):
        if not path.is_file():  # a pipe would never end
            raise DataError(f"The file {path} is missing. Restore it, or fetch the dataset again.")
        with path.open("rb") as file:
            content = file.read(limit + 1)
    if len(content) > limit:
        raise DataError(f"{path} is refused: it has more than {readable_size(limit)}. Check that it is the right file.")
    return content


def _why(error: Exception) -> str:
    return f"{type(error).__name__}: {one_line(error):.200}"
