import hashlib
from functools import cache

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from vpr_datasets.simulation import SimulationSpec, render_frame
from vpr_datasets.simulation.scene import build_scene
from vpr_datasets.simulation.view import place_at

SEASONS = ("spring", "summer", "autumn", "winter")
SPEC = SimulationSpec.model_validate(
    {
        "seed": 12,
        "scene": "railway",
        "frames": 42,
        "width": 160,
        "height": 90,
        "step": 9.0,
        "curvature": 0.1,
        "traverses": [
            {
                "name": season,
                "season": season,
                "light": "overcast" if season == "winter" else "day",
                "haze": 300.0 if season == "winter" else None,
                "snowfall": 0.5 if season == "winter" else 0.0,
                "eye_height": 3.0,
                "shake": 0,
                "traffic": 0,
                "seed": number,
            }
            for number, season in enumerate(SEASONS)
        ],
    }
)

# Raise SIMULATION_VERSION when these change, as in test_frame.py.
DIGESTS = {
    ("spring", 3): "cc91ea4cf9d56b049040b5db938f374fd50cb636eac9c9e59180b2d29430ddc0",
    ("summer", 17): "69015d0d3c578640cd788385e98c3d54f4c001dc9c854db54c263da5d4e1be94",
    ("autumn", 25): "53217442bf054a0918cf1f4ce7467258df7b1d263e5ae738736d1147cbabee9b",
    ("winter", 30): "e27722b1c83391f63686ad3566584bab5b7219d9da6794ab2fa7d1b3a4595b26",
}


@cache
def frame(season: str, index: int) -> NDArray[np.uint8]:
    return render_frame(SPEC, season, index)


@cache
def dark(season: str) -> frozenset[int]:
    """Return the frames that are taken inside a tunnel."""
    tunnels, traverse = build_scene(SPEC, season).tunnels, SPEC.traverse(season)
    places = [place_at(SPEC, traverse, index) for index in range(SPEC.frames)]
    return frozenset(i for i, place in enumerate(places) if any(start <= place < stop for start, stop in tunnels))


@pytest.mark.parametrize(("season", "index"), list(DIGESTS))
def test_pixels_are_the_same_everywhere(season: str, index: int) -> None:
    image = np.ascontiguousarray(frame(season, index))
    assert hashlib.sha256(image.tobytes()).hexdigest() == DIGESTS[season, index]


def test_tunnels_are_black_in_every_season_and_nothing_else_is() -> None:
    inside = dark("summer")
    assert 3 <= len(inside) <= 14
    for season in SEASONS:
        assert len(dark(season) ^ inside) <= 2
        for index in (*sorted(dark(season))[::3], *range(0, SPEC.frames, 13)):
            mean = frame(season, index).mean()
            assert mean < 5 if index in dark(season) else mean > 40, (season, index)


def test_the_land_is_the_same_in_every_season() -> None:
    stages = [build_scene(SPEC, season) for season in ("summer", "winter")]
    # Grass is left out where snow lies higher; everything else stands where it stood.
    places = [set(zip(one.walls.x0.tolist(), one.walls.y0.tolist(), strict=True)) for one in stages]
    assert places[1] < places[0] and len(places[1]) > 0.7 * len(places[0])
    assert stages[0].tunnels == stages[1].tunnels


def test_winter_is_white_and_autumn_yellow() -> None:
    def ground(season: str) -> NDArray[np.float64]:
        lit = [index for index in range(0, SPEC.frames, 4) if index not in dark(season)]
        return np.mean([frame(season, index)[60:].mean(axis=(0, 1)) for index in lit], axis=0)

    winter, summer, autumn = ground("winter"), ground("summer"), ground("autumn")
    assert winter.mean() > 1.4 * summer.mean()
    assert np.ptp(winter) < 12
    assert summer[1] > summer[0]
    assert autumn[0] > autumn[1] + 5


def test_places_are_recognised_in_another_season() -> None:
    lit = [index for index in range(0, SPEC.frames, 2) if not {index, index + 1, index - 1} & dark("summer")]
    summer, winter = (np.stack([_describe(frame(season, index)) for index in lit]) for season in ("summer", "winter"))
    best = (winter @ summer.T).argmax(axis=1)
    # By chance it would be 0.06.
    assert np.mean(best == np.arange(len(lit))) > 0.4


def _describe(image: NDArray[np.uint8]) -> NDArray[np.float64]:
    grey = cv2.resize(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), (128, 64), interpolation=cv2.INTER_AREA)
    vector = np.asarray(cv2.HOGDescriptor((128, 64), (16, 16), (8, 8), (8, 8), 9).compute(grey)).ravel()
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)
