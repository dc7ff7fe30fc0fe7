"""Everything that a paired comparison of two stored runs says."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from vpr_bench.compare.differences import PAIRS, MetricDifference, differences
from vpr_bench.compare.flipped import FlippedQuery, flipped_queries
from vpr_bench.compare.pair import RunPair
from vpr_bench.compare.speed import Speed, compare_speed
from vpr_bench.metrics.definitions import METRICS
from vpr_bench.metrics.mcnemar import McNemar, mcnemar
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol, Unmatched


@dataclass(frozen=True, eq=False)
class PairedComparison:
    """What tells two runs on the same queries apart, and whether it may be chance.

    Attributes
    ----------
    first, second : StoredRun
        A and B.
    protocol : Protocol
        What both were judged by.
    n_queries, n_counted : int
        How many queries both were asked, and how many of them count under the protocol's policy.
    both, neither : int
        How many of those that count both answered right, and neither did.
    metrics : sequence of MetricDifference
        Second minus first.
    mcnemar : McNemar
        Of right answers.
    lost, gained : sequence of FlippedQuery
        Queries that only the first, and only the second answered right.
    speed : Speed
        Second over first.
    resamples, seed : int
        Of the bootstrap.
    """

    first: StoredRun
    second: StoredRun
    protocol: Protocol
    n_queries: int
    n_counted: int
    both: int
    neither: int
    metrics: Sequence[MetricDifference]
    mcnemar: McNemar
    lost: Sequence[FlippedQuery]
    gained: Sequence[FlippedQuery]
    speed: Speed
    resamples: int
    seed: int

    @property
    def folders(self) -> tuple[str, str]:
        """The names of the runs' folders; with the way to them where the names are the same."""
        folders = self.first.folder, self.second.folder
        if folders[0].name == folders[1].name:
            return str(folders[0]), str(folders[1])
        return folders[0].name, folders[1].name

    @property
    def identical(self) -> bool:
        """Whether both gave every query the same answers and scores, as far down as both kept them."""
        kept = [(run.indices, run.scores) for run in (self.first, self.second)]
        depth = min(indices.shape[1] for indices, _ in kept)
        return all(np.array_equal(a[:, :depth], b[:, :depth]) for a, b in zip(*kept, strict=True))

    @property
    def simulated(self) -> bool:
        """Whether the images were rendered by the project."""
        return self.protocol.simulated


def compare_runs(
    first: StoredRun,
    second: StoredRun,
    metrics: Sequence[str] | None = None,
    *,
    radius: float | None = None,
    unmatched: Unmatched | None = None,
    resamples: int = 2000,
    seed: int = 0,
) -> PairedComparison:
    """Compare two stored runs query by query. No method is asked.

    Parameters
    ----------
    first, second : StoredRun
        A and B: differences are B minus A.
    metrics : sequence of str, optional
        By default all, ``pr_auc_pairs`` only where both runs kept every score.
    radius : float, optional
        Instead of the one that both were asked for.
    unmatched : {"exclude", "miss", "reject"}, optional
        Instead of the policy that both were asked for.
    resamples, seed : int
        Of the bootstrap over queries.

    Raises
    ------
    UsageError
        If they are one run, were asked for different protocols or queries, or a metric is unknown.
    DataError
        If the images were not the same, or a run is damaged.
    """
    pair = RunPair.of(first, second, radius, unmatched)
    found = differences(pair, list(METRICS) if metrics is None else metrics, resamples, seed)
    if metrics is None:
        found = [one for one in found if one.metric != PAIRS or not math.isnan(one.difference.value)]
    right = [answers.correct for answers in pair.answers]
    lost, gained = flipped_queries(pair)
    return PairedComparison(
        first=first,
        second=second,
        protocol=pair.protocol,
        n_queries=len(first.queries),
        n_counted=len(pair.answers[0]),
        both=int((right[0] & right[1]).sum()),
        neither=int((~right[0] & ~right[1]).sum()),
        metrics=found,
        mcnemar=mcnemar(*right),
        lost=lost,
        gained=gained,
        speed=compare_speed(first, second, resamples, seed),
        resamples=resamples,
        seed=seed,
    )
