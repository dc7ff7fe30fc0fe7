"""Whether what a method answers is an answer."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from vpr_bench.check.method.asking import ask, fit
from vpr_bench.check.method.subject import Subject
from vpr_bench.check.method.world import ANSWERS, PLACES, as_map, picture, revisited, usual_map, usual_queries
from vpr_bench.check.outcome import Failed
from vpr_bench.check.suite import check
from vpr_bench.types.match import Match


def expect_matches(answers: Sequence[Any], n_references: int, k: int, what: str = "") -> None:
    """Refuse answers that are none.

    Raises
    ------
    Failed
        At the first one; ``what`` says what is special about the queries.
    """
    for query, answer in enumerate(answers):
        fault = _fault(answer, n_references, k)
        if fault:
            raise Failed(f"match{what and ' ' + what} answers query {query} with {fault}")


def _fault(answer: Any, n_references: int, k: int) -> str:
    if not isinstance(answer, Match):
        return f"a {type(answer).__name__} instead of a Match"
    try:
        again = Match(answer.indices, answer.scores)  # arrays can be written to after they were checked
    except ValueError as error:
        return f"what is no Match: {error}"
    if len(again) > k:
        return f"{len(again)} references where {k} were asked for"
    if again.indices.max(initial=-1) >= n_references:
        return f"reference {np.max(again.indices)} of a map of {n_references}"
    return ""


@check("answers-are-matches", "declares-parameters")
def answers_are_matches(subject: Subject) -> None:
    """Check that answers are at most k, indices unique and inside the map, scores finite and not increasing."""
    expect_matches(subject.usual_answers, PLACES, ANSWERS)
    method = subject.make()
    fit(method, usual_map())
    for k in (1, PLACES):
        expect_matches(ask(method, usual_queries()[:2], k, f"with k={k}"), PLACES, k, f"with k={k}")


@check("more-asked-than-there-are", "answers-are-matches")
def more_asked_than_there_are(subject: Subject) -> None:
    """Check that a k that is larger than the map does no harm."""
    method, size = subject.make(), 2
    fit(method, as_map(picture(place) for place in range(size)))
    what = f"with k larger than the map of {size}"
    for k in (size + 1, 50):
        expect_matches(ask(method, revisited([0, 1]), k, what), size, k, what)


@check("map-of-one", "answers-are-matches")
def map_of_one(subject: Subject) -> None:
    """Check that a map may have a single reference."""
    method, what = subject.make(), "on a map of one"
    fit(method, as_map([picture(0)]), what)
    expect_matches(ask(method, revisited([0, 1]), 1, what), 1, 1, what)


CHECKS = (answers_are_matches, more_asked_than_there_are, map_of_one)
