import json
from pathlib import Path

import numpy as np
import utm

from vpr_datasets.simulation import SimulationSpec
from vpr_datasets.simulation.beside.mapillary import ERROR, ORIGINS, TURN, degrees, write
from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.poses import poses

SPEC = SimulationSpec.model_validate(
    {"seed": 3, "scene": "boulevard", "frames": 40, "step": 4.0, "traverses": [{"name": "a", "lateral": -3.0}]}
)
FILES = Files(patterns={"a": "town_1/wjPz0-_b8Q3LQ2mXc5fRtg-640-{number:05d}.jpg"}, first=7)


def test_positions_and_compass_are_the_poses_with_the_errors_of_a_telephone(tmp_path: Path) -> None:
    (tmp_path / "town_1").mkdir()
    write(SPEC, tmp_path, FILES)
    fixes = [json.loads((tmp_path / f"{FILES.name('a', index)}.json").read_text()) for index in range(40)]
    assert {fix["skey"] for fix in fixes} == {"wjPz0-_b8Q3LQ2mXc5fRtg"}
    assert len({fix["key"] for fix in fixes}) == 40
    assert {len(fix["key"]) for fix in fixes} == {22}
    truth = poses(SPEC, "a")
    turned = (np.array([fix["ca"] for fix in fixes]) - truth[:, 2] + 180) % 360 - 180
    assert 0.5 < np.abs(turned).mean() < np.abs(turned).max() <= TURN + 0.01
    scale = 0.9996 * 1.00017  # of UTM at two degrees from the zone's middle
    grid = np.array([utm.from_latlon(fix["lat"], fix["lon"])[:2] for fix in fixes]) / scale
    steps = np.linalg.norm(grid - grid[0], axis=1) - np.linalg.norm(truth[:, :2] - truth[0, :2], axis=1)
    assert 0.1 < np.abs(steps).max() < 3 * ERROR


def test_degrees_are_those_of_the_ellipsoid() -> None:
    for scene, origin in ORIGINS.items():
        assert degrees(scene, 0.0, 0.0) == origin
        start = np.array(utm.from_latlon(*origin, force_zone_number=33)[:2])
        for east, north in ((900.0, 0.0), (0.0, -400.0), (600.0, 300.0)):
            end = np.array(utm.from_latlon(*degrees(scene, east, north), force_zone_number=33)[:2])
            measured = np.linalg.norm(end - start) / (0.9996 * 1.000166)
            assert abs(measured - np.hypot(east, north)) < 0.06
