"""What can go wrong, and the exit code that each kind carries.

Every error a user can cause is a :class:`VprBenchError`: its message says what was wrong, what was found and
what to do next, in one or two lines. The command line prints the message and exits with ``exit_code``.
"""

import difflib
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pydantic import ValidationError


class VprBenchError(Exception):
    """Base of all errors that the command line reports without a traceback (exit code 1: a check failed)."""

    exit_code = 1


class UsageError(VprBenchError):
    """Something was asked for that does not exist or makes no sense (exit code 2)."""

    exit_code = 2


class DataError(VprBenchError):
    """Images, weights or stored results are missing or damaged (exit code 3)."""

    exit_code = 3


class DamagedError(DataError):
    """A stored run is not as it was left."""


@contextmanager
def blaming(what: str, kind: type[VprBenchError] = VprBenchError) -> Iterator[None]:
    """Turn whatever foreign code raises inside the ``with`` block into a one-line error about ``what``.

    Examples
    --------
    >>> with blaming("The method 'x' failed"):
    ...     {}["key"]
    Traceback (most recent call last):
    vpr_bench.errors.VprBenchError: The method 'x' failed: KeyError: 'key'
    """
    try:
        yield
    except VprBenchError:
        raise
    except (Exception, SystemExit) as error:  # a plug-in that exits must not pass for a good end
        raise kind(f"{what}: {error_in_words(error)}") from error


def error_in_words(error: BaseException) -> str:
    r"""Write what was raised, and what it says, on one line.

    Examples
    --------
    >>> error_in_words(ValueError("too\nlarge")), error_in_words(MemoryError())
    ('ValueError: too large', 'MemoryError')
    """
    return f"{type(error).__name__}: {one_line(error)}".removesuffix(": ")


def one_line(text: object) -> str:
    r"""Write foreign text on one line, without what would move a terminal's cursor or change its colours.

    Examples
    --------
    >>> one_line("two\nlines \x1b[31mred")
    'two lines [31mred'
    """
    return "".join(mark for mark in " ".join(str(text).split()) if mark.isprintable())


def first_fault(error: "ValidationError") -> str:
    """Say where a description first goes wrong, and how."""
    first = error.errors()[0]
    where = ".".join(str(part) for part in first["loc"])
    return f"{where}: {first['msg']}" if where else first["msg"]


def closest(name: str, known: Iterable[str]) -> str:
    """Return `` Did you mean 'x'?`` for the known name nearest to ``name``, else the list of known names.

    Examples
    --------
    >>> closest("twostag", ["hog", "twostage"])
    "Did you mean 'twostage'?"
    >>> closest("zzz", ["hog", "twostage"])
    'Known: hog, twostage.'
    """
    names = sorted(known)
    near = difflib.get_close_matches(name, names, n=1)
    if near:
        return f"Did you mean {near[0]!r}?"
    return f"Known: {', '.join(names) or 'none'}."
