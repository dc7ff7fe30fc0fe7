"""How far a metric would move had other queries been drawn: percentile bootstrap over queries.

A resample draws as many queries as there are, with replacement, and counts each as often as it was drawn. All
metrics of a resample see the same draw, and so do two runs on the same queries with the same seed: that makes
:func:`bootstrap_difference` a paired comparison.

Source: Efron and Tibshirani, An Introduction to the Bootstrap, chapter 13 (percentile interval).
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import UsageError
from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.definitions import compute, lookup

CHUNK_ELEMENTS = 1 << 20
"""Weights held at once; bounds the memory to some ten arrays of 8 MiB."""


@dataclass(frozen=True)
class Interval:
    """A value and where the middle of its bootstrap distribution lies.

    Attributes
    ----------
    value : float
        On all queries, each once; NaN if undefined.
    low, high : float
        Bounds of the interval; NaN if the metric is undefined in every resample. Resamples in which it is
        undefined are left out.
    """

    value: float
    low: float
    high: float


def bootstrap(
    answers: Answers, names: Iterable[str], resamples: int = 2000, seed: int = 0, confidence: float = 0.95
) -> dict[str, Interval]:
    """Give each named metric its interval.

    Parameters
    ----------
    answers : Answers
    names : ids of metrics
        As in :func:`vpr_bench.metrics.definitions.lookup`.
    resamples : int
        At least 1.
    seed : int
        The same seed gives the same interval.
    confidence : float
        In (0, 1).

    Raises
    ------
    UsageError
        If a name is unknown or a number is out of range.

    Examples
    --------
    >>> flags = np.arange(100) < 60
    >>> answers = Answers(flags, np.linspace(1, 0, 100), np.ones(100, bool), np.where(flags, 0, 9))
    >>> interval = bootstrap(answers, ["recall@1"])["recall@1"]
    >>> interval.low < interval.value == 0.6 < interval.high
    True
    """
    names = list(names)
    values, samples = compute(names, answers), resampled(answers, names, resamples, seed)
    return {name: percentile_interval(values[name], samples[name], confidence) for name in names}


def bootstrap_difference(
    first: Answers,
    second: Answers,
    names: Iterable[str],
    resamples: int = 2000,
    seed: int = 0,
    confidence: float = 0.95,
) -> dict[str, Interval]:
    """Give the difference ``first - second`` of each named metric its interval: a paired bootstrap.

    Both runs are resampled together. A difference is significant at ``1 - confidence`` where the interval
    leaves out 0. The other parameters are those of :func:`bootstrap`.

    Raises
    ------
    ValueError
        If the two are not about the same queries, with and without a match, or differ in policy.
    """
    check_paired(first, second)
    names = list(names)
    values = [compute(names, answers) for answers in (first, second)]
    samples = [resampled(answers, names, resamples, seed) for answers in (first, second)]
    return {
        name: percentile_interval(values[0][name] - values[1][name], samples[0][name] - samples[1][name], confidence)
        for name in names
    }


def check_paired(first: Answers, second: Answers) -> None:
    """Refuse two runs that cannot be compared query by query.

    Raises
    ------
    ValueError
        If the two are not about the same queries, with and without a match, or differ in policy.
    """
    columns = ((first.queries, second.queries), (first.has_match, second.has_match))
    if first.unmatched != second.unmatched or not all(np.array_equal(*pair) for pair in columns):
        raise ValueError("a paired comparison needs two runs on the same queries under the same policy")


def resampled(
    answers: Answers, names: Iterable[str], resamples: int = 2000, seed: int = 0
) -> dict[str, NDArray[np.float64]]:
    """Compute each named metric on every resample.

    Returns
    -------
    dict of (resamples,) float64
        NaN in the resamples in which the metric is undefined. Resample ``i`` of two runs on the same queries
        draws the same queries if the seed is the same.
    """
    if resamples < 1:
        raise UsageError(f"The number of resamples must be at least 1. Got {resamples} instead.")
    functions = {name: lookup(name).function for name in names}
    samples = {name: np.full(resamples, np.nan) for name in functions}
    done = 0
    for weight in _draws(len(answers), resamples, seed):
        drawn = replace(answers, weight=weight)
        for name, function in functions.items():
            if function is not None:
                samples[name][done : done + len(weight)] = function(drawn)
        done += len(weight)
    return samples


def _draws(n: int, resamples: int, seed: int) -> Iterator[NDArray[np.float64]]:
    """Yield (chunk, n) float64: how often each resample draws each of ``n`` queries."""
    generator = np.random.default_rng(seed)
    chunk = max(1, CHUNK_ELEMENTS // max(n, 1))
    for start in range(0, resamples, chunk):
        weight = np.zeros((min(chunk, resamples - start), n))
        for row in weight:  # one by one, so that the draws do not depend on the size of a chunk
            if n:
                row[:] = np.bincount(generator.integers(n, size=n), minlength=n)
        yield weight


def percentile_interval(value: float, samples: NDArray[np.float64], confidence: float = 0.95) -> Interval:
    """Return a value with the interval that holds the middle of its (resamples,) float64 values, NaN left out.

    Raises
    ------
    UsageError
        If the confidence is not in (0, 1).
    """
    if not 0 < confidence < 1:
        raise UsageError(f"The confidence must lie between 0 and 1. Got {confidence} instead.")
    defined = samples[~np.isnan(samples)]
    if len(defined) == 0:
        return Interval(value, np.nan, np.nan)
    low, high = np.quantile(defined, [(1 - confidence) / 2, (1 + confidence) / 2])
    return Interval(value, float(low), float(high))
