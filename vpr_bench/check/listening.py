"""Hearing of what a process does: files it opens, connections it makes.

Python tells its audit hooks of both (PEP 578). What compiled libraries do by themselves is not heard.
"""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

Listener = Callable[[str, tuple[Any, ...]], None]
"""Called with the name of an event and its arguments; what it raises stops what was about to be done."""

_listeners: list[Listener] = []
_hooked: list[bool] = []


@contextmanager
def listening(listener: Listener) -> Iterator[None]:
    """Send all events inside the ``with`` block to ``listener``, those of other threads too."""
    if not _hooked:  # it can never be taken away again, so only who checks something pays for it
        sys.addaudithook(_hook)
        _hooked.append(True)
    _listeners.append(listener)
    try:
        yield
    finally:
        _listeners.remove(listener)


def _hook(event: str, arguments: tuple[Any, ...]) -> None:
    for listener in _listeners:
        listener(event, arguments)
