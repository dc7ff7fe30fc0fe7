import numpy as np
import pytest

from vpr_baselines.twostage.heads import LinearHead

HEAD = LinearHead(np.array([[1, 2], [3, 4]], np.float32), np.array([10, 20], np.float32))


def test_logits_are_weight_times_descriptor_plus_bias():
    assert HEAD.logits(np.array([1, -1], np.float32)).tolist() == [9, 19]


def test_many_descriptors_are_scored_at_once():
    assert HEAD.logits(np.array([[1, -1], [0, 0]], np.float32)).tolist() == [[9, 19], [10, 20]]


def test_centring_and_scaling_can_be_moved_into_the_layer():
    mean, scale, x = np.array([5, -3], np.float32), 4.0, np.array([0.5, 9], np.float32)
    assert HEAD.before(mean, scale).logits(x) == pytest.approx(HEAD.logits((x - mean) / scale))
    assert HEAD.before(mean, scale).weight.dtype == HEAD.before(mean, scale).bias.dtype == np.float32
