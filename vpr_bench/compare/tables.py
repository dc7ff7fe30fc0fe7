"""A comparison as tables for people."""

import math
from collections.abc import Callable, Sequence

from vpr_bench.compare.caveats import caveats, time_caveats
from vpr_bench.compare.differences import MetricDifference
from vpr_bench.compare.flipped import Best, FlippedQuery
from vpr_bench.compare.paired import PairedComparison
from vpr_bench.compare.speed import StageRatio
from vpr_bench.errors import one_line
from vpr_bench.report.foreign import shortened
from vpr_bench.report.grid import Grid
from vpr_bench.report.numbers import UNDEFINED, milliseconds, share
from vpr_bench.runner.store import StoredRun

MOST = 20
"""Flipped queries that a table lists, each way."""


def comparison_grids(comparison: PairedComparison, name_of: Callable[[int], str]) -> list[Grid]:
    """Lay a comparison out: the runs, metrics, times, and the queries that flipped each way.

    Parameters
    ----------
    comparison : PairedComparison
        Of two runs.
    name_of : callable
        What to call a query.
    """
    grids = [_runs(comparison), _metrics(comparison)]
    if comparison.speed.stages:
        grids.append(_times(comparison))
    ways = (("A", comparison.lost), ("B", comparison.gained))
    return grids + [_flips(comparison, who, flipped, name_of) for who, flipped in ways if flipped]


def label_of(run: StoredRun) -> str:
    """Return a run's method, cut where it is very long, and marked where only some queries were asked."""
    return shortened(run.record.label) + (" (partial)" if run.record.partial else "")


def names_of(comparison: PairedComparison) -> list[str]:
    """Return the beginnings of the runs' hashes, or their folders where those are the same."""
    short = [run.folder.name[:6] for run in (comparison.first, comparison.second)]
    return short if short[0] != short[1] else [one_line(name) for name in comparison.folders]


def _runs(comparison: PairedComparison) -> Grid:
    count = f"{comparison.n_queries:,} queries"
    if comparison.n_counted != comparison.n_queries:
        count = f"{comparison.n_counted:,} of {count} count"
    labels = [f"A  {label_of(comparison.first)}", f"B  {label_of(comparison.second)}"]
    rows = list(zip(labels, names_of(comparison), strict=True))
    return Grid(_titled(comparison, f"{comparison.protocol}  {count}"), ["method", "run"], rows)


def _metrics(comparison: PairedComparison) -> Grid:
    notes = [
        f"95 %, p: paired bootstrap over queries, {comparison.resamples:,} resamples, seed {comparison.seed}",
        _right_answers(comparison),
        *caveats(comparison),
        *([] if comparison.speed.stages else time_caveats(comparison)),
    ]
    head = ["metric", "A", "B", "B - A", "95 %", "p", "better"]
    return Grid(
        _titled(comparison, "is B better?"), head, [_metric(one) for one in comparison.metrics], "\n".join(notes)
    )


def _right_answers(comparison: PairedComparison) -> str:
    test = comparison.mcnemar
    return (
        f"right answers: {comparison.both:,} both, {test.only_first:,} only A, {test.only_second:,} only B, "
        f"{comparison.neither:,} neither; McNemar's exact test: p {_p_value(test.p_value, '= ')}"
    )


def _metric(one: MetricDifference) -> Sequence[str]:
    low, high = one.difference.low, one.difference.high
    known = not math.isnan(low)
    return [
        one.metric,
        share(one.first),
        share(one.second),
        _signed(one.difference.value),
        f"{_signed(low)} … {_signed(high)}" if known else "",
        _p_value(one.p_value) if known else "",
        _better(first=one.significant and high < 0, second=one.significant and low > 0) if known else "",
    ]


def _times(comparison: PairedComparison) -> Grid:
    machine = comparison.first.record.machine
    notes = [
        f"ms: median per query, image already decoded, threads: {machine.threads}, {shortened(machine.processor)}",
        "B / A: median ratio per query, 95 %: bootstrap over queries, p: Wilcoxon's signed-rank test",
        *time_caveats(comparison),
    ]
    head = ["stage", "A ms", "B ms", "B / A", "95 %", "p", "faster"]
    rows = [_stage(one) for one in comparison.speed.stages]
    return Grid(_titled(comparison, "is B faster?"), head, rows, "\n".join(notes))


def _stage(one: StageRatio) -> Sequence[str]:
    low, high = one.ratio.low, one.ratio.high
    known = not math.isnan(low)
    return [
        shortened(one.stage, 30),
        milliseconds(one.first_ms),
        milliseconds(one.second_ms),
        share(one.ratio.value),
        f"{share(low)}–{share(high)}" if known else "",
        _p_value(one.p_value),
        _better(first=low > 1, second=high < 1) if known else "",
    ]


def _flips(
    comparison: PairedComparison, who: str, flipped: Sequence[FlippedQuery], name_of: Callable[[int], str]
) -> Grid:
    more = len(flipped) - MOST
    notes = [f"{more:,} more: --format json and --format csv have all"] if more > 0 else []
    notes.append("numbers of references; true: the nearest of those that are right")
    title = f"{len(flipped):,} {'query' if len(flipped) == 1 else 'queries'} that only {who} answers right"
    rows = [
        [_query(one.query, name_of), *_answer(one.first), *_answer(one.second), str(one.truth)]
        for one in flipped[:MOST]
    ]
    head = ["query", "A says", "score", "B says", "score", "true"]
    return Grid(_titled(comparison, title), head, rows, "\n".join(notes))


def _query(number: int, name_of: Callable[[int], str]) -> str:
    name = one_line(name_of(number))
    return name if str(number) in name.split() else f"{number}  {name}"


def _answer(best: Best) -> tuple[str, str]:
    return ("none", "") if best.reference is None else (str(best.reference), f"{best.score:.4g}")


def _titled(comparison: PairedComparison, title: str) -> str:
    return f"SIMULATED  {title}" if comparison.simulated else title


def _better(*, first: bool, second: bool) -> str:
    return "A" if first else "B" if second else "unclear"


def _signed(value: float) -> str:
    return UNDEFINED if math.isnan(value) else f"{value:+z.3f}"


def _p_value(value: float, equal: str = "") -> str:
    if math.isnan(value):
        return UNDEFINED
    return f"{equal}{value:.3f}" if value >= 0.001 else "< 0.001"
