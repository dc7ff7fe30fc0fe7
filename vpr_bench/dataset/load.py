"""From a protocol to its images and place labels."""

import hashlib
import warnings
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.card import Card, TraverseCard
from vpr_bench.dataset.content import case_digest, traverse_digest
from vpr_bench.dataset.known import remember_digest, vouched_digest
from vpr_bench.dataset.layout import find_layout
from vpr_bench.dataset.parts import Part, parse_parts
from vpr_bench.dataset.recording import Recording
from vpr_bench.dataset.request import Request
from vpr_bench.dataset.source import Source
from vpr_bench.errors import DataError, UsageError, blaming
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol, Unmatched
from vpr_bench.types.traverse import Traverse


class DatasetWarning(UserWarning):
    """The images or their ground truth are not what one might take them for."""


@dataclass(frozen=True, eq=False)
class Case:
    """One protocol with its images and places: all that a run needs.

    Attributes
    ----------
    protocol : Protocol
        What it is, edition included.
    references, queries : Traverse
        The map and what is looked up in it.
    places : Places
        Place labels, and what the dataset itself lists. Methods never see them.
    digest : str
        ``sha256:…`` over the content of all image files and the places.
    folder : Path
        Holds the traverses.
    reference_compass, query_compass : (n,) float64, optional
        Where the cameras looked, in degrees clockwise from north, where the dataset says so.
    """

    protocol: Protocol
    references: Traverse
    queries: Traverse
    places: Places
    digest: str
    folder: Path
    reference_compass: NDArray[np.float64] | None = None
    query_compass: NDArray[np.float64] | None = None

    @cached_property
    def ground_truth(self) -> GroundTruth:
        """Which references show the same place as each query, by the protocol."""
        return self.places.ground_truth(self.protocol)


def load_case(
    dataset: str,
    protocol: str | None = None,
    edition: str = "auto",
    radius: float | None = None,
    unmatched: Unmatched | None = None,
    *,
    render: bool = True,
) -> Case:
    """Load one protocol of a dataset.

    Parameters
    ----------
    dataset : str
        Dataset id (``gardens``), with edition (``gardens:simulated``), a whole protocol id, or a folder of one's own.
    protocol : str, optional
        ``references-queries``, with ``@5nearest`` or the like where there are several; by default the dataset's
        first. Parts of traverses (``summer.every10``) and joined ones (``summer+winter``) can be named too.
    edition : str
        ``real``, ``simulated``, another one of the dataset, or ``auto``, which takes the real images where they are
        on disk.
    radius : float, optional
        Instead of the protocol's own, in its unit.
    unmatched : {"exclude", "miss", "reject"}, optional
        Instead of the protocol's own policy for queries without a true match.
    render : bool
        Render simulated images that are not here yet; else they are missing.

    Raises
    ------
    UsageError
        If there is no such dataset, protocol or edition, two of the arguments contradict each other, or the
        radius is negative, not a number, or larger than the map.
    DataError
        If images are missing or damaged.
    """
    asked = Request.parse(dataset, protocol, edition)
    source = Source.find(asked, render=render)
    chosen = source.card.protocol(asked.pairing, source.edition)
    chosen = replace(  # before anything is rendered: a wrong radius must not cost that
        chosen,
        radius=chosen.radius if radius is None else radius,
        unmatched=unmatched or asked.unmatched or chosen.unmatched,
    )
    return load_from(source.card, chosen, source.folder, foreign=source.foreign)


def load_from(card: Card, protocol: Protocol, folder: Path, *, foreign: bool = False) -> Case:
    """Load a protocol of a card that is in its edition, from the folder that holds its traverses.

    Parameters
    ----------
    card, protocol, folder
        What to load, and where it is.
    foreign : bool
        The images come from somebody else: where the card knows no digests, those of first contact count.

    Raises
    ------
    UsageError
        If the radius reaches over the whole map.
    DataError
        If images are missing or damaged.
    """
    references, reference_digest = load_parts(card, protocol.source, protocol.references, folder, foreign=foreign)
    queries, query_digest = load_parts(card, protocol.source, protocol.queries, folder, foreign=foreign)
    given = _load_given(card, protocol, folder)
    places = Places(queries.labels, references.labels, given)
    digest = case_digest([(references, reference_digest), (queries, query_digest)], given)
    case = Case(
        protocol, references.traverse, queries.traverse, places, digest, folder, references.compass, queries.compass
    )
    if protocol.unit != "given" and places.queries is None:
        raise DataError(f"{card.id} has no place labels: write its protocols {protocol.pairing}@given.")
    places.check(protocol)
    return case


