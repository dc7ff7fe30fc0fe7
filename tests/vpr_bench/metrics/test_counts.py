import warnings

import numpy as np

from vpr_bench.metrics.counts import Counts, ratio


def test_equal_scores_are_one_threshold():
    # At 3: one right. At 2: two right, one wrong. At 1: one wrong more.
    counts = Counts.sweep(np.array([0, 1, 1, 0, 1], bool), np.array([1.0, 2, 2, 2, 3]), np.ones(5))
    assert counts.thresholds.tolist() == [3, 2, 1]
    assert counts.true_positives.tolist() == [1, 3, 3]
    assert counts.false_positives.tolist() == [0, 1, 2]
    assert counts.precision.tolist() == [1, 3 / 4, 3 / 5]


def test_weights_count_and_keep_their_axes():
    weight = np.array([[1.0, 2.0], [0.0, 3.0]])
    counts = Counts.sweep(np.array([True, False]), np.array([2.0, 1.0]), weight)
    assert counts.true_positives.tolist() == [[1, 1], [0, 0]]
    assert counts.false_positives.tolist() == [[0, 2], [0, 3]]
    assert counts.precision.tolist() == [[1, 1 / 3], [1, 0]]  # precision is 1 where nothing is answered


def test_nothing_to_count():
    counts = Counts.sweep(np.zeros(0, bool), np.zeros(0), np.ones((7, 0)))
    assert counts.thresholds.shape == (0,) and counts.true_positives.shape == (7, 0)


def test_a_ratio_of_nothing_is_undefined_and_silent():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.isnan(ratio(np.float64(0), np.float64(0)))
        assert ratio(np.zeros(2), np.array([0.0, 1.0]), undefined=1.0).tolist() == [1, 0]
