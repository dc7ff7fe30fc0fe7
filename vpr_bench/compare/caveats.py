"""What to keep in mind while reading a comparison."""

import math

from vpr_bench.compare.paired import PairedComparison

DRIFT = (
    "the two runs were timed at different moments, and the interval does not hold what the machine did in between: "
    "`vpr-bench bench methods` times methods side by side"
)

_IDENTICAL = "identical: both gave every query the same answers, with the same scores"
_UNADJUSTED = (
    "each metric for itself: intervals and p-values are not adjusted for there being several, and of twenty metrics "
    "without a difference one will seem to have one"
)
_EXTREME = "recall@100p"  # the first wrong answer decides: resampling cannot tell how it would move


def caveats(comparison: PairedComparison) -> list[str]:
    """Say what limits the numbers about right and wrong, or that nothing differs, each in one line.

    Parameters
    ----------
    comparison : PairedComparison
        Of two runs.
    """
    runs = {"A": comparison.first, "B": comparison.second}
    found = [_IDENTICAL] if comparison.identical else []
    if len(comparison.metrics) > 1:
        found.append(_UNADJUSTED)
    if any(math.isnan(one.difference.value) for one in comparison.metrics):
        found.append("–: undefined here, or needs more answers per query than were kept (--k)")
    if comparison.first.record.partial:
        found.append(f"partial: only {comparison.n_queries:,} queries were asked (--limit)")
    if sequential := [name for name, run in runs.items() if run.record.order == "sequential"]:
        found.append(
            f"{' and '.join(sequential)} answered with the help of neighbouring frames: such answers go wrong "
            "together, and the intervals are too narrow"
        )
    if any(one.metric == _EXTREME for one in comparison.metrics):
        found.append(f"{_EXTREME} hangs on single queries: do not trust its interval")
    return found


def time_caveats(comparison: PairedComparison) -> list[str]:
    """Say why times cannot be compared, or what limits their comparison, each in one line.

    Parameters
    ----------
    comparison : PairedComparison
        Of two runs.
    """
    speed = comparison.speed
    if speed.refused:
        return [f"times are not compared: {speed.refused}"]
    return [DRIFT, *(f"careful: {doubt}" for doubt in speed.doubts)]
