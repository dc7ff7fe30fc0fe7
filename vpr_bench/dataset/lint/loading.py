"""Loading everything that some protocols use; what goes wrong becomes findings, and the rest goes on."""

import re
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field

from vpr_bench.dataset.content import traverse_digest
from vpr_bench.dataset.known import vouched_digest
from vpr_bench.dataset.lint.finding import Finding, Severity
from vpr_bench.dataset.load import Case, DatasetWarning, load_from, load_traverse
from vpr_bench.dataset.parts import parse_parts
from vpr_bench.dataset.recording import Recording
from vpr_bench.dataset.source import Source
from vpr_bench.errors import DataError, VprBenchError, blaming
from vpr_bench.types.protocol import Protocol

_PAST_THE_END = re.compile(r"\bdo(es)? not exist\b")


@dataclass(eq=False)
class Loaded:
    """What could be loaded, and what stood in the way of the rest.

    Attributes
    ----------
    traverses : dict of str to Recording
        Every traverse that a protocol uses, whole, by its name.
    cases : list of Case
        The protocols, with their ground truth worked out.
    findings : list of Finding
        Why others are missing, and what layouts warned of.
    """

    traverses: dict[str, Recording] = field(default_factory=dict)
    cases: list[Case] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)

    @contextmanager
    def noting(self, where: str) -> Iterator[None]:
        """Make findings of the errors and warnings inside the ``with`` block, each message once."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                yield
            except VprBenchError as error:
                self.add("does-not-load", "error", where, str(error))
        for one in caught:
            if issubclass(one.category, DatasetWarning):
                check = "references-past-the-end" if _PAST_THE_END.search(str(one.message)) else "layout-warning"
                self.add(check, "warning", where, str(one.message))
            else:  # nothing about the images: for whoever listens
                warnings.warn_explicit(one.message, one.category, one.filename, one.lineno)

    def add(self, check: str, severity: Severity, where: str, message: str) -> None:
        """Add a finding, unless the same was found elsewhere: a lost traverse is lost to all its protocols."""
        finding = Finding(check, severity, where, message)
        if all((one.check, one.message) != (check, finding.message) for one in self.findings):
            self.findings.append(finding)


def load_all(source: Source, protocols: Sequence[Protocol]) -> Loaded:
    """Load protocols of a dataset and, whole, the traverses that they are made of.

    Raises
    ------
    DataError
        If the dataset's folder is not there and cannot be rendered.
    """
    loaded, card, folder = Loaded(), source.card, source.folder
    names = [part.traverse for one in protocols for side in (one.references, one.queries) for part in parse_parts(side)]
    for name in dict.fromkeys(names):
        with loaded.noting(name):
            loaded.traverses[name] = load_traverse(card, card.traverse(name), folder)
            _compare(source, name, loaded)
    # Loading compares digests too, and records those that it meets first. To look is not to meet.
    traverses = [one.model_copy(update={"digest": None}) for one in card.traverses]
    unvouched = card.model_copy(update={"traverses": traverses})
    for protocol in protocols:
        with loaded.noting(str(protocol)), blaming("The ground truth cannot be made", DataError):
            case = load_from(unvouched, protocol, folder)
            _ = case.ground_truth  # kept by the case; from here on it cannot fail
            loaded.cases.append(case)
    return loaded


def _compare(source: Source, name: str, loaded: Loaded) -> None:
    """Find images that are not the copy that is known."""
    expected, whose = vouched_digest(source.card.traverse(name), source.name if source.foreign else None)
    if expected is not None and expected != traverse_digest(loaded.traverses[name].traverse):
        loaded.add(
            "another-copy",
            "warning",
            name,
            f"not the copy that {whose}; numbers may differ. `vpr-bench data verify {source.name}` gives the digests",
        )
