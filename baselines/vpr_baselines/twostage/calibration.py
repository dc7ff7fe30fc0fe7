"""How sure a similarity makes one, learnt from the references' own augmentations and never from queries."""

import numpy as np

from vpr_baselines.twostage.augment import AUGMENTATIONS, variant_of
from vpr_baselines.twostage.confidence import Confidence
from vpr_baselines.twostage.reranking import without_rival
from vpr_baselines.twostage.shared import SharedSystem
from vpr_bench.checkpoint import kept
from vpr_bench.progress import track
from vpr_bench.types.traverse import Traverse

_SAMPLE = 200  # references
_COMPONENTS, _ANSWERS = 7, 3


def calibrate(system: SharedSystem, references: Traverse, seed: int) -> Confidence:
    """Fit the confidence to up to 200 references, evenly spread, one augmentation of each.

    The similarity of an augmentation to its own reference is one of the same place; the highest one to a reference of
    a cluster that is neither its own nor, if there are others, next to it, is one of another place. From both the
    rival's share is taken, as it is from a query's.
    """

    def compute() -> dict[str, np.ndarray]:
        labels = system.clusters.labels
        chosen = np.unique(np.linspace(0, len(references) - 1, _SAMPLE).round().astype(int))
        same, other = [], []
        for number, index in enumerate(track(chosen.tolist(), "Calibrating scores")):
            query = system.encode(variant_of(references[index], seed, index, number % len(AUGMENTATIONS) + 1))
            ranked = np.argsort(-system.rank(query), kind="stable")
            distance = np.abs(ranked - labels[index])
            # In a small map all clusters may be next to each other.
            far = ranked[distance > min(1, distance.max() - 1)][:_COMPONENTS]
            away = system.answers(query, far, _ANSWERS).references
            with_own = np.append(index, away)
            similarities = system.similarities(query, with_own)
            same.append(without_rival(similarities, with_own)[0])
            if len(away):
                other.append(without_rival(similarities[1:], away).max())
        return {"same": np.array(same), "other": np.array(other)}

    return Confidence.fit(**kept("calibration", compute))
