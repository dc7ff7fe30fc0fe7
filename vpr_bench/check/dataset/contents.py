"""What lies on disk."""

import tempfile
from pathlib import Path

import numpy as np

from vpr_bench.check.dataset.subject import DatasetSubject
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.check.suite import check
from vpr_bench.dataset.content import traverse_digest
from vpr_bench.dataset.editions import Renderer
from vpr_bench.dataset.lint import lint_source
from vpr_bench.dataset.load import load_traverse
from vpr_bench.importing import import_object
from vpr_bench.progress import track

_FEW = 100
"""Images that are soon rendered a second time."""


@check("protocols-load")
def protocols_load(subject: DatasetSubject) -> None:
    """Check that every protocol that the card lists can be loaded."""
    _ = subject.cases


@check("places-make-sense", "protocols-load")
def places_make_sense(subject: DatasetSubject) -> None:
    """Check that place labels are finite numbers, one per image, and some query of each protocol has a true match."""
    for case in subject.cases:
        sides = ((case.places.references, case.references), (case.places.queries, case.queries))
        for labels, traverse in sides:
            if labels is not None and (len(labels) != len(traverse) or not np.isfinite(labels).all()):
                raise Failed(f"{case.protocol}: the labels of {traverse.name} are not {len(traverse)} finite numbers")
        truth = case.ground_truth
        if truth.n_queries != len(case.queries) or truth.n_references != len(case.references):
            raise Failed(f"{case.protocol}: the ground truth is of {truth.n_queries} × {truth.n_references} images")
        if not len(truth.references):
            raise Failed(f"{case.protocol}: no query has a true match")


@check("ends-decode")
def ends_decode(subject: DatasetSubject) -> None:
    """Check that the first and the last image of every traverse decode."""
    for name, recording in subject.traverses().items():
        if not len(recording):
            raise Failed(f"{name} has no images")
        for index in (0, len(recording) - 1):
            _ = recording.traverse[index]


@check("digests-repeat", "protocols-load")
def digests_repeat(subject: DatasetSubject) -> None:
    """Check that images and places have the same digests when they are loaded twice; all files are read again."""
    for case, again in zip(subject.cases, subject.load(), strict=True):
        if case.digest != again.digest:
            raise Failed(f"{case.protocol} is {case.digest:.15}… the first time and {again.digest:.15}… the second")
    recordings = subject.traverses()
    for name, recording in track(recordings.items(), "Reading all files again", len(recordings)):
        if traverse_digest(recording.traverse) != traverse_digest(recording.traverse, afresh=True):
            raise Failed(f"the files of {name} are not what they were when they were read last")


@check("lint-finds-no-errors", "protocols-load", "ends-decode")
def lint_finds_no_errors(subject: DatasetSubject) -> None:
    """Check that `vpr-bench data lint` finds nothing that makes numbers wrong."""
    errors = [finding for finding in lint_source(subject.source) if finding.severity == "error"]
    if errors:
        more = f" (and {len(errors) - 1} more)" if errors[1:] else ""
        raise Failed(f"{errors[0].check} in {errors[0].where}: {errors[0].message}{more}; see `vpr-bench data lint`")


@check("renders-the-same", "ends-decode")
def renders_the_same(subject: DatasetSubject) -> None:
    """Check that the simulated edition, rendered again, is the same in every byte."""
    source, simulation = subject.source, subject.source.whole.simulation
    if simulation is None or source.edition != "simulated":
        raise Skipped("these images are not simulated")
    before = subject.traverses()
    images = sum(len(recording) for recording in before.values())
    if images > _FEW:
        raise Skipped(f"rendering {images:,} images again would take long")
    renderer: Renderer = import_object(simulation.renderer, f"The renderer of {source.card.id}")(simulation.options)
    with tempfile.TemporaryDirectory(prefix="vpr-bench-check-") as folder:
        renderer.render(Path(folder))
        for one in source.card.traverses:
            again = load_traverse(source.card, one, Path(folder))
            if traverse_digest(again.traverse) != traverse_digest(before[one.name].traverse):
                raise Failed(f"{one.name} is another one when it is rendered again")


CHECKS = (protocols_load, places_make_sense, ends_decode, digests_repeat, lint_finds_no_errors, renders_the_same)