def load_traverse(card: Card, one: TraverseCard, folder: Path) -> Recording:
    """Read one whole traverse through its layout.

    Raises
    ------
    DataError
        If images are missing, or there are more or fewer than the card says.
    """
    layout = find_layout(card.loader.layout)
    with blaming(f"The layout {card.loader.layout!r} failed on {folder / one.path}", DataError):
        return layout.load(folder / one.path, one, **{**card.loader.options, **one.options})


def load_parts(card: Card, source: str, name: str, folder: Path, *, foreign: bool) -> tuple[Recording, str]:
    """Load what a protocol calls its references or queries: a traverse, a part of one, or several joined.

    Parameters
    ----------
    card : Card
        In its edition.
    source : str
        Dataset with its edition, as in a protocol's id.
    name : str
        Of traverses that the card has: ``summer.every10+winter.every10``.
    folder : Path
        Holds the traverses.
    foreign : bool
        As for :func:`load_from`.

    Returns
    -------
    recording : Recording
        What was asked for.
    digest : str
        ``sha256:…`` of the files of the traverses that it is taken from.

    Raises
    ------
    DataError
        If images are missing, or traverses cannot be joined.
    """
    recordings, digests = [], []
    for part in parse_parts(name):
        one = card.traverse(part.traverse)
        recording = load_traverse(card, one, folder)
        digest = traverse_digest(recording.traverse)
        _compare(one, digest, source, folder, foreign)
        recordings.append(_part_of(recording, part))
        digests.append(digest)
    if len(recordings) == 1:
        return recordings[0], digests[0]
    with blaming(f"{name} cannot be joined", DataError):
        return Recording.join(recordings), f"sha256:{hashlib.sha256(' '.join(digests).encode()).hexdigest()}"


def _part_of(recording: Recording, part: Part) -> Recording:
    return recording.subset(part.indices(len(recording))) if part.steps else recording


def _load_given(card: Card, protocol: Protocol, folder: Path) -> GroundTruth | None:
    """Load the ground truth that the dataset itself lists, whatever the protocol's unit: runs serve every unit."""
    options = card.given_options(protocol.references, protocol.queries)
    given = find_layout(card.loader.layout).given
    if options is None:
        return None
    if given is None:
        raise UsageError(f"The layout {card.loader.layout!r} of {card.id} reads no ground truth from files.")
    parts = [parse_parts(name)[0] for name in (protocol.references, protocol.queries)]
    recordings = [load_traverse(card, card.traverse(part.traverse), folder) for part in parts]
    with blaming(f"The ground truth of {card.id} cannot be read", DataError):
        truth: GroundTruth = given(folder, *recordings, **options)
    rows, columns = (part.indices(len(one)) for part, one in zip(parts, recordings, strict=True))
    return truth.take(columns).transpose().take(rows).transpose()


def _compare(one: TraverseCard, digest: str, source: str, folder: Path, foreign: bool) -> None:
    """Warn of images that are not those the card knows or, where it knows none, those that were met first.

    They are used all the same: other copies exist, but numbers measured on them may differ.
    """
    expected, whose = vouched_digest(one, source if foreign else None)
    if expected is None and foreign:
        remember_digest(f"{source}/{one.name}", digest, folder / one.path)
    if expected not in (None, digest):
        warnings.warn(
            f"{folder / one.path} is not the copy that {whose}: expected {_short(expected)}, found {_short(digest)}. "
            f"Numbers may differ; see `vpr-bench data verify {source}`.",
            DatasetWarning,
            stacklevel=2,
        )


def _short(digest: str | None) -> str:
    return f"{digest:.15}…" if digest else "none"
