import hashlib
from functools import cache
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from vpr_datasets.simulation import SimulationSpec, render_frame
from vpr_datasets.simulation.edition import SimulatedEdition

OPTIONS = {
    "seed": 5,
    "scene": "suburb",
    "frames": 30,
    "width": 128,
    "height": 96,
    "step": 3.0,
    "curvature": 0.2,
    "traverses": [
        {"name": "morning", "sun": [-1.3, -0.5], "lateral": 1.4, "eye_height": 1.4, "shake": 0.2, "seed": 1},
        {"name": "afternoon", "sun": [2.4, -1.1], "lateral": 1.2, "eye_height": 1.4, "shake": 0.2, "seed": 2},
    ],
}
SPEC = SimulationSpec.model_validate(OPTIONS)

# Raise SIMULATION_VERSION when these change, as in test_frame.py.
DIGESTS = {
    ("morning", 4): "d54400e6e0fc4e1a7a58ebeeb22d798bc280f7a45773f99873d5570e57f0ff99",
    ("afternoon", 21): "a691c3692b6f40b5f1ab03d90f1f5658986238543a360e5cd00044cbae477188",
}


@cache
def frame(name: str, index: int) -> NDArray[np.uint8]:
    return render_frame(SPEC, name, index)


@pytest.mark.parametrize(("name", "index"), list(DIGESTS))
def test_pixels_are_the_same_everywhere(name: str, index: int) -> None:
    image = np.ascontiguousarray(frame(name, index))
    assert hashlib.sha256(image.tobytes()).hexdigest() == DIGESTS[name, index]


def test_shadows_lie_where_the_sun_puts_them() -> None:
    def road(sun: tuple[float, float] | None) -> NDArray[np.float64]:
        traverse = {"name": "a", "sun": sun, "traffic": 0, "noise": 0}
        spec = SimulationSpec.model_validate(OPTIONS | {"traverses": [traverse]})
        return np.stack([render_frame(spec, "a", index)[60:].mean(axis=2) for index in range(0, 30, 3)])

    usual, morning, afternoon = road(None), road((-1.3, -0.5)), road((2.4, -1.1))
    assert np.abs(morning - afternoon).mean() > 3
    np.testing.assert_array_equal(usual, road((0.55, -0.75)))


def test_places_are_recognised_at_another_time_of_day() -> None:
    places = range(0, 30, 2)
    first, second = (np.stack([_describe(frame(name, i)) for i in places]) for name in ("morning", "afternoon"))
    best = (second @ first.T).argmax(axis=1)
    # By chance it would be 0.2.
    assert np.mean(np.abs(best - np.arange(len(places))) <= 1) > 0.6


def test_the_edition_has_raw_pictures_positions_and_a_ground_truth(tmp_path: Path) -> None:
    options = OPTIONS | {"bayer": "RGGB", "frames": 3, "step": 1.0, "pattern": "{traverse}/{number:03d}.png"}
    SimulatedEdition(options | {"beside": ["tutorial_gt", "fgps"]}).render(tmp_path)
    raw = np.asarray(cv2.imread(str(tmp_path / "morning/002.png"), cv2.IMREAD_UNCHANGED))
    assert raw.shape == (96, 128)
    files = sorted(path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file())
    names = ["000.png", "001.png", "002.png", "fGPS.txt"]
    assert files == ["GT.npz", *(f"{traverse}/{name}" for traverse in ("afternoon", "morning") for name in names)]


def _describe(image: NDArray[np.uint8]) -> NDArray[np.float64]:
    grey = cv2.resize(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), (128, 64), interpolation=cv2.INTER_AREA)
    vector = np.asarray(cv2.HOGDescriptor((128, 64), (16, 16), (8, 8), (8, 8), 9).compute(grey)).ravel()
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)
