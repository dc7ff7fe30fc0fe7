"""Whose code may be run for the name of a method: a map that somebody sent must not name a file that is then run."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from vpr_bench.errors import UsageError
from vpr_bench.registry import NOT_INSTALLED, Entry

_trusted: ContextVar[frozenset[str] | None] = ContextVar("trusted_methods", default=None)


class UntrustedError(UsageError):
    """A method that is not installed was named by something else than the user."""


@contextmanager
def registered_only(besides: Iterable[str] = ()) -> Iterator[None]:
    """Refuse, inside the ``with`` block, all methods but those of installed packages and those named ``besides``.

    It reaches the methods inside others too.
    """
    token = _trusted.set(frozenset(besides))
    try:
        yield
    finally:
        _trusted.reset(token)


def check_trusted(name: str, entry: Entry) -> None:
    """Refuse a method whose code would be run for its name alone.

    Raises
    ------
    UntrustedError
        Inside :func:`registered_only`, if it is neither installed nor one of the exceptions.
    """
    trusted = _trusted.get()
    if trusted is not None and entry.origin == NOT_INSTALLED and name not in trusted:
        raise UntrustedError(f"The method {name!r:.200} is not installed, and its code is not run for its name alone.")
