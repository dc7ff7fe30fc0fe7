"""How long one query takes: percentiles of each stage and of the whole."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

PERCENTILES = (50, 95, 99)
TOTAL = "total"


def latency(seconds: Mapping[str, NDArray[np.float64]]) -> dict[str, float]:
    """Summarise the seconds that each stage took for each query, in milliseconds.

    Parameters
    ----------
    seconds : dict of (n,) float64
        Per stage the seconds of every query, without the warm-up. The total is what was measured as
        ``total``; where that is missing, it is the sum of the stages, query by query.

    Returns
    -------
    dict
        ``latency_<stage>_p50``, ``_p95`` and ``_p99`` for every stage, the total last; NaN without queries.
        Percentiles interpolate linearly between the two nearest queries.

    Raises
    ------
    ValueError
        If the stages were not measured on the same number of queries.

    Examples
    --------
    >>> values = latency({"encode": np.array([0.010, 0.020]), "match": np.array([0.001, 0.001])})
    >>> round(values["latency_encode_p50"], 3), round(values["latency_total_p50"], 3)
    (15.0, 16.0)
    """
    stages = {name: np.asarray(column, dtype=np.float64) for name, column in seconds.items() if name != TOTAL}
    if len({len(column) for column in seconds.values()}) > 1:
        lengths = {name: len(column) for name, column in seconds.items()}
        raise ValueError(f"all stages must be measured on the same queries. Got {lengths} instead.")
    if TOTAL in seconds:
        stages[TOTAL] = np.asarray(seconds[TOTAL], dtype=np.float64)
    elif stages:
        stages[TOTAL] = np.sum(list(stages.values()), axis=0)
    values: dict[str, float] = {}
    for name, column in stages.items():
        values |= percentiles(name, column)
    return values


def percentiles(name: str, seconds: NDArray[np.float64]) -> dict[str, float]:
    """Return ``latency_<name>_p50``, ``_p95`` and ``_p99`` of (n,) seconds, in milliseconds; NaN without any."""
    quantiles = np.percentile(seconds, PERCENTILES) if len(seconds) else [np.nan] * len(PERCENTILES)
    return {
        f"latency_{name}_p{percentile}": 1000 * float(quantile)
        for percentile, quantile in zip(PERCENTILES, quantiles, strict=True)
    }
