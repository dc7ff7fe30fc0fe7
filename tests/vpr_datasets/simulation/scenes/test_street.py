import hashlib
from functools import cache

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from vpr_datasets.simulation import SimulationSpec, render_frame
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.path import lay_course
from vpr_datasets.simulation.scene import build_scene
from vpr_datasets.simulation.scenes.street import street
from vpr_datasets.simulation.spec import TraverseSpec
from vpr_datasets.simulation.stage import Stage

BASE = {"seed": 5, "frames": 12, "width": 128, "height": 96, "step": 5.0, "curvature": 0.25}
LANES = {"street": (-4.85, -2.1), "boulevard": (-6.6, -3.9), "motorway": (-3.6, 0.0)}

# Raise SIMULATION_VERSION when these change, as in test_frame.py.
DIGESTS = {
    ("street", "second", 3): "0f8bfb8098635588308122d5a022d2dd8b14453a1ff83071591b39cec65ad7aa",
    ("street", "first", 9): "7732508d13b8cb9fe8fb949919f317903a66f57c1118fec6884b0c10b95071a3",
    ("boulevard", "second", 4): "2336a6bf92800d796997e42b7c11fc0c88463ed200f46ff42da28c4d049c6a6b",
    ("motorway", "second", 7): "a939d8059150605237dd3ea581e26dcd943c098e1eb0ae91250f5f2d9cfed19e",
}


def describe(scene: str) -> SimulationSpec:
    first, second = LANES[scene]
    traverses = [
        {"name": "first", "lateral": first, "eye_height": 1.6, "light": "overcast", "seed": 1},
        {"name": "second", "lateral": second, "eye_height": 2.4, "shake": 0.4, "seed": 2},
    ]
    return SimulationSpec.model_validate(BASE | {"scene": scene, "traverses": traverses})


@cache
def frame(scene: str, name: str, index: int) -> NDArray[np.uint8]:
    return render_frame(describe(scene), name, index)


@pytest.mark.parametrize(("scene", "name", "index"), list(DIGESTS))
def test_pixels_are_the_same_everywhere(scene: str, name: str, index: int) -> None:
    image = np.ascontiguousarray(frame(scene, name, index))
    assert hashlib.sha256(image.tobytes()).hexdigest() == DIGESTS[scene, name, index]


@pytest.mark.parametrize("scene", list(LANES))
def test_places_are_recognised_from_another_lane(scene: str) -> None:
    places = range(12)
    first, second = (np.stack([_hog(frame(scene, name, i)) for i in places]) for name in ("first", "second"))
    best = (second @ first.T).argmax(axis=1)
    # By chance it would be 0.24.
    assert np.mean(np.abs(best - np.arange(len(places))) <= 1) > 0.4


def test_what_does_not_move_is_the_same_on_all_traverses() -> None:
    spec = describe("street")
    first, second = (build_scene(spec, name) for name in ("first", "second"))
    fixed = 1000
    for one, other in ((first.walls.x0, second.walls.x0), (first.walls.high, second.walls.high)):
        np.testing.assert_array_equal(one[:fixed], other[:fixed])
    assert all(a is b for a, b in zip(first.walls.textures[:fixed], second.walls.textures[:fixed], strict=True))
    assert len(first.walls.textures) != len(second.walls.textures)


def test_without_traffic_the_lanes_are_empty() -> None:
    quiet, busy = (TraverseSpec(name="a", lateral=-2.1, traffic=traffic) for traffic in (0.0, 1.0))
    assert street.send_out(Dice(1), quiet, 60) == []
    movers = street.send_out(Dice(1), busy, 60)
    assert {mover.pace > 0 for mover in movers} == {True, False}
    # On the right one drives along the path, on the left towards the camera.
    assert all((mover.pace > 0) == (mover.lateral < 0) for mover in movers)


def test_who_drives_ahead_on_the_own_lane_turns_off_before_being_reached() -> None:
    course = lay_course(5, 300.0, 0.2, before=30.0, beyond=200.0)
    traverse = TraverseSpec(name="a", lateral=-2.1, traffic=1.0, step=5.0)
    gaps = []
    for mover in street.send_out(Dice(2), traverse, 60):
        for index in range(60):
            s = mover.meeting * 5.0 + (index - mover.meeting) * mover.pace
            stage = Stage(course)
            if mover.put is not None and mover.lateral == -2.1 and s < 450:
                mover.put(stage, s, mover.lateral)
                gaps += [s - index * 5.0 - mover.width / 2] * bool(stage.walls)
    assert 3.0 < min(gaps) < 12.0


def _hog(image: NDArray[np.uint8]) -> NDArray[np.float64]:
    grey = cv2.resize(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), (128, 96), interpolation=cv2.INTER_AREA)
    vector = np.asarray(cv2.HOGDescriptor((128, 96), (32, 32), (16, 16), (16, 16), 9).compute(grey)).ravel()
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)
