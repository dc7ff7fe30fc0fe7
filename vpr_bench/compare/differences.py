"""By how much two runs differ in each metric, and whether that may be chance."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from vpr_bench.compare.pair import RunPair
from vpr_bench.metrics.bootstrap import Difference, bootstrap_difference
from vpr_bench.metrics.definitions import compute
from vpr_bench.metrics.pairs import pr_auc_pairs_of_matches
from vpr_bench.progress import task

LEVEL = 0.05
PAIRS = "pr_auc_pairs"
"""The metric that needs every score, and cannot be resampled."""


@dataclass(frozen=True)
class MetricDifference:
    """One metric of both runs.

    Attributes
    ----------
    metric : str
        Its id.
    first, second : float
        In [0, 1]; NaN where undefined.
    difference : Difference
        Second minus first in [-1, 1], with its 95 % interval and p-value from a paired bootstrap over queries; both are
        NaN where the metric cannot be resampled.
    """

    metric: str
    first: float
    second: float
    difference: Difference

    @property
    def p_value(self) -> float:
        """Of the difference, two-sided, in (0, 1]."""
        return self.difference.p_value

    @property
    def significant(self) -> bool:
        """Whether the p-value is at most .05; the interval then leaves out 0."""
        return self.p_value <= LEVEL


def differences(pair: RunPair, metrics: Sequence[str], resamples: int = 2000, seed: int = 0) -> list[MetricDifference]:
    """Compare two runs by every metric.

    Each metric stands for itself: intervals and p-values are not adjusted for there being several.

    Parameters
    ----------
    pair : RunPair
        The runs.
    metrics : sequence of str
        Their ids.
    resamples, seed : int
        Of the paired bootstrap.

    Raises
    ------
    UsageError
        If there is no such metric, or no resample.
    """
    first, second = (_values(pair, metrics, index) for index in (0, 1))
    with task("Resampling the queries"):
        found = bootstrap_difference(pair.answers[1], pair.answers[0], metrics, resamples, seed)
    return [
        MetricDifference(name, first[name], second[name], replace(one, value=second[name] - first[name]))
        for name, one in found.items()
    ]


def _values(pair: RunPair, metrics: Sequence[str], index: int) -> dict[str, float]:
    """Compute the metrics of one run, that of all pairs among them."""
    values, run = compute(metrics, pair.answers[index]), (pair.first, pair.second)[index]
    if PAIRS in values:
        values[PAIRS] = pr_auc_pairs_of_matches(run.indices, run.scores, pair.truth, pair.protocol.unmatched)
    return values
