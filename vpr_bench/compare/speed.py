"""How many times as long one run took as another, where that can be said."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError, blaming
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.metrics.latency import TOTAL
from vpr_bench.metrics.ratios import paired_ratio
from vpr_bench.report.foreign import shortened
from vpr_bench.runner.fair_times import doubt
from vpr_bench.runner.store import StoredRun

_DECODE = "decode"  # reading the image: no part of the method
_MACHINE = 120  # characters of its description
_ORDER = ("encode", "match", "rerank")


@dataclass(frozen=True)
class StageRatio:
    """One stage of answering in both runs.

    Attributes
    ----------
    stage : str
        As the methods call it, or ``total``.
    first_ms, second_ms : float
        Median over the queries, in milliseconds.
    ratio : Interval
        Second over first: the median over queries of the ratio of the two times, with its 95 % bootstrap interval. NaN
        where a time is 0.
    p_value : float
        Wilcoxon's signed-rank test of the logarithms of the ratios, two-sided; NaN where a time is 0.
    """

    stage: str
    first_ms: float
    second_ms: float
    ratio: Interval
    p_value: float

    @property
    def significant(self) -> bool:
        """Whether the interval leaves out 1."""
        return self.ratio.low > 1 or self.ratio.high < 1


@dataclass(frozen=True)
class Speed:
    """The times of two runs beside each other.

    Attributes
    ----------
    stages : sequence of StageRatio
        Those that both noted, the total last; none if the times cannot be compared.
    refused : str
        Why they cannot; else empty.
    doubts : sequence of str
        What speaks against trusting them.
    """

    stages: Sequence[StageRatio]
    refused: str
    doubts: Sequence[str]


def compare_speed(first: StoredRun, second: StoredRun, resamples: int = 2000, seed: int = 0) -> Speed:
    """Compare the times of two runs on the same queries, if they are of the same machine.

    Parameters
    ----------
    first, second : StoredRun
        A and B.
    resamples, seed : int
        Of the bootstrap over queries.

    Raises
    ------
    DataError
        If a run's times are damaged.
    """
    if refused := _refusal(first, second):
        return Speed((), refused, ())
    times = [_times(run) for run in (first, second)]
    stages = sorted(times[0].keys() & times[1].keys(), key=_place)
    ratios = [_stage(name, times[0][name], times[1][name], resamples, seed) for name in stages]
    return Speed(ratios, "", _doubts(first, second))


def _refusal(first: StoredRun, second: StoredRun) -> str:
    machines = first.record.machine, second.record.machine
    if machines[0].fingerprint == machines[1].fingerprint:
        return ""
    named = [shortened(str(machine), _MACHINE) for machine in machines]
    return f"A ran on {named[0]}; B on {named[1]}"


def _times(run: StoredRun) -> dict[str, NDArray[np.float64]]:
    with blaming(f"{run.folder} is damaged", DataError):
        columns = {name: column for name, column in run.seconds.items() if name != _DECODE}
        for name, column in columns.items():
            if column.shape != run.queries.shape or not np.isfinite(column).all() or (column < 0).any():
                raise DataError(f"{run.folder} is damaged: the times of {name} are not one per query.")
    return columns


def _place(stage: str) -> tuple[int, str]:
    """Sort the stages that most methods have first, and the total last."""
    if stage == TOTAL:
        return len(_ORDER) + 1, stage
    return (_ORDER.index(stage) if stage in _ORDER else len(_ORDER)), stage


def _stage(name: str, first: NDArray[np.float64], second: NDArray[np.float64], resamples: int, seed: int) -> StageRatio:
    before, after = (1000 * float(np.median(column)) if len(column) else math.nan for column in (first, second))
    ratio = paired_ratio(second[None], first[None], resamples, seed)
    return StageRatio(name, before, after, ratio, signed_rank_p_value(first, second))


def signed_rank_p_value(first: NDArray[np.float64], second: NDArray[np.float64]) -> float:
    """Return how likely ratios as lopsided as these are by chance, were both equally fast.

    Wilcoxon's signed-rank test, two-sided, on the logarithms of ``second / first``; exact for few queries.

    Source: F. Wilcoxon, Individual comparisons by ranking methods, Biometrics Bulletin 1, 1945.

    Parameters
    ----------
    first, second : (n,) float64
        Seconds of the same queries.

    Returns
    -------
    float
        In (0, 1]; NaN without queries and where a time is 0.

    Examples
    --------
    >>> signed_rank_p_value(np.array([1.0, 2.0, 3.0, 4.0]), np.array([1.1, 2.3, 3.6, 4.9]))
    0.125
    """
    if not len(first) or not (first > 0).all() or not (second > 0).all():
        return math.nan
    logarithms = np.log(second) - np.log(first)
    if not logarithms.any():
        return 1.0
    from scipy.stats import wilcoxon

    return float(wilcoxon(logarithms).pvalue)


def _doubts(first: StoredRun, second: StoredRun) -> list[str]:
    found = []
    for name, run in (("A", first), ("B", second)):
        if run.record.resumed:
            found.append(f"{name} was interrupted and continued, so that its times are of several processes")
        elif said := doubt(run.record.provenance.elsewhere):
            found.append(f"{said} during {name}")
    return found
