import time

import numpy as np
import pytest

from vpr_baselines.sequence.rows import contrasted
from vpr_baselines.sequence.seqslam import SeqSlam
from vpr_bench.errors import UsageError
from vpr_bench.method.build import build_method

from .conftest import N_PLACES, follow, frame


def searched(table, query, past, future, velocities):
    """Search along lines as the paper does: one reference, velocity and frame after the other."""
    rows = [contrasted(row, 0) for row in table]
    frames = range(max(query - past, 0), min(query + future, len(rows) - 1) + 1)
    best = np.full(table.shape[1], -np.inf)
    for reference in range(table.shape[1]):
        for velocity in velocities:
            places = [reference - round(velocity * (query - one)) for one in frames]
            on_map = [rows[one][place] for one, place in zip(frames, places, strict=True) if 0 <= place < len(rows[0])]
            best[reference] = max(best[reference], sum(on_map) / len(frames))
    return best


@pytest.mark.parametrize(("past", "future"), [(4, 0), (0, 0), (0, 3), (5, 2), (80, 0)])
def test_scores_are_those_of_the_search_written_as_loops(similarities, walk, past, future):
    inner = similarities(np.arange(N_PLACES))
    method = SeqSlam(inner, contrast=0, past=past, future=future, v_min=0.5, v_max=1.5)
    method.fit(walk)
    velocities = np.linspace(0.5, 1.5, 11)
    seen = 0
    for query in range(20):
        while future and seen <= query + future:
            method.foresee(frame(seen))
            seen += 1
        match = method.match(frame(query), N_PLACES)
        expected = searched(inner.table, query, past, future, velocities)
        assert match.scores == pytest.approx(expected[match.indices], abs=1e-5)


@pytest.mark.parametrize(
    ("truth", "parameters"),
    [
        (np.arange(50), {}),
        (np.arange(0, 50, 2), {"v_max": 2.0}),
        (np.repeat(np.arange(25), 2), {"v_min": 0.5}),
        (np.full(40, 17), {"v_min": 0.0, "v_max": 0.0}),
        (np.concatenate([np.arange(40, 60), np.arange(20)]), {"past": 6}),  # a loop: back to the beginning
    ],
    ids=["as fast", "twice as fast", "half as fast", "standing", "in two parts"],
)
def test_places_are_found_that_one_frame_does_not_tell(similarities, walk, truth, parameters):
    inner = similarities(truth, strength=2)
    alone = inner.table.argmax(axis=1)
    found = np.array(follow(SeqSlam(inner, contrast=0, **parameters), walk, len(truth)))
    assert np.mean(np.abs(alone - truth) <= 1) < 0.6
    assert np.mean(np.abs(found - truth) <= 1) > 0.75


def test_every_frame_is_described_once(similarities, walk):
    inner = similarities(np.arange(N_PLACES))
    follow(SeqSlam(inner, past=7), walk)
    assert inner.asked == N_PLACES


def test_the_first_answer_is_that_of_the_method_inside(similarities, walk):
    inner = similarities(np.arange(N_PLACES))
    assert follow(SeqSlam(inner, contrast=0), walk, 1)[0] == inner.table[0].argmax()


def test_nothing_is_left_after_a_reset(similarities, walk):
    method = SeqSlam(similarities(np.arange(N_PLACES)), past=5)
    method.fit(walk)
    first = [method.match(frame(query), 5).scores for query in range(12)]
    method.reset()
    again = [method.match(frame(query), 5).scores for query in range(12)]
    assert np.array_equal(first, again)


def test_the_window_forgets_what_is_older(similarities, walk):
    inner = similarities(np.arange(N_PLACES))
    whole, late = SeqSlam(inner, past=4), SeqSlam(inner, past=4)
    follow(whole, walk, 20)
    late.fit(walk)
    for query in range(16, 20):
        late.match(frame(query), 3)
    assert np.array_equal(whole.match(frame(20), 9).scores, late.match(frame(20), 9).scores)


def test_frames_after_the_query_help(similarities, walk):
    truth = np.arange(N_PLACES)
    blind, seeing = (SeqSlam(similarities(truth, 2), contrast=0, past=3, future=future) for future in (0, 6))
    seeing.fit(walk)
    found = []
    for query in range(N_PLACES):
        for ahead in range(0 if query == 0 else query + 6, min(query + 7, N_PLACES)):
            seeing.foresee(frame(ahead))
        found.append(int(seeing.match(frame(query), 1).indices[0]))
    assert np.mean(np.array(found) == truth) > np.mean(np.array(follow(blind, walk)) == truth)


@pytest.mark.parametrize("size", [1, 2, 5])
def test_a_map_shorter_than_the_window(similarities, size):
    from vpr_bench.types.traverse import Traverse

    inner = similarities(np.zeros(20, dtype=int), n_references=size)
    method = SeqSlam(inner, past=10, future=2)
    method.fit(Traverse("short", [frame(0)] * size))
    assert len(method.match(frame(0), 20)) == size
    assert np.isfinite([method.match(frame(query), 1).scores[0] for query in range(1, 20)]).all()


@pytest.mark.parametrize(
    "parameters", [{"past": -1}, {"future": -1}, {"v_min": -0.1}, {"contrast": -1}, {"v_min": 1.5}, {"v_max": "fast"}]
)
def test_parameters_that_make_no_sense_are_refused(parameters):
    with pytest.raises(UsageError, match="Got"):
        build_method("seqslam", parameters)


def test_a_long_map_costs_little(similarities):
    """3,400 references with 20 frames of past, the size of Nordland 64 × 32: at most 10 ms on top of the inner one."""
    from vpr_bench.types.traverse import Traverse

    method = SeqSlam(similarities(np.zeros(40, dtype=int), n_references=3400), past=20)
    method.fit(Traverse("long", [frame(0)] * 3400))
    times = []
    for query in range(40):
        start = time.perf_counter()
        method.match(frame(query), 20)
        times.append(time.perf_counter() - start)
    assert np.median(times[20:]) < 0.010
