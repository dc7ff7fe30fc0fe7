"""One line of a result: a stored run, scored on one protocol."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.bootstrap import bootstrap
from vpr_bench.metrics.definitions import evaluate
from vpr_bench.metrics.latency import latency
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol

HEADLINE = ("recall@1", "recall@5", "pr_auc", "pr_auc_matched")
"""The metrics of the tables that ``run`` and ``show`` print."""


@dataclass(frozen=True)
class Row:
    """A run on a protocol, with every number that was asked for.

    Attributes
    ----------
    method : str
        Its label: the id with the parameters that differ from their defaults.
    protocol : Protocol
        What the metrics were computed on; the radius may differ from the stored one.
    partial : bool
        Only some queries were asked: never ranked.
    metrics : dict
        By id; NaN where undefined.
    intervals : dict
        Bounds of the 95 % bootstrap intervals, by id; empty unless asked for.
    latency : dict
        Milliseconds per query, ``latency_<stage>_p50|p95|p99``.
    run : StoredRun
        Where it comes from.
    """

    method: str
    protocol: Protocol
    partial: bool
    metrics: dict[str, float]
    intervals: dict[str, tuple[float, float]]
    latency: dict[str, float]
    run: StoredRun

    def as_dict(self) -> dict[str, Any]:
        """Return everything JSON-able, NaN as None."""
        record = self.run.record
        return {
            "method": self.method,
            "protocol": str(self.protocol),
            "partial": self.partial,
            "n_references": record.n_references,
            "n_queries": record.n_queries,
            "metrics": {name: _or_none(value) for name, value in self.metrics.items()},
            "intervals": {name: [_or_none(low), _or_none(high)] for name, (low, high) in self.intervals.items()},
            "latency_ms": {name: _or_none(value) for name, value in self.latency.items()},
            "fit_seconds": record.fit_seconds,
            "peak_memory_bytes": record.peak_memory,
            "seed": record.key.seed,
            "threads": record.key.threads,
            "processor": record.machine.processor,
            "weights": record.key.weights,
            "folder": str(self.run.folder),
        }


def score_run(
    run: StoredRun,
    metrics: Sequence[str] = HEADLINE,
    protocol: Protocol | None = None,
    resamples: int = 0,
) -> Row:
    """Compute metrics from what a run stored; the method is not asked again.

    Parameters
    ----------
    run : StoredRun
        A complete run.
    metrics : sequence of str
        Metric ids.
    protocol : Protocol, optional
        Instead of the one that the run was asked for: another radius, unit or policy, but the same images.
    resamples : int
        Of the bootstrap; 0 for no intervals.

    Raises
    ------
    UsageError
        If a metric is unknown, or the run's places do not say what is right in this protocol.
    """
    protocol = protocol or run.protocol
    truth = run.places.ground_truth(protocol)
    values = evaluate(metrics, run.indices, run.scores, truth, protocol.unmatched)
    intervals = {}
    if resamples:
        answers = Answers.from_matches(run.indices, run.scores, truth, protocol.unmatched)
        found = bootstrap(answers, metrics, resamples)
        intervals = {name: (interval.low, interval.high) for name, interval in found.items()}
    record = run.record
    return Row(record.label, protocol, record.partial, values, intervals, latency(run.seconds), run)


def _or_none(value: float) -> float | None:
    return None if math.isnan(value) else value
