"""One line of a result: a stored run, scored on one protocol."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.bootstrap import Interval, bootstrap
from vpr_bench.metrics.definitions import evaluate
from vpr_bench.metrics.latency import latency
from vpr_bench.metrics.losses import Step, losses
from vpr_bench.metrics.undefined import or_none
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
    steps : list of Step
        Where the right place was lost; empty if the method noted no shortlists.
    """

    method: str
    protocol: Protocol
    partial: bool
    metrics: dict[str, float]
    intervals: dict[str, tuple[float, float]]
    latency: dict[str, float]
    run: StoredRun
    steps: list[Step] = field(default_factory=list)

    def as_dict(self) -> dict[str, Any]:
        """Return everything JSON-able, NaN as None."""
        record = self.run.record
        return {
            "method": self.method,
            "protocol": str(self.protocol),
            "radius": self.protocol.radius,
            "unit": self.protocol.unit,
            "partial": self.partial,
            "n_references": record.n_references,
            "n_queries": record.n_queries,
            "metrics": {name: or_none(value) for name, value in self.metrics.items()},
            "intervals": {name: [or_none(low), or_none(high)] for name, (low, high) in self.intervals.items()},
            "steps": [_step(step) for step in self.steps],
            "latency_ms": {name: or_none(value) for name, value in self.latency.items()},
            "fit_seconds": record.fit_seconds,
            "peak_memory_bytes": record.peak_memory,
            "seed": record.key.seed,
            "threads": record.key.threads,
            "processor": record.machine.processor,
            "weights": record.key.weights,
            "folder": str(self.run.folder),
        }

    def flat(self) -> dict[str, Any]:
        """Return the same with one entry per number, for a table of many columns."""
        content = self.as_dict()
        metrics, intervals, times = content.pop("metrics"), content.pop("intervals"), content.pop("latency_ms")
        memory, steps = content.pop("peak_memory_bytes"), content.pop("steps")
        content |= metrics
        content |= {f"{name}_low": low for name, (low, _) in intervals.items()}
        content |= {f"{name}_high": high for name, (_, high) in intervals.items()}
        for step in steps:
            name = step["step"].replace(" ", "_")
            content[f"left_after_{name}"] = step["left"]
            for part, column in (("recall", f"recall_after_{name}"), ("lost", f"lost_by_{name}")):
                content[column] = step[part]
                if bounds := step.get(f"{part}_interval"):
                    content[f"{column}_low"], content[f"{column}_high"] = bounds
        return {**content, **times, **{f"peak_memory_{phase}_bytes": size for phase, size in memory.items()}}


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
        found = bootstrap(answers_of(run, protocol), metrics, resamples)
        intervals = {name: (interval.low, interval.high) for name, interval in found.items()}
    record = run.record
    steps = losses(run.survivors, run.indices, run.scores, truth, protocol.unmatched, resamples)
    return Row(record.label, protocol, record.partial, values, intervals, latency(run.seconds), run, steps)


def answers_of(run: StoredRun, protocol: Protocol | None = None) -> Answers:
    """Judge what a run answered, query by query: what metrics, comparisons and the gate are made of.

    Parameters and errors are those of :func:`score_run`.
    """
    protocol = protocol or run.protocol
    truth = run.places.ground_truth(protocol)
    return Answers.from_matches(run.indices, run.scores, truth, protocol.unmatched, run.queries)


def _step(step: Step) -> dict[str, Any]:
    content = {
        "step": step.name,
        "left": or_none(step.left),
        "recall": or_none(step.recall.value),
        "lost": or_none(step.lost.value),
    }
    intervals = {"recall_interval": step.recall, "lost_interval": step.lost}
    return content | {name: _bounds(interval) for name, interval in intervals.items() if not math.isnan(interval.low)}


def _bounds(interval: Interval) -> list[float | None]:
    return [or_none(interval.low), or_none(interval.high)]
