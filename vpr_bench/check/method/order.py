"""Whether answers come from what is seen, and not from when it is seen or where it lies in the map."""

from collections.abc import Sequence

import numpy as np

from vpr_bench.check.method.agreement import expect_same
from vpr_bench.check.method.asking import ask, fit
from vpr_bench.check.method.subject import Subject
from vpr_bench.check.method.world import ANSWERS, PLACES, as_map, picture, revisited, usual_map, usual_queries
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.check.suite import check
from vpr_bench.method.interfaces import Method, is_sequential
from vpr_bench.types.match import Match

_SHUFFLED = (3, 0, 4, 1, 5, 2)
"""No query comes where it lies in the map, nor after its neighbour."""

_ROUTE = 40
"""Places of the map that sequences are driven on."""

_FRAMES = 10
_DRIVES = [[start, *range(after, after + _FRAMES - 1)] for start, after in ((9, 16), (21, 6), (4, 27))]
"""After its first frame, each drive goes on somewhere else: who has seen where it starts still cannot count."""

_SCRAMBLED = 18
"""Enough places for methods that cluster them to make more than one cluster."""


@check("finds-the-same-image", "answers-are-matches")
def finds_the_same_image(subject: Subject) -> None:
    """Check that each reference, shown as a query, is found.

    A sequence method is shown the whole map as a sequence.
    """
    method = subject.make()
    fit(method, usual_map())
    answers = ask(method, list(usual_map()), 1)
    settled = PLACES // 2 if is_sequential(method) else 0  # it may take some frames to know where it is
    for place, answer in list(enumerate(answers))[settled:]:
        if place not in answer.indices.tolist():
            named = answer.indices.tolist()[0] if len(answer) else "nothing"
            raise Failed(f"reference {place} of {PLACES}, shown as a query, is answered with {named}")


@check("no-leak-through-order", "same-seed-same-answer")
def no_leak_through_order(subject: Subject) -> None:
    """Check that what it scores on ordered queries it scores, too, where order tells nothing.

    Methods for single images are shown the queries shuffled, sequence methods drives with other starts and skipped
    frames, through the very images of the map: this is not about recognising them on another day. Whoever counts
    instead of looking loses nearly all.
    """
    method = subject.make()
    if is_sequential(method):
        fit(method, as_map(picture(place) for place in range(_ROUTE)))
        ordered = _share_right(method, range(_FRAMES))
        elsewhere = float(np.mean([_share_right(method, drive) for drive in _DRIVES]))
        how = "with other starts and skipped frames"
    else:
        fit(method, usual_map())
        ordered = _share_right(method, range(PLACES))
        elsewhere = _share_right(method, _SHUFFLED)
        how = "shuffled"
    if ordered >= 0.5 and elsewhere < ordered / 2:
        raise Failed(
            f"{ordered:.0%} of queries in the order of the map are right, but {elsewhere:.0%} {how}: "
            "it counts queries instead of looking at them"
        )


def _share_right(method: Method, places: Sequence[int]) -> float:
    """Return the share of places that are named when they are shown."""
    answers = ask(method, [picture(place) for place in places], 1)
    right = [len(one) > 0 and one.indices[0] == place for place, one in zip(places, answers, strict=True)]
    return float(np.mean(right))


@check("permuted-queries", "no-leak-through-order")
def permuted_queries(subject: Subject) -> None:
    """Check that a query is answered the same whatever came before it."""
    method = subject.make()
    if is_sequential(method):
        raise Skipped("it is sequential: what came before counts")
    fit(method, usual_map())
    queries = usual_queries()
    answers = ask(method, [queries[place] for place in _SHUFFLED], ANSWERS)
    in_order = [answers[_SHUFFLED.index(place)] for place in range(PLACES)]
    expect_same(subject.usual_answers, in_order, "in another order of queries", exactly=True)


@check("permuted-references", "no-leak-through-order", "finds-the-same-image")
def permuted_references(subject: Subject) -> None:
    """Check that on the same map in another order the same places are named, with scores that only rounding changes."""
    method, other = subject.make(), subject.make()
    if is_sequential(method):
        raise Skipped("it is sequential: the order of the map counts")
    order = np.random.default_rng(7).permutation(_SCRAMBLED)
    fit(method, as_map(picture(place) for place in range(_SCRAMBLED)))
    fit(other, as_map(picture(place) for place in order.tolist()))
    queries = revisited([2, 8, 15])
    renamed = [Match(order[one.indices], one.scores) for one in ask(other, queries, ANSWERS)]
    expect_same(ask(method, queries, ANSWERS), renamed, "on the same map in another order")


CHECKS = (finds_the_same_image, no_leak_through_order, permuted_queries, permuted_references)
