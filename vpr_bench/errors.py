"""What can go wrong, and the exit code that each kind carries.

Every error a user can cause is a :class:`VprBenchError`: its message says what was wrong, what was found and
what to do next, in one or two lines. The command line prints the message and exits with ``exit_code``.
"""

import difflib
from collections.abc import Iterable


class VprBenchError(Exception):
    """Base of all errors that the command line reports without a traceback (exit code 1: a check failed)."""

    exit_code = 1


class UsageError(VprBenchError):
    """Something was asked for that does not exist or makes no sense (exit code 2)."""

    exit_code = 2


class DataError(VprBenchError):
    """Images, weights or stored results are missing or damaged (exit code 3)."""

    exit_code = 3


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
