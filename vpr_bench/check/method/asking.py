"""Fitting a method and asking it as a run does."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from vpr_bench.check.examination import in_words
from vpr_bench.check.method.world import Image
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.method.interfaces import Foresighted, Method, frames_ahead, is_sequential
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse


@contextmanager
def blaming_method(doing: str) -> Iterator[None]:
    """Turn what a method raises inside the ``with`` block into a failure that says what it was doing."""
    try:
        yield
    except (Failed, Skipped):
        raise
    except Exception as error:
        raise Failed(f"{doing} raises {in_words(error)}") from error


def fit(method: Method, references: Traverse, what: str = "") -> None:
    """Fit a method.

    Raises
    ------
    Failed
        If it raises; ``what`` says what is special about the map.
    """
    with blaming_method(f"fit{what and ' ' + what}"):
        method.fit(references)


def ask(method: Method, queries: Sequence[Image], k: int, what: str = "") -> list[Match]:
    """Ask a fitted method one query after the other; a sequential one takes them for one sequence.

    Raises
    ------
    Failed
        If it raises; ``what`` says what is special about the queries.
    """
    answers = []
    with blaming_method(f"match{what and ' ' + what}"):
        if is_sequential(method):
            method.reset()  # type: ignore[attr-defined]
        horizon, shown = frames_ahead(method), 0
        for index, image in enumerate(queries):
            if horizon and isinstance(method, Foresighted):
                until = min(index + horizon + 1, len(queries))
                for frame in queries[shown:until]:
                    method.foresee(frame)
                shown = until
            answers.append(method.match(image, k))
    return answers
