"""Two stored runs that were asked the same, and so can be compared query by query."""

from dataclasses import dataclass, replace

import numpy as np

from vpr_bench.errors import DataError, UsageError, blaming
from vpr_bench.metrics.answers import Answers
from vpr_bench.report.rows import answers_of
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Protocol, Unmatched


@dataclass(frozen=True, eq=False)
class RunPair:
    """Two runs about the same queries, and what is right for each.

    Attributes
    ----------
    first, second : StoredRun
        A and B.
    protocol : Protocol
        What both are judged by.
    truth : GroundTruth
        Of the queries that were asked.
    answers : (Answers, Answers)
        Of the queries that count, in the same order.
    """

    first: StoredRun
    second: StoredRun
    protocol: Protocol
    truth: GroundTruth
    answers: tuple[Answers, Answers]

    @classmethod
    def of(
        cls, first: StoredRun, second: StoredRun, radius: float | None = None, unmatched: Unmatched | None = None
    ) -> "RunPair":
        """Put two runs side by side.

        Parameters
        ----------
        first, second : StoredRun
            A and B.
        radius : float, optional
            Instead of the one that both were asked for.
        unmatched : {"exclude", "miss", "reject"}, optional
            Instead of the policy that both were asked for.

        Raises
        ------
        UsageError
            If they are one run, or were asked for different protocols or queries.
        DataError
            If the images were not the same, or a run is damaged.
        """
        _check_same_images(first, second)
        protocol = _common_protocol(first, second, radius, unmatched)
        _check_same_queries(first, second)
        truths = []
        for run in (first, second):
            with blaming(f"{run.folder} is damaged", DataError):
                truths.append(run.places.ground_truth(protocol))
        if truths[0] != truths[1]:
            raise DataError(
                f"{first.folder} and {second.folder} say that they are about the same images, and hold different "
                "places. Run one of them again."
            )
        return cls(first, second, protocol, truths[0], (_judged(first, protocol), _judged(second, protocol)))


def _judged(run: StoredRun, protocol: Protocol) -> Answers:
    with blaming(f"{run.folder} is damaged", DataError):
        return answers_of(run, protocol)


def _check_same_images(first: StoredRun, second: StoredRun) -> None:
    if first.folder.resolve() == second.folder.resolve() or first.record == second.record:
        raise UsageError(f"A and B are the same run, {first.folder}. Name two: `vpr-bench show` lists them.")
    asked = [f"{run.record.key.source}/{run.record.key.pairing}" for run in (first, second)]
    if asked[0] != asked[1]:
        raise UsageError(
            f"A was asked {asked[0]}, B {asked[1]}: only runs on the same images can be compared. "
            "`vpr-bench show` lists runs by what they were asked."
        )
    digests = [run.record.key.dataset_digest for run in (first, second)]
    if digests[0] != digests[1]:
        raise DataError(
            f"The images of {asked[0]} were not the same: {digests[0]:.19}… for A, {digests[1]:.19}… for B. "
            "Run the older one again."
        )


def _common_protocol(
    first: StoredRun, second: StoredRun, radius: float | None, unmatched: Unmatched | None
) -> Protocol:
    """Return what both runs are judged by; never choose between two that differ."""
    a, b = first.protocol, second.protocol
    if a.unit != b.unit:
        raise UsageError(
            f"A was asked for @{a.reach}, B for @{b.reach}, which is another measure of the same place. "
            "Run one of them again, on the protocol of the other."
        )
    if radius is None and a.radius != b.radius:
        raise UsageError(f"A was asked for the radius {a.reach}, B for {b.reach}. Say which counts with --radius.")
    if unmatched is None and a.unmatched != b.unmatched:
        raise UsageError(
            f"For queries without a true match A was asked to {a.unmatched}, B to {b.unmatched}. "
            "Say which counts with --unmatched."
        )
    return replace(a, radius=a.radius if radius is None else radius, unmatched=unmatched or a.unmatched)


def _check_same_queries(first: StoredRun, second: StoredRun) -> None:
    if np.array_equal(first.queries, second.queries):
        return
    both = len(np.intersect1d(first.queries, second.queries))
    raise UsageError(
        f"A was asked {_asked(first)}, B {_asked(second)}, and only {both:,} of them are the same. "
        "Run both with the same --limit and --seed, or both without --limit."
    )


def _asked(run: StoredRun) -> str:
    limit = run.record.key.limit
    return f"{len(run.queries):,} queries" + (f" (--limit {limit}, --seed {run.record.key.seed})" if limit else "")
