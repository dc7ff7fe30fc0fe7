"""Reading arrays of Python objects, which are pickles, without running what a pickle may ask for."""

import io
import math
import pickle
import pickletools
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError, one_line
from vpr_bench.files.npy import Npy, read_limited

LIMIT = 256_000_000
"""Bytes: a larger file is not read."""

_INSTRUCTIONS = re.compile(
    "PROTO|FRAME|STOP|MARK|NONE|NEWTRUE|NEWFALSE|(BIN)?INT[12]?|LONG[14]?|(BIN)?FLOAT|(SHORT_)?(BIN)?(STRING|UNICODE8?)|"
    "(SHORT_)?BINBYTES8?|(EMPTY_)?(LIST|TUPLE)|TUPLE[123]|APPENDS?|((LONG_)?BIN)?(PUT|GET)|MEMOIZE|"
    "(STACK_)?GLOBAL|INST|REDUCE|BUILD"
)
"""What numbers, strings, lists, tuples and arrays are written with. All else, dicts among it, is refused."""

_PLAIN = re.compile(r"O[48]?|b1|[iuf][1248]|[SU][1-9][0-9]{0,5}")
"""Types of arrays: objects, bools, numbers, strings. Fields and dates have no place in them."""


class Forbidden(pickle.UnpicklingError):
    """A pickle asks for what an array of numbers does not need."""


def read_object_array(path: Path, limit: int = LIMIT) -> NDArray[Any]:
    """Read an ``.npy`` that holds Python objects; one of plain numbers is read too.

    Parameters
    ----------
    path : Path
        Written by ``np.save`` of any version, under Python 2 or 3.
    limit : int
        Bytes that the file may have.

    Returns
    -------
    array
        Of numbers, strings, None, lists, tuples, and arrays of such. They may be nested and shared in any way, within
        themselves too: look at what is there before following it.

    Raises
    ------
    DataError
        If the file is missing, damaged or too large, or its pickle asks for anything else. Nothing of it is run.
    """
    stored = Npy(read_limited(path, limit), str(path))
    if stored.dtype != np.dtype(object):
        return stored.numbers()
    try:
        array = _Reader(stored.content[stored.body :]).load()
    except Forbidden as error:
        raise DataError(
            f"{path} is refused: its pickle asks for {one_line(error):.200}, which an array of numbers does not need. "
            "Nothing of it was run; get the file from its publisher."
        ) from None
    except Exception as error:  # whatever a damaged pickle makes the reader raise
        why = f"{type(error).__name__}: {one_line(error):.200}"
        raise DataError(f"{path} is damaged ({why}). Get it again.") from None
    if not isinstance(array, _Array) or array.shape != stored.shape:
        raise DataError(f"{path} is damaged: it promises an array of {stored.shape} and holds another. Get it again.")
    return array.view(np.ndarray)


def _instructions() -> dict[int, Callable[[Any], None]]:
    names = {ord(one.code): one.name for one in pickletools.opcodes}

    def refusing(name: str) -> Callable[[Any], None]:
        def refuse(_: Any) -> None:
            raise Forbidden(f"the instruction {name}")

        return refuse

    return {
        code: do if _INSTRUCTIONS.fullmatch(names[code]) else refusing(names[code])
        for code, do in pickle._Unpickler.dispatch.items()
    }


