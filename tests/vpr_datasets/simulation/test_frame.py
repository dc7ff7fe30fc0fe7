import hashlib
from functools import cache

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from vpr_datasets.simulation import SimulationSpec, render_frame
from vpr_datasets.simulation.scene import build_scene

SPEC = SimulationSpec.model_validate(
    {
        "seed": 7,
        "frames": 60,
        "width": 160,
        "height": 90,
        "traverses": [
            {"name": "day_left", "lateral": 0.8, "seed": 1},
            {"name": "day_right", "lateral": -0.8, "seed": 2},
            {"name": "night_right", "light": "night", "lateral": -0.8, "seed": 3},
        ],
    }
)

# Raise SIMULATION_VERSION when these change. A machine that gets other digests does not render the same
# pixels, and its numbers on simulated images are not comparable.
DIGESTS = {
    ("day_left", 4): "c9a6b1e5d1a247437c990c7a8b3bfb2ad9183708f8f56b37cbf284b2a2c55fbb",
    ("day_right", 41): "25451449a026df6605e7f2095798ce362a4bc40798d5fced93fee8794f78b4dc",
    ("night_right", 22): "3a27d7274cc58c1d21511cf4acbaacbd22256b170c6b4a935d75ec5d015ec5db",
}


@cache
def frame(name: str, index: int) -> NDArray[np.uint8]:
    return render_frame(SPEC, name, index)


@pytest.mark.parametrize(("name", "index"), list(DIGESTS))
def test_pixels_are_the_same_everywhere(name: str, index: int) -> None:
    image = frame(name, index)
    assert image.shape == (90, 160, 3)
    assert image.dtype == np.uint8
    assert hashlib.sha256(np.ascontiguousarray(image).tobytes()).hexdigest() == DIGESTS[name, index]


def test_pixels_do_not_depend_on_what_was_rendered_before() -> None:
    before = frame("day_left", 4)
    build_scene.cache_clear()
    np.testing.assert_array_equal(render_frame(SPEC, "day_left", 4), before)


@pytest.mark.parametrize(("light", "season"), [("dusk", "autumn"), ("night", "winter")])
def test_light_and_season_change_the_picture(light: str, season: str) -> None:
    traverse = {"name": "day_left", "lateral": 0.8, "seed": 1}
    small = SPEC.model_dump() | {"frames": 1, "traverses": [traverse | {"light": light, "season": season}]}
    plain = SPEC.model_dump() | {"frames": 1, "traverses": [traverse | {"light": light}]}
    changed, same_light = (render_frame(SimulationSpec.model_validate(s), "day_left", 0) for s in (small, plain))
    assert _difference(changed, same_light) > 2
    assert _difference(same_light, frame("day_left", 0)) > 5


def test_another_seed_is_another_place() -> None:
    other = SPEC.model_copy(update={"seed": 8, "frames": 1})
    assert _difference(render_frame(other, "day_left", 0), frame("day_left", 0)) > 20


def test_night_is_grey_and_noisy() -> None:
    day, night = (np.stack([frame(name, i) for i in (5, 22, 41)]) for name in ("day_right", "night_right"))
    assert np.ptp(night.astype(int), axis=-1).max() == 0
    assert np.ptp(day.astype(int), axis=-1).mean() > 5
    assert np.mean([_noise(image) for image in night]) > np.mean([_noise(image) for image in day])


def test_a_step_to_the_left_moves_what_is_near_to_the_right() -> None:
    def seen_from(lateral: float) -> NDArray[np.uint8]:
        traverse = {"name": "a", "lateral": lateral, "shake": 0, "pace_variation": 0, "traffic": 0, "noise": 0}
        spec = SPEC.model_dump() | {"traverses": [traverse]}
        return render_frame(SimulationSpec.model_validate(spec), "a", 30)

    middle, left = (cv2.cvtColor(seen_from(t), cv2.COLOR_RGB2GRAY) for t in (0.0, 0.15))
    # The ground just ahead: at 4 m and with 136 pixels of focal length, 0.15 m are about 5 pixels.
    patch = middle[75:, 50:110]
    scores = cv2.matchTemplate(left[75:, 30:130], patch, cv2.TM_CCOEFF_NORMED)[0]
    assert 2 <= int(scores.argmax()) - 20 <= 8


def test_a_frame_number_is_a_place() -> None:
    places = range(0, 60, 3)
    references, queries = (
        np.stack([_describe(frame(name, place)) for place in places]) for name in ("day_left", "day_right")
    )
    best = (queries @ references.T).argmax(axis=1)
    # By chance it would be 0.15.
    assert np.mean(np.abs(best - np.arange(len(places))) <= 1) > 0.4


def test_a_frame_that_does_not_exist_is_refused() -> None:
    with pytest.raises(ValueError, match=r"frame index must be in \[0, 60\), got 60"):
        render_frame(SPEC, "day_left", 60)


def _difference(first: NDArray[np.uint8], second: NDArray[np.uint8]) -> float:
    return float(np.abs(first.astype(int) - second).mean())


def _noise(image: NDArray[np.uint8]) -> float:
    return _difference(image, np.asarray(cv2.medianBlur(image, 3)))


def _describe(image: NDArray[np.uint8]) -> NDArray[np.float64]:
    grey = cv2.resize(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), (64, 128), interpolation=cv2.INTER_AREA)
    vector = np.asarray(cv2.HOGDescriptor().compute(grey)).ravel()
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)
