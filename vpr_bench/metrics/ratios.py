"""How many times as long one method takes as another, measured on the same images in turn."""

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.bootstrap import Interval, percentile_interval


def paired_ratio(
    seconds: NDArray[np.float64],
    first: NDArray[np.float64],
    resamples: int = 2000,
    seed: int = 0,
    confidence: float = 0.95,
) -> Interval:
    """Compare the times of two methods that were asked the same images one right after the other.

    A ratio is taken of the two times of each image in each round, which lie so close together that whatever else the
    machine did has slowed down both. An image's ratio is the median over its rounds, the value the median over the
    images: single disturbed answers do not move it, and of two equal methods neither comes out ahead, as in a mean of
    ratios the slower one of each pair would. The interval is a percentile bootstrap over images, each drawn with all
    its rounds.

    Parameters
    ----------
    seconds, first : (rounds, n) float64
        Of the method in question, and of the one that it is compared with.
    resamples : int
        How many.
    seed : int
        The same seed gives the same interval.
    confidence : float
        In (0, 1).

    Returns
    -------
    Interval
        NaN without images, and where the first took no time at all.

    Raises
    ------
    ValueError
        If the two were not measured on as many images and rounds.

    Examples
    --------
    >>> first = np.array([[0.010, 0.020, 0.030], [0.011, 0.022, 0.090]])
    >>> paired_ratio(2 * first, first)
    Interval(value=2.0, low=2.0, high=2.0)
    """
    if seconds.shape != first.shape:
        raise ValueError(f"times must be of the same images and rounds. Got {seconds.shape} and {first.shape} instead.")
    if not seconds.size:
        return Interval(np.nan, np.nan, np.nan)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = seconds / first
    ratios[~np.isfinite(ratios)] = np.nan
    images = np.median(ratios, axis=0)
    generator, n = np.random.default_rng(seed), len(images)
    samples = np.array([np.median(images[generator.integers(n, size=n)]) for _ in range(resamples)])
    return percentile_interval(float(np.median(images)), samples, confidence)
