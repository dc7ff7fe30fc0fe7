from pathlib import Path

import numpy as np

from vpr_datasets.simulation import SimulationSpec
from vpr_datasets.simulation.beside.fgps import METRES, SHRINKAGE, write
from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.poses import poses


def test_positions_are_the_poses_with_the_latitude_upside_down(tmp_path: Path) -> None:
    spec = SimulationSpec.model_validate({"seed": 3, "frames": 12, "step": 3.0, "traverses": [{"name": "a"}]})
    (tmp_path / "a").mkdir()
    write(spec, tmp_path, Files())
    latitude, longitude = np.loadtxt(tmp_path / "a/fGPS.txt").T
    assert (np.abs(latitude - 27.53) < 0.01).all() and (np.abs(longitude - 152.99) < 0.01).all()
    east, north = (longitude - 152.99) * METRES * SHRINKAGE, (-latitude + 27.53) * METRES
    np.testing.assert_allclose(np.stack([east, north], axis=1), poses(spec, "a")[:, :2], atol=0.02)
