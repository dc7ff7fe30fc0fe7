"""Which references are still in the running after each step of answering one query.

A method that rules references out step by step notes what is left with ``shortlist("clusters", indices)``. Whoever
wants to know collects the notes with :func:`collect_shortlists`; when nobody does, a note costs one context-variable
look-up.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Shortlists = dict[str, NDArray[Any] | None]
"""The notes of one query, by step in the order in which they came; None where a step ruled nothing out."""

_collector: ContextVar[Shortlists | None] = ContextVar("shortlist_collector", default=None)


def shortlist(step: str, indices: ArrayLike | None) -> None:
    """Note, inside ``match``, which references are still in the running after a step.

    Parameters
    ----------
    step : str
        Any name. The steps of a query are in the order in which they are noted; each is noted at most once, and what
        one has ruled out stays out.
    indices : (m,) integers or None
        References, unique, in any order. None if the step ruled nothing out: then what was in the running before it
        still is.

    Raises
    ------
    ValueError
        If the step has been noted already. Whether the indices are any is checked by whoever collects them.

    Examples
    --------
    >>> with collect_shortlists() as shortlists:
    ...     shortlist("clusters", [4, 5, 6, 7])
    ...     shortlist("components", [5, 7])
    >>> {step: indices.tolist() for step, indices in shortlists.items()}
    {'clusters': [4, 5, 6, 7], 'components': [5, 7]}
    """
    collector = _collector.get()
    if collector is None:
        return
    if step in collector:
        raise ValueError(f"the shortlist {step!r} was noted twice for one query")
    collector[step] = None if indices is None else np.array(indices)  # a copy: the method may reuse its array


@contextmanager
def collect_shortlists() -> Iterator[Shortlists]:
    """Yield a dict that fills with what is noted inside the ``with`` block, and is not noted outside it."""
    shortlists: Shortlists = {}
    token = _collector.set(shortlists)
    try:
        yield shortlists
    finally:
        _collector.reset(token)
