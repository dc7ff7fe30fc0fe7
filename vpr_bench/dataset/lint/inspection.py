"""Looking at a dataset with every check there is."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from vpr_bench.dataset.lint.copies import find_given_away, find_repeated
from vpr_bench.dataset.lint.finding import SEVERITIES, Finding
from vpr_bench.dataset.lint.junk import find_junk
from vpr_bench.dataset.lint.loading import Loaded, load_all
from vpr_bench.dataset.lint.matches import find_asymmetric, find_lonely
from vpr_bench.dataset.lint.numbering import find_misaligned, find_misordered
from vpr_bench.dataset.lint.pixels import find_dark, find_frozen, find_mixed_sizes, find_undecodable
from vpr_bench.dataset.lint.positions import find_far_apart, find_jumps
from vpr_bench.dataset.lint.survey import survey
from vpr_bench.dataset.parts import parse_parts
from vpr_bench.dataset.source import Source
from vpr_bench.types.protocol import Protocol


@dataclass(frozen=True)
class Inspection:
    """What was looked at, and what was found.

    Attributes
    ----------
    protocols : list of Protocol
        All that were to be looked at.
    traverses, images : int
        How many traverses could be loaded, and how many images they have.
    findings : list of Finding
        The worst first.
    """

    protocols: list[Protocol]
    traverses: int
    images: int
    findings: list[Finding]


def lint_source(source: Source, protocols: Sequence[Protocol] | None = None) -> list[Finding]:
    """Find what is wrong with the images and the ground truth of a dataset; see :func:`inspect_source`."""
    return inspect_source(source, protocols).findings


def inspect_source(source: Source, protocols: Sequence[Protocol] | None = None) -> Inspection:
    """Find what is wrong with the images and the ground truth of a dataset.

    Every traverse that the protocols use is looked at whole, and each of its images decoded once.

    Parameters
    ----------
    source : Source
        The dataset, in its edition.
    protocols : sequence of Protocol, optional
        By default all that the card lists.

    Raises
    ------
    DataError
        If the dataset's folder is not there and cannot be rendered.
    """
    chosen = list(source.card.listed_protocols(source.edition) if protocols is None else protocols)
    loaded = load_all(source, chosen)
    findings = [*loaded.findings, *find_junk(source.card, source.folder, loaded.traverses)]
    findings += [*_find_in_pictures(loaded), *_find_in_places(source, loaded)]
    unique = dict.fromkeys(findings)  # two protocols of one pairing share some
    ordered = sorted(unique, key=lambda one: SEVERITIES.index(one.severity))
    images = sum(len(one) for one in loaded.traverses.values())
    return Inspection(chosen, len(loaded.traverses), images, ordered)


def _find_in_pictures(loaded: Loaded) -> Iterator[Finding]:
    unreadable: set[Path] = set()
    for recording in loaded.traverses.values():
        traverse = recording.traverse
        seen = survey(traverse)
        unreadable |= {path for index in seen.faults if isinstance(path := traverse.sources[index], Path)}
        for find in (find_undecodable, find_mixed_sizes, find_dark, find_frozen):
            yield from find(traverse, seen)
        yield from find_repeated(traverse, unreadable)
    for case in loaded.cases:
        yield from find_given_away(case, unreadable)


def _find_in_places(source: Source, loaded: Loaded) -> Iterator[Finding]:
    for recording in loaded.traverses.values():
        if source.card.unit == "m":
            yield from find_jumps(recording)
        elif source.card.unit == "f":
            yield from find_misordered(recording)
    for case in loaded.cases:
        apart = find_far_apart(case) if source.card.unit == "m" else []
        yield from apart or find_lonely(case)  # far apart, nothing matches: one cause, one finding
        yield from find_asymmetric(case)
        if source.card.unit == "f":
            for one in parse_parts(case.protocol.references):
                for other in parse_parts(case.protocol.queries):
                    yield from find_misaligned(loaded.traverses[one.traverse], loaded.traverses[other.traverse])
