import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.definitions import compute
from vpr_bench.metrics.losses import losses
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.survivors import gathered

N = 6
"""References of the map."""


def _survivors(**steps):
    """One list of references per query, None where nothing was ruled out."""
    count = len(next(iter(steps.values())))
    rows = [
        {name: None if lists[query] is None else np.array(lists[query], np.int32) for name, lists in steps.items()}
        for query in range(count)
    ]
    return gathered(rows)


def _losses(survivors, best, truth, unmatched="exclude", resamples=0):
    indices = np.array(best)[:, None]
    return losses(survivors, indices, np.zeros(indices.shape), truth, unmatched, resamples)


def _shares(steps):
    return [(step.name, step.recall.value, step.lost.value) for step in steps]


TRUTH = GroundTruth.from_lists([[0], [1, 2], [3], [4]], N)
STEPS = _survivors(coarse=[[0, 1], [2, 5], None, [0, 1]], fine=[[0], [5], [3], None])


def test_a_place_is_lost_where_its_last_true_match_is_ruled_out():
    steps = _losses(STEPS, [0, 5, 5, 0], TRUTH)
    assert _shares(steps) == [("coarse", 0.75, 0.25), ("fine", 0.5, 0.25), ("ranking", 0.25, 0.25)]
    assert [step.left for step in steps] == [(2 + 2 + 6 + 2) / 4, (1 + 1 + 1 + 2) / 4, 1]


def test_without_steps_there_is_nothing_to_say():
    assert _losses([], [0, 5, 5, 0], TRUTH) == []


def test_a_larger_radius_loses_less():
    queries, references = np.arange(4.0), np.arange(6.0)
    lost = [
        _losses(STEPS, [0, 5, 5, 0], GroundTruth.from_radius(queries, references, radius))[0].lost.value
        for radius in (0, 1, 2, 3)
    ]
    assert lost == sorted(lost, reverse=True) and lost[0] > lost[-1]


UNMATCHED = GroundTruth.from_lists([[0], [], [3], [4]], N)


@pytest.mark.parametrize("unmatched", ["exclude", "reject"])
def test_a_query_without_a_match_is_not_in_the_denominator(unmatched):
    steps = _losses(STEPS, [0, 5, 5, 0], UNMATCHED, unmatched)
    assert _shares(steps) == [
        ("coarse", 2 / 3, pytest.approx(1 / 3)),
        ("fine", 2 / 3, 0),
        ("ranking", 1 / 3, pytest.approx(1 / 3)),
    ]


def test_under_miss_the_map_loses_it_first():
    steps = _losses(STEPS, [0, 5, 5, 0], UNMATCHED, "miss")
    assert _shares(steps) == [
        ("no true match", 0.75, 0.25),
        ("coarse", 0.5, 0.25),
        ("fine", 0.5, 0),
        ("ranking", 0.25, 0.25),
    ]


def test_soft_matches_neither_keep_nor_lose():
    truth = TRUTH.with_soft(GroundTruth.from_lists([[], [5], [], []], N))
    indices = np.array([[0, 1], [5, 2], [5, 3], [0, 4]])  # the soft answer to the second is passed over
    coarse, fine, _ = losses(STEPS, indices, np.zeros((4, 2)), truth)
    assert (coarse.recall.value, fine.recall.value) == (0.75, 0.5)  # the second had only its soft one left
    steps = losses(_survivors(coarse=[None] * 4), indices, np.zeros((4, 2)), truth)
    assert _shares(steps) == [("coarse", 1, 0), ("ranking", 0.5, 0.5)]


def test_intervals_are_those_of_a_paired_bootstrap():
    steps = _losses(STEPS, [0, 5, 5, 0], TRUTH, resamples=300)
    assert 0 <= steps[0].lost.low < 0.25 < steps[0].lost.high <= 1
    all_kept = _losses(_survivors(coarse=[None] * 4), [0, 5, 5, 0], TRUTH, resamples=50)
    assert (all_kept[0].lost.low, all_kept[0].lost.high) == (0, 0)


def test_no_query_that_counts():
    steps = _losses(STEPS, [0, 5, 5, 0], GroundTruth.from_lists([[]] * 4, N))
    assert np.isnan([[step.left, step.recall.value, step.lost.value] for step in steps]).all()


@st.composite
def _runs(draw):
    count = draw(st.integers(1, 8))
    subset = st.sets(st.integers(0, N - 1), min_size=1)
    coarse = [draw(subset) for _ in range(count)]
    fine = [draw(st.none() | st.sets(st.sampled_from(sorted(left)), min_size=1)) for left in coarse]
    last = [left if narrower is None else narrower for left, narrower in zip(coarse, fine, strict=True)]
    best = [draw(st.sampled_from(sorted(left))) for left in last]
    truth = GroundTruth.from_lists([sorted(draw(st.sets(st.integers(0, N - 1)))) for _ in range(count)], N)
    survivors = _survivors(
        coarse=[sorted(left) for left in coarse], fine=[None if one is None else sorted(one) for one in fine]
    )
    return survivors, best, truth, draw(st.sampled_from(["exclude", "miss", "reject"]))


@given(_runs())
def test_the_losses_and_recall_make_one_whole(given_run):
    survivors, best, truth, unmatched = given_run
    indices = np.array(best)[:, None]
    answers = Answers.from_matches(indices, np.zeros(indices.shape), truth, unmatched)
    recall = compute(["recall@1"], answers)["recall@1"]
    steps = _losses(survivors, best, truth, unmatched)
    if np.isnan(recall):
        assert all(np.isnan(step.recall.value) for step in steps)
        return
    assert steps[-1].recall.value == recall
    assert sum(step.lost.value for step in steps) + recall == pytest.approx(1)
    assert all(step.lost.value >= 0 for step in steps)