class _Reader(pickle._Unpickler):
    """Reads the instructions above, and makes arrays of plain types itself.

    It is Python's own reader as it is written in Python: the one in C reserves as much memory as a pickle tells it to.
    """

    dispatch: ClassVar[dict[int, Callable[[Any], None]]] = _instructions()

    def __init__(self, content: bytes) -> None:
        # Python 2 has one type for text and bytes; with latin-1 neither is lost.
        super().__init__(io.BytesIO(content), encoding="latin1")
        budget = _Budget(8 * len(content))  # an object takes a byte or more in the file, and a pointer in memory
        self._makers: dict[tuple[str, str], Any] = {
            ("numpy", "dtype"): _Maker(_Type),
            ("numpy", "ndarray"): "ndarray",  # only ever handed to _reconstruct
            ("numpy.core.multiarray", "_reconstruct"): _Maker(lambda *_: _Array.of_none(budget)),
            ("numpy.core.multiarray", "scalar"): _Maker(_scalar),
            # How Python 3 writes bytes so that Python 2 can read them.
            ("_codecs", "encode"): _Maker(lambda text, _: budget.spend(_as_bytes(text))),
            ("__builtin__", "bytes"): _Maker(lambda: b""),
        }

    def find_class(self, module: str, name: str) -> Any:
        old = module.replace("numpy._core.", "numpy.core.", 1)
        try:
            return self._makers[old, name]
        except (KeyError, TypeError):
            raise Forbidden(f"{module}.{name}") from None


class _Budget:
    """How many bytes may still be made: sharing lets a small pickle ask for much."""

    def __init__(self, left: int) -> None:
        self.left = left

    def spend(self, made: bytes) -> bytes:
        self.take(len(made))
        return made

    def take(self, size: int) -> None:
        self.left -= size
        if self.left < 0:
            raise ValueError("it makes more of its content than the content is")


class _Maker:
    """What a pickle may call. It can do nothing else with it, such as change it."""

    __slots__ = ("_make",)

    def __init__(self, make: Callable[..., Any]) -> None:
        self._make = make

    def __call__(self, *args: Any) -> Any:
        return self._make(*args)

    def __setstate__(self, state: object) -> None:
        raise Forbidden("changing what it may call")


class _Type:
    """A numpy type to be: numpy's own lets a pickle write into it what makes numpy read foreign memory."""

    __slots__ = ("_order", "_plain")

    def __init__(self, plain: object, *_: object) -> None:
        text = plain.decode("latin1") if isinstance(plain, bytes) else plain
        if not isinstance(text, str) or _PLAIN.fullmatch(text) is None:
            raise Forbidden(f"the numpy type {text!r:.50}")
        self._plain, self._order = text, "="

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        order, inner = state[1], state[2:5]  # sub-array, names and fields
        order = order.decode("latin1") if isinstance(order, bytes) else order
        if order not in ("<", ">", "|", "=") or any(one is not None for one in inner) or len(state) > 8:
            raise Forbidden(f"the numpy type {self._plain} with {len(state)} properties of its own")
        self._order = order

    def dtype(self) -> np.dtype[Any]:
        """Return numpy's type."""
        return np.dtype(object) if self._plain[0] == "O" else np.dtype(self._order + self._plain)


class _Array(np.ndarray[Any, Any]):
    """An array whose state is checked before numpy takes it."""

    _budget: _Budget

    @classmethod
    def of_none(cls, budget: _Budget) -> "_Array":
        """Return an empty array, to be given its state."""
        array = cls((0,), np.int8)
        array._budget = budget
        return array

    def __setstate__(self, state: Any) -> None:
        _, shape, plain, fortran, content = state
        dtype, size = plain.dtype(), math.prod(shape)
        if dtype.hasobject:
            fits = isinstance(content, list) and len(content) == size
        else:
            content = _as_bytes(content)
            fits = len(content) == size * dtype.itemsize
        if not fits or any(type(one) is not int or one < 0 for one in shape):
            raise ValueError(f"an array of {shape} {dtype} has other content")
        self._budget.take(size * dtype.itemsize)
        super().__setstate__((1, shape, dtype, bool(fortran), content))  # type: ignore[arg-type]


def _scalar(plain: _Type, content: object) -> Any:
    dtype = plain.dtype()
    if dtype.hasobject:
        raise Forbidden("a scalar that is an object")
    return np.frombuffer(_as_bytes(content), dtype, count=1)[0]


def _as_bytes(content: object) -> bytes:
    if isinstance(content, str):
        return content.encode("latin1")
    if not isinstance(content, bytes):
        raise ValueError(f"{type(content).__name__} in place of bytes")  # noqa: TRY004 - damaged, not misused
    return content
