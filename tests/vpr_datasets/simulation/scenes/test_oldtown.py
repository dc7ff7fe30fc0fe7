import hashlib
from functools import cache

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from vpr_datasets.simulation import SimulationSpec, render_frame
from vpr_datasets.simulation.scene import build_scene, course_of
from vpr_datasets.simulation.scenes.oldtown import archive, today

OPTIONS = {
    "seed": 5,
    "scene": "oldtown",
    "frames": 8,
    "width": 128,
    "height": 96,
    "step": 12.0,
    "curvature": 0.28,
    "gaze": 0.6,
    "traverses": [
        {"name": "new", "seed": 1},
        {"name": "old", "epoch": "archive", "light": "overcast", "seed": 2, "height": 88, "focal_length": 0.95},
    ],
}
SPEC = SimulationSpec.model_validate(OPTIONS)

# Raise SIMULATION_VERSION when these change, as in test_frame.py.
DIGESTS = {
    ("new", 4): "2f6d7720a300ab8561904ab36160f1c4ea535c3f8a71eeb210ecdd4340abccbf",
    ("old", 6): "6048caf9ad4bc734da845dd19d6d57496079045032b50226fe94734e464ed3f7",
}


@cache
def frame(name: str, index: int) -> NDArray[np.uint8]:
    return render_frame(SPEC, name, index)


@pytest.mark.parametrize(("name", "index"), list(DIGESTS))
def test_pixels_are_the_same_everywhere(name: str, index: int) -> None:
    image = np.ascontiguousarray(frame(name, index))
    assert hashlib.sha256(image.tobytes()).hexdigest() == DIGESTS[name, index]


def test_archive_photographs_are_prints_without_colours() -> None:
    for index in range(8):
        old, new = frame("old", index).astype(int), frame("new", index).astype(int)
        assert old.shape == (88, 128, 3)
        assert new.shape == (96, 128, 3)
        # One tone for the whole print: its channels differ by little, and always in the same way.
        assert np.ptp(old, axis=-1).mean() < 40
        grey = old.reshape(-1, 3)
        assert np.corrcoef(grey[:, 0], grey[:, 2])[0, 1] > 0.97
    assert np.mean([np.ptp(frame("new", index).astype(int), axis=-1).mean() for index in range(8)]) > 15


def test_some_houses_have_been_replaced_since() -> None:
    course = course_of(SPEC)
    stages = [time.lay_out(5, "summer", course, SPEC.length) for time in (today, archive)]
    # Fronts with their gables: everything else is lower, or shared by many houses.
    fronts = [
        {id(wall.texture): wall.left for wall in one.walls if wall.high > 9 and wall.low == 3.6} for one in stages
    ]
    kept = len(fronts[0].keys() & fronts[1].keys()) / len(fronts[0])
    assert 0.65 < kept < 0.92
    assert len(fronts[0]) == pytest.approx(len(fronts[1]), rel=0.1)


def test_both_times_look_at_the_same_place() -> None:
    assert build_scene(SPEC, "new").course is build_scene(SPEC, "old").course
    first, second = (np.stack([_hog(frame(name, i)) for i in range(8)]) for name in ("new", "old"))
    best = (second @ first.T).argmax(axis=1)
    # By chance it would be 0.12.
    assert np.mean(best == np.arange(8)) > 0.2


def _hog(image: NDArray[np.uint8]) -> NDArray[np.float64]:
    grey = cv2.resize(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), (128, 96), interpolation=cv2.INTER_AREA)
    vector = np.asarray(cv2.HOGDescriptor((128, 96), (32, 32), (16, 16), (16, 16), 9).compute(grey)).ravel()
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)
