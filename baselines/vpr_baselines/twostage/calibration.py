"""How sure a similarity makes one, learnt from the references' own augmentations and never from queries."""

import numpy as np

from vpr_baselines.twostage.augment import AUGMENTATIONS, variant_of
from vpr_baselines.twostage.confidence import Confidence
from vpr_baselines.twostage.shared import SharedSystem
from vpr_bench.checkpoint import kept
from vpr_bench.progress import track
from vpr_bench.types.traverse import Traverse

_SAMPLE = 200  # references
_COMPONENTS, _ANSWERS = 7, 3


def calibrate(system: SharedSystem, references: Traverse, seed: int) -> Confidence:
    """Fit the confidence to up to 200 references, evenly spread, one augmentation of each.

    The similarity of an augmentation to its own reference is one of the same place; the highest one to a reference of
    a cluster that is neither its own nor next to it is one of another place.
    """

    def compute() -> dict[str, np.ndarray]:
        labels = system.clusters.labels
        chosen = np.unique(np.linspace(0, len(references) - 1, _SAMPLE).round().astype(int))
        same, other = [], []
        for number, index in enumerate(track(chosen.tolist(), "Calibrating scores")):
            query = system.encode(variant_of(references[index], seed, index, number % len(AUGMENTATIONS) + 1))
            triggered = np.argsort(-system.rank(query), kind="stable")[:_COMPONENTS]
            far = triggered[np.abs(triggered - labels[index]) > 1]
            candidates = np.append(system.answers(query, far, _ANSWERS).references, index)
            *others, own = system.similarities(query, candidates).tolist()
            same.append(own)
            other.extend([max(others)] if others else [])
        return {"same": np.array(same), "other": np.array(other)}

    return Confidence.fit(**kept("calibration", compute))
