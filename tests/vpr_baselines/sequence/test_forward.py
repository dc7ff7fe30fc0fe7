import time

import numpy as np
import pytest

from vpr_baselines.sequence.forward import ForwardFilter, paced
from vpr_baselines.sequence.rows import contrasted
from vpr_bench.errors import UsageError
from vpr_bench.method.build import build_method
from vpr_bench.types.traverse import Traverse

from .conftest import N_PLACES, follow, frame


def filtered(table, motion_model, sharpness, jump):
    """Apply Bayes' rule with the motion model written as a matrix."""
    size = table.shape[1]
    motion = np.zeros((size, size))
    for here in range(size):
        for step, probability in enumerate(motion_model):
            if here + step < size:
                motion[here, here + step] = (1 - jump) * probability
        motion[here] += (1 - motion[here].sum()) / size
    belief = np.full(size, 1 / size)
    for number, row in enumerate(table):
        belief = (belief @ motion if number else belief) * np.exp(sharpness * contrasted(row, 0).astype(float))
        belief /= belief.sum()
    return belief


@pytest.mark.parametrize(
    ("v_max", "pace", "motion"),
    [(1, 0.5, [0.5, 0.5]), (2, 1, [1 / 3] * 3), (70, 35, [1 / 71] * 71), (1, 0.8, [0.2, 0.8])],
)
def test_the_belief_is_that_of_the_filter_written_as_a_matrix(similarities, walk, v_max, pace, motion):
    inner = similarities(np.arange(N_PLACES), strength=4)
    method = ForwardFilter(inner, contrast=0, v_max=v_max, pace=pace, sharpness=1.5, jump=0.05)
    method.fit(walk)
    for query in range(30):
        match = method.match(frame(query), N_PLACES)
    expected = filtered(inner.table[:30], motion, 1.5, 0.05)[match.indices]
    assert 1 / (1 + np.exp(-match.scores.astype(float))) == pytest.approx(expected, rel=1e-4, abs=1e-9)
    assert match.indices[0] == 29


@pytest.mark.parametrize(
    ("truth", "motion"),
    [
        (np.arange(60), {}),
        (np.arange(60), {"v_max": 6}),
        (np.arange(0, 60, 2), {"v_max": 4, "pace": 2.0}),
        (np.repeat(np.arange(30), 2), {"pace": 0.5}),
        (np.concatenate([np.arange(40, 60), np.arange(40)]), {}),
    ],
    ids=["as fast", "at times much faster", "twice as fast", "half as fast", "a jump back"],
)
def test_places_are_found_that_one_frame_does_not_tell(similarities, walk, truth, motion):
    inner = similarities(truth, strength=2)
    alone = inner.table.argmax(axis=1)
    found = np.array(follow(ForwardFilter(inner, contrast=0, sharpness=1, **motion), walk, len(truth)))
    assert np.mean(np.abs(alone - truth) <= 1) < 0.6
    assert np.mean(np.abs(found - truth) <= 1) > 0.75


def test_the_score_is_higher_where_the_belief_is_firmer(similarities, walk):
    method = ForwardFilter(similarities(np.arange(N_PLACES), strength=3), contrast=0, sharpness=1)
    method.fit(walk)
    scores = [method.match(frame(query), 1).scores[0] for query in range(N_PLACES)]
    assert np.mean(scores[20:]) > np.mean(scores[:5])


def test_nothing_is_left_after_a_reset(similarities, walk):
    method = ForwardFilter(similarities(np.arange(N_PLACES)))
    method.fit(walk)
    first = [method.match(frame(query), 5).scores for query in range(12)]
    method.reset()
    assert np.array_equal(first, [method.match(frame(query), 5).scores for query in range(12)])


def test_certainty_is_finite(similarities, walk):
    inner = similarities(np.arange(N_PLACES), strength=1e4)
    method = ForwardFilter(inner, contrast=0, sharpness=200)
    method.fit(walk)
    for query in range(N_PLACES):
        assert np.isfinite(method.match(frame(query), N_PLACES).scores).all()


def test_a_map_of_one(similarities):
    method = ForwardFilter(similarities(np.zeros(3, dtype=int), n_references=1))
    method.fit(Traverse("one", [frame(0)]))
    assert [method.match(frame(query), 5).indices.tolist() for query in range(3)] == [[0]] * 3


@pytest.mark.parametrize(
    ("fastest", "mean"), [(1, 0.5), (2, 1), (3, 1), (20, 10.5), (5, 0.001), (5, 4.999), (200, 1.0)]
)
def test_the_motion_has_its_mean_and_is_as_even_as_can_be(fastest, mean):
    motion = paced(fastest, mean)
    assert motion.shape == (fastest + 1,) and (motion >= 0).all()
    assert motion.sum() == pytest.approx(1)
    assert motion @ np.arange(fastest + 1) == pytest.approx(mean, rel=1e-6)
    ratios = motion[1:][motion[1:] > 1e-200] / motion[:-1][motion[1:] > 1e-200]
    assert ratios == pytest.approx(ratios[0])


@pytest.mark.parametrize(
    "parameters",
    [
        {"v_max": 0},
        {"pace": 0},
        {"pace": 2},
        {"v_max": 1},
        {"sharpness": 0},
        {"jump": 0},
        {"jump": 1.5},
        {"contrast": -1},
    ],
)
def test_parameters_that_make_no_sense_are_refused(parameters):
    with pytest.raises(UsageError, match="Got"):
        build_method("hmm", parameters)


def test_a_long_map_costs_little(similarities):
    """3,400 references, the size of Nordland 64 × 32: at most 10 ms on top of the method inside."""
    method = ForwardFilter(similarities(np.zeros(20, dtype=int), n_references=3400))
    method.fit(Traverse("long", [frame(0)] * 3400))
    times = []
    for query in range(20):
        start = time.perf_counter()
        method.match(frame(query), 20)
        times.append(time.perf_counter() - start)
    assert np.median(times) < 0.010
