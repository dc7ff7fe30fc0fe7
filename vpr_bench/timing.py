"""Where the time of one query goes.

A method marks its phases with ``with stage("encode"):``. Whoever wants to know collects them with
:func:`collect_stages`; when nobody does, a stage costs one context-variable look-up.
"""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_collector: ContextVar[dict[str, float] | None] = ContextVar("stage_collector", default=None)


@contextmanager
def stage(name: str) -> Iterator[None]:
    """Mark the code inside the ``with`` block as one phase of answering a query.

    Phases of the same name add up. The harness reports ``encode``, ``match`` and ``rerank`` apart; any other
    name is kept too.

    Examples
    --------
    >>> with collect_stages() as seconds:
    ...     with stage("encode"):
    ...         pass
    >>> sorted(seconds)
    ['encode']
    """
    collector = _collector.get()
    if collector is None:
        yield
        return
    start = time.perf_counter()
    try:
        yield
    finally:
        collector[name] = collector.get(name, 0.0) + time.perf_counter() - start


@contextmanager
def collect_stages() -> Iterator[dict[str, float]]:
    """Yield a dict that fills with the seconds spent in each stage inside the ``with`` block."""
    seconds: dict[str, float] = {}
    token = _collector.set(seconds)
    try:
        yield seconds
    finally:
        _collector.reset(token)
