"""The examples are the surest failures and the least sure successes, each with the place that was meant."""

import numpy as np
import pytest

from vpr_bench.page.examples import FAILURES, SUCCESSES, examples_of
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol


@pytest.fixture(scope="module")
def run(make_run):
    return make_run("some", wrong=10, seed=7)  # queries 2 to 11 are answered 6 places off


def test_failures_come_by_falling_and_successes_by_rising_score(run):
    found = examples_of(run, run.protocol)
    assert len(found.failures) == FAILURES and len(found.successes) == 2 < SUCCESSES
    scores = [one.score for one in found.failures]
    assert scores == sorted(scores, reverse=True)
    assert {one.query for one in found.failures} < set(range(2, 12))
    assert [one.query for one in found.successes] == [1, 0]


def test_each_names_the_answer_and_the_nearest_true_match(run):
    for one in examples_of(run, run.protocol).failures:
        assert one.answer == (one.query + 6) % 12
        assert (one.truth, one.away) == (one.query, 6)
        assert one.truth_rank is None and one.truth_score is None


def test_where_the_truth_was_answered_it_has_rank_and_score(make_run):
    run = make_run("some", wrong=0, seed=8)
    one = examples_of(run, Protocol.parse("tiny/day_left-day_right@0f")).successes[0]
    assert (one.truth, one.truth_rank, one.truth_score) == (one.answer, 1, one.score)


def changed(run, places, indices=None):
    """Return the run with other places and answers."""
    vars(run)["places"] = places
    if indices is not None:
        vars(run)["_matches"] = {**run._matches, "indices": indices}
    return run


def test_a_query_without_a_place_has_no_truth_and_may_be_left_unanswered(make_run):
    run = make_run("some", wrong=0, seed=9)
    indices = run.indices.copy()
    indices[3] = -1
    queries = np.arange(12.0)
    queries[[3, 4]] = 500
    run = changed(run, Places(queries, np.arange(12.0)), indices)
    missed = examples_of(run, Protocol.parse("tiny/day_left-day_right@1f~miss")).failures
    assert [(one.query, one.truth) for one in missed] == [(4, None), (3, None)]
    assert (missed[1].answer, missed[1].score, missed[1].away) == (None, None, None)
    rejected = examples_of(run, Protocol.parse("tiny/day_left-day_right@1f~reject")).failures
    assert [one.query for one in rejected] == [4]  # to leave 3 unanswered is right


def test_soft_matches_are_passed_over(make_run):
    run = make_run("some", wrong=0, seed=10)
    truth = GroundTruth.from_lists([[(query + 1) % 12] for query in range(12)], 12)
    soft = GroundTruth.from_lists([[query] for query in range(12)], 12)
    run = changed(run, Places(given=truth.with_soft(soft)))
    found = examples_of(run, Protocol.parse("tiny/day_left-day_right@given"))
    assert not found.failures
    assert all(one.answer == (one.query + 1) % 12 == one.truth for one in found.successes)
    assert all(one.away is None for one in found.successes)
