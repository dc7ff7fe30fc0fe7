"""What must come out the same."""

import numpy as np

from vpr_bench.check.method.agreement import expect_same
from vpr_bench.check.method.asking import ask, blaming_method, fit
from vpr_bench.check.method.subject import Subject
from vpr_bench.check.method.world import ANSWERS, PLACES, as_map, picture, revisited, usual_map, usual_queries
from vpr_bench.check.outcome import Skipped
from vpr_bench.check.suite import check
from vpr_bench.method.interfaces import Batched, is_sequential


@check("same-seed-same-answer", "answers-are-matches")
def same_seed_same_answer(subject: Subject) -> None:
    """Check that two new methods of the same parameters and seed answer the same, bit by bit."""
    method = subject.make()
    fit(method, usual_map())
    again = ask(method, usual_queries(), ANSWERS)
    expect_same(subject.usual_answers, again, "another one of the same seed", exactly=True)


@check("batch-equals-single", "same-seed-same-answer")
def batch_equals_single(subject: Subject) -> None:
    """Check that a batch of queries is answered as one query after the other."""
    method = subject.make()
    if not isinstance(method, Batched):
        raise Skipped("it has no match_batch")
    fit(method, usual_map())
    if is_sequential(method):
        method.reset()  # type: ignore[attr-defined]
    with blaming_method("match_batch"):
        batch = method.match_batch(usual_queries(), ANSWERS)
    expect_same(subject.usual_answers, batch, "in a batch")


@check("refit-forgets", "same-seed-same-answer")
def refit_forgets(subject: Subject) -> None:
    """Check that fitting again forgets the former map, whether it was larger or smaller."""
    small, queries = as_map(picture(place) for place in (101, 102, 103, 104)), revisited([102, 1])
    method, other = subject.make(), subject.make()
    fit(other, small)
    expected = ask(other, queries, ANSWERS)
    fit(method, usual_map())
    ask(method, usual_queries()[:2], ANSWERS)
    fit(method, small)
    expect_same(expected, ask(method, queries, ANSWERS), "on a map that was not the first", exactly=True)
    fit(other, usual_map())
    again = ask(other, usual_queries(), ANSWERS)
    expect_same(subject.usual_answers, again, f"on a map of {PLACES} after one of {len(small)}", exactly=True)


@check("reset-forgets", "same-seed-same-answer")
def reset_forgets(subject: Subject) -> None:
    """Check that after a reset a sequence method knows nothing of the queries before."""
    method = subject.make()
    if not is_sequential(method):
        raise Skipped("it is not sequential")
    fit(method, usual_map())
    ask(method, revisited(np.arange(PLACES)[::-1].tolist()), ANSWERS)
    again = ask(method, usual_queries(), ANSWERS)  # resets it first
    expect_same(subject.usual_answers, again, "after other queries and a reset", exactly=True)


CHECKS = (same_seed_same_answer, batch_equals_single, refit_forgets, reset_forgets)
