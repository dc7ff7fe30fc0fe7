"""Fitting the system, and adding references to one that is fitted."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.retrieval import normalised
from vpr_baselines.twostage.calibration import calibrate
from vpr_baselines.twostage.components import Components
from vpr_baselines.twostage.description import describe_references
from vpr_baselines.twostage.encoder import Encoder
from vpr_baselines.twostage.heads import LinearHead
from vpr_baselines.twostage.report import PartReport, TrainingReport
from vpr_baselines.twostage.reranking import Rerank
from vpr_baselines.twostage.separate.body import Body
from vpr_baselines.twostage.separate.system import SeparateSystem
from vpr_baselines.twostage.shared import SharedSystem
from vpr_bench.types.clusters import Clusters
from vpr_bench.types.traverse import Traverse

Cluster = Callable[[Traverse, NDArray[np.float32]], Clusters]
"""Clusters references, given the (n, D) float32 descriptors of the originals."""


def fit_shared(
    references: Traverse, encoder: Encoder, cluster: Cluster, rerank: Rerank, penalty: float, seed: int
) -> SharedSystem:
    """Describe, cluster, train and calibrate.

    Parameters
    ----------
    references : Traverse
        At least one image.
    encoder : Encoder
        Learnt on them.
    cluster : callable
        See :data:`Cluster`.
    rerank : Rerank
        How candidates will be compared.
    penalty, seed
        See :func:`~vpr_baselines.twostage.training.train_parts`.
    """
    from vpr_baselines.twostage.training import train_parts

    description = describe_references(references, encoder, seed)
    clusters = cluster(references, description.originals)
    stage_one, components, report = train_parts(clusters, description.descriptors, penalty=penalty, seed=seed)
    system = SharedSystem(encoder, description, stage_one, _halved(components), report, rerank)
    return replace(system, confidence=calibrate(system, references, seed))


def extend_shared(
    system: SharedSystem, references: Traverse, cluster: Cluster, penalty: float, seed: int
) -> SharedSystem:
    """Give new references clusters and components of their own, and train stage one again on all descriptors.

    The encoder, the other components and the calibration stay. Parameters as for :func:`fit_shared`.
    """
    from vpr_baselines.twostage.training import train_components, train_stage_one

    added = describe_references(references, system.encoder, seed)
    new = cluster(references, added.originals)
    clusters = Clusters(np.concatenate([system.clusters.labels, new.labels + len(system.clusters)]))
    description = system.description.followed_by(added)
    stage_one, report = train_stage_one(clusters, description.descriptors, penalty=penalty, seed=seed)
    known: tuple[Components, Sequence[PartReport]] = system.components, system.report.components
    components, reports = train_components(clusters, description.descriptors, penalty=penalty, seed=seed, known=known)
    trained = TrainingReport(stage_one=report, components=reports)
    return replace(system, description=description, stage_one=stage_one, components=_halved(components), report=trained)


def fit_separate(
    references: Traverse, clusters: Clusters, body: Body, penalty: float, seed: int, epochs: int | None
) -> SeparateSystem:
    """Train a network per part; all layers of each for up to ``epochs``, or the last one if that is None."""
    from vpr_baselines.twostage.separate.training import train_separate

    trained = train_separate(
        references, clusters, body, penalty=penalty, seed=seed, finetune=epochs is not None, epochs=epochs or 1
    )
    return SeparateSystem(trained.networks, normalised(trained.descriptors), trained.report)


def _halved(components: Components) -> Components:
    """Keep the weights in half precision, as they are stored, so that a map answers the same before and after."""
    head = components.head
    return Components(components.clusters, LinearHead(head.weight.astype(np.float16), head.bias))
