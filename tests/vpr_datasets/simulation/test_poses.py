import math

import numpy as np
import pytest

from vpr_datasets.simulation import SimulationSpec
from vpr_datasets.simulation.poses import heading, poses

SPEC = SimulationSpec.model_validate(
    {
        "seed": 3,
        "frames": 20,
        "step": 2.0,
        "traverses": [
            {"name": "a", "shake": 0, "pace_variation": 0},
            {"name": "b", "shake": 0, "pace_variation": 0, "lateral": 1.5, "start": 4.0, "frames": 9},
        ],
    }
)


def test_heading_is_the_arc_tangent() -> None:
    for step in range(720):
        angle = math.radians(step / 2)
        turn = heading(math.sin(angle), math.cos(angle)) - step / 2
        assert min(abs(turn), abs(turn - 360)) < 1e-9


def test_poses_follow_the_path() -> None:
    first = poses(SPEC, "a")
    way = np.diff(first[:, :2], axis=0)
    np.testing.assert_allclose(np.linalg.norm(way, axis=1), 2.0, atol=0.02)
    looks = np.degrees(np.arctan2(way[:, 0], way[:, 1]))
    assert np.abs(looks - first[:-1, 2]).max() < 12


def test_a_traverse_beside_another_is_as_far_away_as_it_says() -> None:
    first, second = poses(SPEC, "a"), poses(SPEC, "b")
    assert second.shape == (9, 3)
    apart = np.linalg.norm(second[:, :2] - first[2:11, :2], axis=1)
    np.testing.assert_allclose(apart, 1.5, atol=1e-6)


def test_an_unknown_traverse_is_refused() -> None:
    with pytest.raises(ValueError, match="no traverse 'c'"):
        poses(SPEC, "c")
