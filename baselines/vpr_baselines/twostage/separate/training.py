"""Training one network per part."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.photometry import resized
from vpr_baselines.twostage.augment import augmented
from vpr_baselines.twostage.components import Components
from vpr_baselines.twostage.report import TrainingReport
from vpr_baselines.twostage.separate.body import Body
from vpr_baselines.twostage.separate.networks import SeparateNetworks
from vpr_baselines.twostage.separate.tuning import tune_parts
from vpr_baselines.twostage.training import train_parts
from vpr_bench.checkpoint import kept
from vpr_bench.progress import task
from vpr_bench.types.clusters import Clusters
from vpr_bench.types.traverse import Traverse

_CHUNK = 128  # references whose descriptors are kept together


@dataclass(frozen=True, eq=False)
class Trained:
    """What training came to.

    Attributes
    ----------
    networks : SeparateNetworks
    report : TrainingReport
    descriptors : (n, D) float32
        What stage one's network answers to each reference below its last layer, as
        :meth:`SeparateNetworks.describe` does to a query.
    """

    networks: SeparateNetworks
    report: TrainingReport
    descriptors: NDArray[np.float32]


def train_separate(
    references: Traverse,
    clusters: Clusters,
    body: Body,
    *,
    penalty: float,
    seed: int,
    finetune: bool = False,
    epochs: int = 10,
    augment: bool = True,
) -> Trained:
    """Train the last layers of all networks, and with ``finetune`` all other layers too.

    The networks are equal below their last layers until those are trained, so that each variant of a reference passes
    through one of them only. A last layer is then the solution of a convex problem, in place of one that epochs of
    descent come near to.

    Parameters
    ----------
    references : Traverse
        n images.
    clusters : Clusters
        Of them.
    body : Body
        The network to begin with.
    penalty : float
        See :func:`~vpr_baselines.twostage.regression.train_head`. Descriptors are centred and scaled to a length of
        about 1 before; the last layers undo it and take what the network answers.
    seed : int
        Of augmentations, split and order.
    finetune : bool
        Whether all layers learn. The networks are then kept in files until the map is saved.
    epochs : int
        Of ``finetune``, at most.
    augment : bool
        Whether each reference is trained with its five augmentations too.
    """
    descriptors = _describe_variants(references, body, augment, seed)
    centre = descriptors[:, 0].mean(axis=0)
    length = float(np.linalg.norm(descriptors[:, 0] - centre, axis=1).mean()) or 1.0
    stage_one, components, report = train_parts(
        clusters, (descriptors - centre) / np.float32(length), penalty=penalty, seed=seed
    )
    networks = SeparateNetworks(
        body, stage_one.before(centre, length), Components(clusters, components.head.before(centre, length))
    )
    if not finetune:
        return Trained(networks, report, descriptors[:, 0])
    networks, report = tune_parts(references, networks, report, descriptors.shape[1], epochs, seed)
    tuned = _kept_rows("tuned descriptors", len(references), lambda index: networks.describe(references[index]))
    return Trained(networks, report, tuned)


def _describe_variants(references: Traverse, body: Body, augment: bool, seed: int) -> NDArray[np.float32]:
    """Pass every reference and its augmentations through the network: (n, V, D)."""

    def describe(index: int) -> NDArray[np.float32]:
        image = references[index]
        if not augment:
            return body.respond([image])
        # Augmenting at the network's own size costs less and shows the network the same.
        small = resized(image, body.trunk.width, body.trunk.height)
        return body.respond([image, *augmented(small, seed, index)])

    return _kept_rows("descriptors", len(references), describe)


def _kept_rows(name: str, count: int, compute: Callable[[int], NDArray[np.float32]]) -> NDArray[np.float32]:
    """Compute an array row by row, and keep it piece by piece."""
    pieces = []
    with task("Describing references", count) as advance:
        for first in range(0, count, _CHUNK):
            rows = range(first, min(first + _CHUNK, count))

            def piece(rows: range = rows) -> dict[str, NDArray[np.float32]]:
                done = []
                for row in rows:
                    done.append(compute(row))
                    advance(1)
                return {"rows": np.stack(done)}

            pieces.append(kept(f"{name} from {first}", piece)["rows"])
    return np.concatenate(pieces)
