"""From a baseline and runs to verdicts."""

import math
from collections.abc import Iterable, Sequence

import numpy as np

from vpr_bench.errors import DataError, VprBenchError, blaming
from vpr_bench.gate.baseline import Baseline
from vpr_bench.gate.cell import Cell, other_images
from vpr_bench.gate.latency_change import LatencyChange, latency_change
from vpr_bench.gate.matching import choose, near_misses, without_cell
from vpr_bench.gate.metric_change import MetricChange, metric_change
from vpr_bench.gate.recording import record_cell
from vpr_bench.gate.rules import Overrides, Rules
from vpr_bench.gate.verdict import Changed, Judgement, Verdict, error, missing, new
from vpr_bench.metrics.bootstrap import check_paired
from vpr_bench.metrics.definitions import compute
from vpr_bench.metrics.flips import flips
from vpr_bench.report.rows import answers_of
from vpr_bench.runner.store import StoredRun


def judge(
    baseline: Baseline, runs: Iterable[StoredRun], overrides: Overrides | None = None, *, named: bool = False
) -> Judgement:
    """Judge runs by a baseline.

    Parameters
    ----------
    baseline : Baseline
        Every cell is judged, or missing.
    runs : iterable of StoredRun
        Those that belong to no cell are new.
    overrides : Overrides, optional
        Instead of the baseline's rules.
    named : bool
        As of :func:`vpr_bench.gate.matching.without_cell`.

    Raises
    ------
    UsageError
        If the overrides make no sense.
    """
    runs, overrides = list(runs), overrides or Overrides()
    verdicts = []
    for cell in baseline.cells.values():
        rules, run = overrides.apply(baseline.rules_of(cell)), choose(cell, runs)
        if run is None:
            verdicts.append(missing(cell.label, cell.protocol, near_misses(cell, runs)))
        else:
            verdicts.append(judge_run(cell, run, rules))
    usual, fresh = overrides.apply(baseline.rules), without_cell(baseline.cells.values(), runs, named=named)
    return Judgement(verdicts + [_new(run, usual) for run in fresh])


def judge_run(cell: Cell, run: StoredRun, rules: Rules) -> Verdict:
    """Judge one run by its cell; what cannot be judged becomes a verdict too."""
    try:
        with blaming(f"{run.folder} cannot be judged", DataError):
            return _judged(cell, run, rules)
    except VprBenchError as fault:
        return error(cell.label, cell.protocol, fault, run.folder)


def _new(run: StoredRun, rules: Rules) -> Verdict:
    label, protocol = run.record.label, run.record.protocol
    try:
        with blaming(f"{run.folder} cannot be judged", DataError):
            values = compute(rules.metrics, answers_of(run))
    except VprBenchError as fault:
        return error(label, protocol, fault, run.folder)
    metrics = [MetricChange(name, math.nan, values[name], rules.metrics[name]) for name in sorted(values)]
    return new(label, protocol, metrics, run.folder, _seconds(run))


def _judged(cell: Cell, run: StoredRun, rules: Rules) -> Verdict:
    if run.record.key.dataset_digest != cell.dataset:
        raise other_images(cell, run.record.key.dataset_digest, "in the run")
    now = record_cell(run, cell.asked, rules.metrics)
    before, after = cell.judged, now.judged
    try:
        check_paired(before, after)
    except ValueError:
        raise DataError("which queries have a true match is not as it was, although the images are.") from None
    metrics = [metric_change(name, rule, before, after) for name, rule in sorted(rules.metrics.items())]
    moved = np.flatnonzero(cell.answered.best != now.answered.best)
    changed = [Changed(int(row), int(cell.answered.best[row]), int(now.answered.best[row])) for row in moved]
    times, flipped = latency_change(cell, now, rules.latency_ratio), flips(before, after)
    reasons = [fault for change in metrics for fault in change.faults]
    if rules.exact and changed:
        reasons.append(f"{len(changed)} of {cell.n_queries} queries have another best answer, and none may (exact)")
    reasons += [times.fault] if times.fault else []
    if rules.empty:
        reasons.append("the rules allow everything: give --tolerance, --significance or --exact")
    return Verdict(
        cell.label,
        cell.protocol,
        "fail" if reasons else "pass",
        reasons=reasons,
        notes=_notes(cell, now, metrics, times),
        metrics=metrics,
        lost=flipped.lost.tolist(),
        gained=flipped.gained.tolist(),
        changed=changed,
        latency=times,
        run=run.folder,
        seconds=_seconds(run),
    )


def _notes(cell: Cell, now: Cell, metrics: Sequence[MetricChange], times: LatencyChange) -> list[str]:
    """Tell what else is not as it was."""
    facts = {
        "version of the method": (cell.version, now.version),
        "weights": (cell.weights or "none", now.weights or "none"),
        "vpr-bench": (cell.package, now.package),
        "machine": (cell.machine.name, now.machine.name),
    }
    notes = [f"{name}: {before} → {after}" for name, (before, after) in facts.items() if before != after]
    notes += [times.note] if times.note else []
    unknown = [one.metric for one in metrics if math.isnan(one.before) and math.isnan(one.after) and not one.faults]
    notes += [f"{name} is undefined, then and now: it cannot fall" for name in unknown]
    return notes + [f"{one.metric} rose by {one.difference:.3f}" for one in metrics if one.difference > 0]


def _seconds(run: StoredRun) -> float:
    try:
        return run.record.fit_seconds + float(run.seconds["total"].sum())
    except (DataError, KeyError):
        return run.record.fit_seconds
