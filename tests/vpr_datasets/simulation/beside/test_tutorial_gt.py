from pathlib import Path

import numpy as np
import pytest

from vpr_datasets.simulation import SimulationSpec
from vpr_datasets.simulation.beside.tutorial_gt import HARD, SOFT, write
from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.poses import poses


def test_rows_are_references_and_columns_are_queries(tmp_path: Path) -> None:
    traverses = [{"name": "references"}, {"name": "queries", "frames": 9, "start": 7.0}]
    spec = SimulationSpec.model_validate({"seed": 3, "frames": 12, "step": 3.0, "traverses": traverses})
    write(spec, tmp_path, Files())
    with np.load(tmp_path / "GT.npz", allow_pickle=False) as stored:
        hard, soft = stored["GThard"], stored["GTsoft"]
    assert hard.shape == soft.shape == (12, 9)
    assert hard.dtype == soft.dtype == np.bool_
    assert hard.any(axis=0).all() and soft[hard].all() and soft.sum() > hard.sum()
    apart = poses(spec, "references")[:, None, :2] - poses(spec, "queries")[None, :, :2]
    distance = np.linalg.norm(apart, axis=-1)
    np.testing.assert_array_equal(hard, distance <= HARD)
    np.testing.assert_array_equal(soft, distance <= SOFT)


def test_one_traverse_is_not_enough(tmp_path: Path) -> None:
    spec = SimulationSpec.model_validate({"seed": 3, "frames": 2, "traverses": [{"name": "alone"}]})
    with pytest.raises(ValueError, match="needs two traverses"):
        write(spec, tmp_path, Files())
