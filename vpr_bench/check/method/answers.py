"""Whether what a method answers is an answer."""

from collections.abc import Sequence
from typing import Any

from vpr_bench.check.method.asking import ask, fit
from vpr_bench.check.method.subject import Subject
from vpr_bench.check.method.world import ANSWERS, PLACES, as_map, picture, revisited, usual_map, usual_queries
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.check.suite import check
from vpr_bench.method.faults import fault_in, shortfall_in, why_fewer
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
    if isinstance(answer, Match):
        try:
            answer = Match(answer.indices, answer.scores)  # arrays can be written to after they were checked
        except ValueError as error:
            return f"what is no Match: {error}"
    return fault_in(answer, n_references, k)


@check("answers-are-matches", "declares-parameters")
def answers_are_matches(subject: Subject) -> None:
    """Check that answers are at most k, indices unique and inside the map, scores finite and not increasing."""
    expect_matches(subject.usual_answers, PLACES, ANSWERS)
    method = subject.make()
    fit(method, usual_map())
    for k in (1, PLACES):
        expect_matches(ask(method, usual_queries()[:2], k, f"with k={k}"), PLACES, k, f"with k={k}")


@check("as-many-as-asked", "answers-are-matches")
def as_many_as_asked(subject: Subject) -> None:
    """Check that it answers with as many references as it is asked for, unless it declares why it may not."""
    method = subject.make()
    reason = why_fewer(method)
    if reason:
        raise Skipped(f"it may answer fewer: {reason}")
    fit(method, usual_map())
    for k, answers in ((ANSWERS, subject.usual_answers), (PLACES, ask(method, usual_queries()[:2], PLACES))):
        for query, answer in enumerate(answers):
            fault = shortfall_in(answer, method, PLACES, k)
            if fault:
                raise Failed(f"match answers query {query} with {fault}")


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


CHECKS = (answers_are_matches, as_many_as_asked, more_asked_than_there_are, map_of_one)
