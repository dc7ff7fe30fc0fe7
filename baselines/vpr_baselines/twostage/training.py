"""Training the parts on descriptors that were computed once: the trunk is frozen, only last layers learn."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.twostage.components import Components
from vpr_baselines.twostage.heads import LinearHead
from vpr_baselines.twostage.lbfgs import LIMIT
from vpr_baselines.twostage.regression import Samples, train_head
from vpr_baselines.twostage.report import PartReport, TrainingReport, accuracy_and_precision
from vpr_baselines.twostage.split import TEST, TRAINING, VALIDATION, split
from vpr_bench.checkpoint import kept
from vpr_bench.progress import task
from vpr_bench.types.clusters import Clusters

Descriptors = NDArray[np.floating]
"""(n, V, D): the descriptors of every reference's V variants, the first of which is the original. Of any precision,
also memory-mapped; of about unit length."""

_BLOCK = 32  # components that are kept together


def train_parts(
    clusters: Clusters, descriptors: Descriptors, *, penalty: float, seed: int
) -> tuple[LinearHead, Components, TrainingReport]:
    """Train stage one and every component.

    Parameters
    ----------
    clusters : Clusters
        Of the n references.
    descriptors : (n, V, D) float
        See :data:`Descriptors`. With V = 1 nothing is held back, and training goes on until it converges.
    penalty : float
        See :func:`~vpr_baselines.twostage.regression.train_head`.
    seed : int
        Of the split.
    """
    stage_one, first = train_stage_one(clusters, descriptors, penalty=penalty, seed=seed)
    components, others = train_components(clusters, descriptors, penalty=penalty, seed=seed)
    return stage_one, components, TrainingReport(stage_one=first, components=others)


def train_stage_one(
    clusters: Clusters, descriptors: Descriptors, *, penalty: float, seed: int
) -> tuple[LinearHead, PartReport]:
    """Train the classifier image → cluster, one row per cluster. Parameters as for :func:`train_parts`."""
    parts = split(clusters, descriptors.shape[1], seed)

    def compute() -> dict[str, NDArray[Any]]:
        with task("Training stage one", LIMIT) as advance:
            everything = np.arange(len(clusters.labels))
            trained = _train_part(descriptors, parts, everything, clusters.labels, penalty, advance)
        return _packed([trained])

    head, (report,) = _unpacked(kept("stage one", compute))
    return head, report


def train_components(
    clusters: Clusters,
    descriptors: Descriptors,
    *,
    penalty: float,
    seed: int,
    known: tuple[Components, Sequence[PartReport]] | None = None,
) -> tuple[Components, tuple[PartReport, ...]]:
    """Train the classifiers image → reference within the cluster, each on the images of its own cluster.

    Parameters
    ----------
    clusters, descriptors, penalty, seed
        As for :func:`train_parts`.
    known : (Components, sequence of PartReport), optional
        Components that stay as they are, with their reports: those of the first clusters of the first references,
        to which others were added. Only the others are trained.

    Returns
    -------
    components : Components
    reports : tuple of PartReport
        One per component.

    Raises
    ------
    ValueError
        If what is known is not the beginning of ``clusters``.
    """
    heads, reports = [], list[PartReport]()
    if known is not None:
        _check_beginning(known[0].clusters, clusters)
        heads.append(known[0].head)
        reports.extend(known[1])
    parts = split(clusters, descriptors.shape[1], seed)

    def train(component: int) -> _Trained:
        members = clusters.members(component)
        return _train_part(descriptors, parts, members, np.arange(len(members)), penalty)

    missing = range(len(reports), len(clusters))
    with task("Training components", len(missing)) as advance:
        for block in (missing[first : first + _BLOCK] for first in range(0, len(missing), _BLOCK)):
            stored = kept(f"components from {block.start}", lambda block=block: _packed([train(one) for one in block]))  # type: ignore[misc]
            head, others = _unpacked(stored)
            heads.append(head)
            reports.extend(others)
            advance(len(block))
    weight, bias = np.concatenate([one.weight for one in heads]), np.concatenate([one.bias for one in heads])
    return Components(clusters, LinearHead(weight, bias)), tuple(reports)


_Trained = tuple[LinearHead, PartReport]


def _train_part(
    descriptors: Descriptors,
    parts: NDArray[np.int8],
    members: NDArray[np.int64],
    labels: NDArray[np.int64],
    penalty: float,
    advance: Callable[[int], None] = lambda rounds: None,
) -> _Trained:
    """Train one classifier on the variants of some references.

    Parameters
    ----------
    descriptors : (n, V, D) float
    parts : (n, V) int8
        The split.
    members : (m,) int64
        The references that it learns from.
    labels : (m,) int64
        The class of each, every number from 0 on used.
    penalty, advance
        See :func:`~vpr_baselines.twostage.regression.train_head`.
    """
    variants = descriptors.shape[1]
    flat = descriptors.reshape(-1, descriptors.shape[2])

    def samples(part: int) -> Samples:
        rows, columns = np.nonzero(parts[members] == part)
        return Samples(flat, members[rows] * variants + columns, labels[rows])

    classes = int(labels.max()) + 1
    training, validation, test = (samples(part) for part in (TRAINING, VALIDATION, TEST))
    head, rounds, stopped = train_head(training, classes, penalty, validation, advance)
    accuracy, precision = accuracy_and_precision(head.logits(test.batch(slice(None)).numpy()), test.labels)
    return head, PartReport(
        classes=classes,
        training=len(training),
        validation=len(validation),
        test=len(test),
        rounds=rounds,
        stopped=stopped,
        accuracy=accuracy,
        average_precision=precision,
    )


def _packed(trained: Sequence[_Trained]) -> dict[str, NDArray[Any]]:
    """Put parts into arrays, their layers one below the other."""
    return {
        "weight": np.concatenate([head.weight for head, _ in trained]),
        "bias": np.concatenate([head.bias for head, _ in trained]),
        "reports": np.array([report.model_dump_json() for _, report in trained]),
    }


def _unpacked(arrays: dict[str, NDArray[Any]]) -> tuple[LinearHead, list[PartReport]]:
    reports = [PartReport.model_validate_json(text) for text in arrays["reports"].tolist()]
    return LinearHead(arrays["weight"], arrays["bias"]), reports


def _check_beginning(known: Clusters, clusters: Clusters) -> None:
    old, new = np.split(clusters.labels, [len(known.labels)])
    if not np.array_equal(known.labels, old) or np.any(new < len(known)):
        raise ValueError("known components must be those of the first clusters, none of which has grown.")
