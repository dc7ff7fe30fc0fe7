"""From a protocol to its images and place labels."""

import warnings
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.card import Card, find_card
from vpr_bench.dataset.content import case_digest, traverse_digest
from vpr_bench.dataset.editions import resolve_edition
from vpr_bench.dataset.request import Request
from vpr_bench.errors import DataError, UsageError, blaming
from vpr_bench.registry import import_object
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Protocol, Unmatched
from vpr_bench.types.traverse import Traverse


class DatasetWarning(UserWarning):
    """The images are not what one might take them for."""


@dataclass(frozen=True, eq=False)
class Case:
    """One protocol with its images and place labels: all that a run needs.

    Attributes
    ----------
    protocol : Protocol
        What it is, edition included.
    references, queries : Traverse
        The map and what is looked up in it.
    reference_labels, query_labels : (n,) or (n, 2) float64
        Place labels in the protocol's unit. Methods never see them.
    digest : str
        ``sha256:…`` over the content of all image files and the labels.
    folder : Path
        Holds the traverses.
    """

    protocol: Protocol
    references: Traverse
    queries: Traverse
    reference_labels: NDArray[np.float64]
    query_labels: NDArray[np.float64]
    digest: str
    folder: Path

    @cached_property
    def ground_truth(self) -> GroundTruth:
        """Which references show the same place as each query, at the protocol's radius."""
        return GroundTruth.from_radius(self.query_labels, self.reference_labels, self.protocol.radius)


def check_radius(reference_labels: NDArray[np.float64], protocol: Protocol) -> None:
    """Refuse a radius that makes every answer right.

    Raises
    ------
    UsageError
        If it reaches from one end of the map to the other.
    """
    several = len(reference_labels) > 1
    extent = float(np.ptp(reference_labels, axis=0).max()) if several else float("inf")
    if protocol.radius >= extent:
        raise UsageError(
            f"The radius {protocol.radius:g}{protocol.unit} reaches over the whole map "
            f"({extent:g}{protocol.unit} from end to end): every answer would be right. Give a smaller one."
        )


def load_case(
    dataset: str,
    protocol: str | None = None,
    edition: str = "auto",
    radius: float | None = None,
    unmatched: Unmatched | None = None,
) -> Case:
    """Load one protocol of a dataset.

    Parameters
    ----------
    dataset : str
        Dataset id (``gardens``), with edition (``gardens:simulated``), or a whole protocol id.
    protocol : str, optional
        One of the dataset's named protocols, ``references-queries``; by default its first.
    edition : {"auto", "real", "simulated"}
        ``auto`` takes the real images where they are on disk.
    radius : float, optional
        Instead of the protocol's own, in its unit.
    unmatched : {"exclude", "miss", "reject"}, optional
        Instead of the protocol's own policy for queries without a true match.

    Raises
    ------
    UsageError
        If there is no such dataset, protocol or edition, two of the arguments contradict each other, or the
        radius is negative, not a number, or larger than the map.
    DataError
        If images are missing or damaged.
    """
    asked = Request.parse(dataset, protocol, edition)
    card = find_card(asked.dataset)
    chosen = card.protocol(asked.pairing)
    if asked.unit not in (None, card.unit):
        raise UsageError(f"{dataset!r} is in {asked.unit!r}, but the place labels of {card.id} are in {card.unit!r}.")
    radius = radius if radius is not None else asked.radius
    chosen = replace(  # before the edition is resolved: a wrong radius must not cost a rendering
        chosen,
        radius=chosen.radius if radius is None else radius,
        unmatched=unmatched or asked.unmatched or chosen.unmatched,
    )
    name, folder = resolve_edition(card, asked.edition)
    return load_from(card, replace(chosen, edition=name), folder)


def load_from(card: Card, protocol: Protocol, folder: Path) -> Case:
    """Load a protocol whose edition has been chosen, from the folder that holds its traverses.

    Raises
    ------
    UsageError
        If the radius reaches over the whole map.
    DataError
        If images are missing or damaged.
    """
    references, reference_labels, reference_digest = load_traverse(card, protocol.references, protocol.edition, folder)
    queries, query_labels, query_digest = load_traverse(card, protocol.queries, protocol.edition, folder)
    digest = case_digest([(references, reference_labels, reference_digest), (queries, query_labels, query_digest)])
    case = Case(protocol, references, queries, reference_labels, query_labels, digest, folder)
    check_radius(reference_labels, protocol)
    return case


def load_traverse(card: Card, name: str, edition: str, folder: Path) -> tuple[Traverse, NDArray[np.float64], str]:
    """Load one traverse with its place labels and content digest.

    Real images whose digest is not the card's are used all the same, with a warning: other copies exist, but
    numbers measured on them may differ.
    """
    traverse_card = card.traverse(name)
    loader = import_object(card.loader.function, f"The loader of {card.id}")
    with blaming(f"The loader of {card.id} failed on {name}", DataError):
        traverse, labels = loader(folder / traverse_card.path, traverse_card, **card.loader.options)
    digest = traverse_digest(traverse)
    if edition == "real" and traverse_card.digest not in (None, digest):
        warnings.warn(
            f"{folder / traverse_card.path} is not the copy that the card of {card.id} knows: "
            f"expected {_short(traverse_card.digest)}, found {_short(digest)}. Numbers may differ; "
            f"see `vpr-bench data verify {card.id}`.",
            DatasetWarning,
            stacklevel=2,
        )
    return traverse, labels, digest


def _short(digest: str | None) -> str:
    return f"{digest:.15}…" if digest else "none"
