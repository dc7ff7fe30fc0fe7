"""Methods made again from what a file says of them: where code is that is not installed, only the user says.

Runs, baselines and maps may come from anybody. They name methods, and methods inside these, by what results call them:
of a file only its name, without folders.
"""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager

from vpr_bench.errors import UsageError
from vpr_bench.method.build import find_method
from vpr_bench.method.trust import UntrustedError, registered_only


def called(name: str) -> str:
    """Return what results call the method that a user names.

    Raises
    ------
    UsageError
        If there is none.
    """
    entry, preset = find_method(name)
    return entry.name if preset is None else name


def places_of(names: Mapping[str, str]) -> dict[str, str]:
    """Return what the user calls methods, by what results call them.

    Parameters
    ----------
    names : mapping
        The other way round.

    Raises
    ------
    UsageError
        If two of them have one name in results.

    Examples
    --------
    >>> places_of({"hog": "hog", "methods/mine.py:Mine": "mine.py:Mine"})
    {'hog': 'hog', 'mine.py:Mine': 'methods/mine.py:Mine'}
    """
    places: dict[str, str] = {}
    for name, method in names.items():
        if method in places:
            both = f"{places[method]!r} and {name!r}"
            raise UsageError(f"{both} are both called {method!r} in results: name only one of them.")
        places[method] = name
    return places


@contextmanager
def rebuilding(
    places: Mapping[str, str] | None = None, besides: Iterable[str] = (), option: str = "--method"
) -> Iterator[None]:
    """Inside the ``with`` block, build methods by their names in results; of others than these no code is run.

    Parameters
    ----------
    places : mapping, optional
        As :func:`places_of` returns it.
    besides : iterable of str
        What the user names in other ways.
    option : str
        With which methods are named.

    Raises
    ------
    UsageError
        If a method is not installed, and not named by the user; says how to name it.
    """
    try:
        with registered_only(besides, places):
            yield
    except UntrustedError as error:
        raise UsageError(f"{error} If you trust it, say where it is with {option} path/to/file.py:Class.") from None
