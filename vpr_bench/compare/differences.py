"""By how much two runs differ in each metric, and whether that may be chance."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.compare.pair import RunPair
from vpr_bench.metrics.bootstrap import Interval, percentile_interval, resampled
from vpr_bench.metrics.definitions import evaluate
from vpr_bench.progress import track


@dataclass(frozen=True)
class MetricDifference:
    """One metric of both runs.

    Attributes
    ----------
    metric : str
        Its id.
    first, second : float
        In [0, 1]; NaN where undefined.
    difference : Interval
        Second minus first in [-1, 1], with its 95 % interval from a paired bootstrap over queries. Bounds are NaN where
        the metric cannot be resampled.
    p_value : float
        Two-sided, in (0, 1]: the smallest level at which the interval would leave out 0. NaN where there is none.
    """

    metric: str
    first: float
    second: float
    difference: Interval
    p_value: float

    @property
    def significant(self) -> bool:
        """Whether the interval leaves out 0."""
        return self.difference.low > 0 or self.difference.high < 0


def differences(pair: RunPair, metrics: Sequence[str], resamples: int = 2000, seed: int = 0) -> list[MetricDifference]:
    """Compare two runs by every metric.

    Both runs are resampled together, as in :func:`~vpr_bench.metrics.bootstrap.bootstrap_difference`. Each metric
    stands for itself: intervals and p-values are not adjusted for there being several.

    Parameters
    ----------
    pair : RunPair
        The runs.
    metrics : sequence of str
        Their ids.
    resamples, seed : int
        Of the bootstrap.

    Raises
    ------
    UsageError
        If there is no such metric, or no resample.
    """
    values = [
        evaluate(metrics, run.indices, run.scores, pair.truth, pair.protocol.unmatched)
        for run in (pair.first, pair.second)
    ]
    samples = [
        resampled(answers, metrics, resamples, seed) for answers in track(pair.answers, "Resampling the queries")
    ]
    return [
        _difference(name, values[0][name], values[1][name], samples[1][name] - samples[0][name])
        for name in dict.fromkeys(metrics)
    ]


def _difference(metric: str, first: float, second: float, samples: NDArray[np.float64]) -> MetricDifference:
    return MetricDifference(
        metric, first, second, percentile_interval(second - first, samples), two_sided_p_value(samples)
    )


def two_sided_p_value(samples: NDArray[np.float64]) -> float:
    """Return the smallest level at which a percentile interval of bootstrapped differences would leave out 0.

    It is twice the share of the resamples on 0 or on its rarer side, with one more counted in, so that no finite number
    of resamples says 0.

    Source: Efron and Tibshirani, An Introduction to the Bootstrap, chapters 15.4 and 16.4; Davison and Hinkley,
    Bootstrap Methods and their Application, chapter 4.2, for the one more.

    Parameters
    ----------
    samples : (resamples,) float64
        NaN are left out; without any others the result is NaN.

    Examples
    --------
    >>> two_sided_p_value(np.array([0.1] * 97 + [-0.1] * 2)), two_sided_p_value(np.zeros(9))
    (0.06, 1.0)
    """
    defined = samples[~np.isnan(samples)]
    if len(defined) == 0:
        return float("nan")
    rarer = min((defined <= 0).sum(), (defined >= 0).sum())
    return min(1.0, 2 * float(rarer + 1) / (len(defined) + 1))
