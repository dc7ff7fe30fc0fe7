"""Progress of long work, told to whoever listens.

Library code wraps its loops in :func:`track`; nothing is printed unless a listener is installed with
:func:`listen`, as the command line does when stderr is a terminal. It costs one context-variable look-up
per loop otherwise.
"""

from collections.abc import Callable, Iterable, Iterator, Sized
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar
from typing import TypeVar

T = TypeVar("T")

Advance = Callable[[int], None]
"""Called with the number of steps done since the last call."""

Listener = Callable[[str, int | None], AbstractContextManager[Advance]]
"""Opens one bar, given a description and the number of steps (None: unknown)."""

_listener: ContextVar[Listener | None] = ContextVar("progress_listener", default=None)


@contextmanager
def listen(listener: Listener) -> Iterator[None]:
    """Send the progress of everything inside the ``with`` block to ``listener``."""
    token = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(token)


@contextmanager
def task(description: str, total: int | None = None) -> Iterator[Advance]:
    """Open one piece of long work; call what it yields with the number of steps done.

    Examples
    --------
    >>> with task("Rendering", total=2) as advance:
    ...     advance(1)
    ...     advance(1)
    """
    listener = _listener.get()
    if listener is None:
        yield lambda steps: None
        return
    with listener(description, total) as advance:
        yield advance


def track(items: Iterable[T], description: str, total: int | None = None) -> Iterator[T]:
    """Iterate over ``items`` and report each as one step.

    Examples
    --------
    >>> list(track([1, 2, 3], "Counting"))
    [1, 2, 3]
    """
    if total is None and isinstance(items, Sized):
        total = len(items)
    if total == 0:
        return  # a bar of no length would say nothing
    with task(description, total) as advance:
        for item in items:
            yield item
            advance(1)
