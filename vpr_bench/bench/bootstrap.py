"""How long it takes to give every metric its interval, at full size."""

import platform
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any

import numpy as np

from vpr_bench.bench.memory import peak_rss_bytes
from vpr_bench.metrics.answers import NEVER, Answers
from vpr_bench.metrics.bootstrap import bootstrap
from vpr_bench.metrics.definitions import METRICS
from vpr_bench.metrics.undefined import or_none
from vpr_bench.runner.resources import limit_threads

_DEPTH = 20  # as many answers per query as a run keeps by default


def run(queries: int = 27_592, resamples: int = 2000, seed: int = 0) -> dict[str, Any]:
    """Measure :func:`vpr_bench.metrics.bootstrap.bootstrap` on made-up answers, in a fresh process, on one core.

    All metrics are computed that answers suffice for. No two scores are equal, so that every query is a threshold of
    its own, which is the most work. The clock runs from the answers in memory to the intervals.

    Parameters
    ----------
    queries : int
        The default is the size of the Nordland test set.
    resamples : int
        How often they are drawn anew.
    seed : int
        Of the answers and the draws.

    Returns
    -------
    dict
        JSON-able: sizes, machine, ``seconds``, ``processor_seconds``, which other processes do not lengthen,
        ``peak_rss_bytes`` of the whole process, and the ``intervals``
        as value, low and high, None where undefined.
    """
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(_measure, queries, resamples, seed).result()


def made_up_answers(queries: int, seed: int) -> Answers:
    """Make answers of a method whose score tells, but not reliably, whether it is right.

    The score is uniform in [0, 1) and at the same time the chance to be right.
    """
    generator = np.random.default_rng(seed)
    score = generator.random(queries)
    right = generator.random(queries) < score
    later = generator.integers(1, 2 * _DEPTH, queries)
    rank = np.where(right, 0, np.where(later < _DEPTH, later, NEVER))
    return Answers(right, score, np.ones(queries, dtype=bool), rank, depth=_DEPTH)


def _measure(queries: int, resamples: int, seed: int) -> dict[str, Any]:
    answers = made_up_answers(queries, seed)
    metrics = [metric.id for metric in METRICS.values() if metric.function is not None]
    with limit_threads(1):
        start, busy = time.perf_counter(), time.process_time()
        intervals = bootstrap(answers, metrics, resamples, seed)
        seconds, busy = time.perf_counter() - start, time.process_time() - busy
    return {
        "benchmark": "bootstrap",
        "queries": queries,
        "resamples": resamples,
        "metrics": len(metrics),
        "seed": seed,
        "threads": 1,
        "machine": platform.machine(),
        "seconds": seconds,
        "processor_seconds": busy,
        "peak_rss_bytes": peak_rss_bytes(),
        "intervals": {
            name: [or_none(one.value), or_none(one.low), or_none(one.high)] for name, one in intervals.items()
        },
    }
