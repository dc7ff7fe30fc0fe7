"""A ground truth as the VPR tutorial keeps it: ``GT.npz`` with the matrices ``GThard`` and ``GTsoft``."""

from pathlib import Path

import numpy as np

from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.poses import poses
from vpr_datasets.simulation.spec import SimulationSpec

HARD, SOFT = 5.0, 12.0
"""Greatest distance of images that must be found, and of those that count as neither right nor wrong, in metres."""


def write(spec: SimulationSpec, folder: Path, files: Files) -> None:
    """Compare the positions of the first two traverses: rows are images of the first, columns of the second."""
    if len(spec.traverses) < 2:
        raise ValueError("a ground truth needs two traverses, the references' and the queries'")
    references, queries = (poses(spec, traverse.name)[:, :2] for traverse in spec.traverses[:2])
    apart = references[:, None] - queries[None]
    square = apart[..., 0] * apart[..., 0] + apart[..., 1] * apart[..., 1]
    np.savez(folder / "GT.npz", GThard=square <= HARD * HARD, GTsoft=square <= SOFT * SOFT)
