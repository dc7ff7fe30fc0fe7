"""Whose code may be run for the name of a method: a map that somebody sent must not name a file that is then run."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

from vpr_bench.errors import UsageError
from vpr_bench.registry import NOT_INSTALLED, Entry


@dataclass(frozen=True)
class _Trust:
    names: frozenset[str]
    places: Mapping[str, str]


_trust: ContextVar[_Trust | None] = ContextVar("trust", default=None)


class UntrustedError(UsageError):
    """A method that is not installed was named by something else than the user."""


@contextmanager
def registered_only(besides: Iterable[str] = (), places: Mapping[str, str] | None = None) -> Iterator[None]:
    """Refuse, inside the ``with`` block, all methods but those of installed packages and those that the user names.

    It reaches the methods inside others too.

    Parameters
    ----------
    besides : iterable of str
        Names of methods, as the user wrote them.
    places : mapping, optional
        What results call a method to what the user calls it, who names these too: the one is then taken for the other.
    """
    places = dict(places or {})
    token = _trust.set(_Trust(frozenset([*besides, *places.values()]), places))
    try:
        yield
    finally:
        _trust.reset(token)


def place_of(name: str) -> str:
    """Return what the user calls a method, inside :func:`registered_only`; the name itself if they say nothing."""
    trust = _trust.get()
    return name if trust is None else trust.places.get(name, name)


def check_trusted(name: str, entry: Entry) -> None:
    """Refuse a method whose code would be run for its name alone.

    Raises
    ------
    UntrustedError
        Inside :func:`registered_only`, if it is neither installed nor one of the exceptions.
    """
    trust = _trust.get()
    if trust is not None and entry.origin == NOT_INSTALLED and name not in trust.names:
        raise UntrustedError(f"The method {name!r:.200} is not installed, and its code is not run for its name alone.")
