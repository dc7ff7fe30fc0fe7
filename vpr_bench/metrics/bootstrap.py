"""How far a metric would move had other queries been drawn: percentile bootstrap over queries.

A resample draws as many queries as there are, with replacement, and counts each as often as it was drawn. All
metrics of a resample see the same draw, and so do two runs on the same queries with the same seed: that makes
:func:`bootstrap_difference` a paired comparison.

An interval ends on resampled values, and so that the chance to fall short of it, or beyond, is never taken too small:
with R resamples, the bounds at 95 % are the floor(.025 (R + 1))-th values from below and from above, but the least and
the greatest one where that is 0. A p-value is 2 (c + 1) / (R + 1), with c the number of resamples on 0 or on its rarer
side: an interval leaves out 0 just where p is at most the level.

Source: Efron and Tibshirani, An Introduction to the Bootstrap, chapters 13 (percentile interval), 15.4 and 16.4;
Davison and Hinkley, Bootstrap Methods and their Application, chapters 4.2 and 5.2, for R + 1.
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


@dataclass(frozen=True)
class Difference(Interval):
    """A difference with its interval, and how likely one as large is by chance.

    Attributes
    ----------
    p_value : float
        Two-sided, in (0, 1]: the smallest level at which the interval leaves out 0; NaN if there is no interval.
    """

    p_value: float


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
) -> dict[str, Difference]:
    """Give the difference ``first - second`` of each named metric its interval and p-value: a paired bootstrap.

    Both runs are resampled together. A difference is significant at ``1 - confidence`` where its p-value is at most
    that. The other parameters are those of :func:`bootstrap`.

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
        name: _difference(values[0][name] - values[1][name], samples[0][name] - samples[1][name], confidence)
        for name in names
    }


def _difference(value: float, samples: NDArray[np.float64], confidence: float) -> Difference:
    interval = percentile_interval(value, samples, confidence)
    return Difference(value, interval.low, interval.high, two_sided_p_value(samples))


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
    defined = np.sort(samples[~np.isnan(samples)])
    if len(defined) == 0:
        return Interval(value, np.nan, np.nan)
    outside = (1 - confidence) / 2 * (len(defined) + 1)
    rank = max(1, int(outside + 1e-9))  # a rounded .05 must not move the bound
    return Interval(value, float(defined[rank - 1]), float(defined[-rank]))


def two_sided_p_value(samples: NDArray[np.float64]) -> float:
    """Return the smallest level at which a percentile interval of bootstrapped differences leaves out 0.

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
