"""Methods that were timed side by side, as a table."""

from vpr_bench.bench.comparison import BEFORE_RERANK, RERANK, Comparison, VariantTimes
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.metrics.latency import TOTAL
from vpr_bench.report.grid import Grid
from vpr_bench.report.numbers import milliseconds, share

_STAGES = ("encode", "match", RERANK, TOTAL)


def comparison_grid(comparison: Comparison) -> Grid:
    """Lay a comparison out, one variant per row: milliseconds of each stage, then ratios to the first row."""
    variants, first = comparison.variants, comparison.variants[0]
    noted = {stage for one in variants for stage in one.seconds}
    stages = [stage for stage in _STAGES if stage in noted]
    compared = {TOTAL: "ratio"} | ({BEFORE_RERANK: "before\nrerank"} if RERANK in noted else {})
    rows = []
    for one in variants:
        times, ratios = one.latency(), one.ratios(first)
        cells = [_percentiles(times, stage) for stage in stages]
        cells += [_ratio(ratios.get(name), one, first) for name in compared]
        rows.append([one.variant.name, *cells])
    machine = comparison.machine
    size = f"{comparison.n_images} images × {comparison.rounds} rounds, {comparison.n_references} references"
    note = (
        f"ms: p50 over p95, image already decoded, threads: {machine.threads}, {machine.processor}\n"
        "ratio: to the first line, median over images, above its 95 % bootstrap interval"
    )
    head = ["variant", *(f"{stage}\nms" for stage in stages), *compared.values()]
    return Grid(f"{comparison.protocol}  {size}", head, rows, note)


def _percentiles(times: dict[str, float], stage: str) -> str:
    name = f"latency_{stage}_p"
    if f"{name}50" not in times:
        return ""
    return "\n".join(milliseconds(times[f"{name}{percentile}"]) for percentile in (50, 95))


def _ratio(ratio: Interval | None, one: VariantTimes, first: VariantTimes) -> str:
    if one is first:
        return "1"
    return "" if ratio is None else f"{share(ratio.value)}\n{share(ratio.low)}–{share(ratio.high)}"
