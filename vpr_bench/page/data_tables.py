"""The numbers behind each chart, as tables: for who cannot see the chart, or wants to know exactly."""

from collections.abc import Mapping, Sequence

from vpr_bench.errors import one_line
from vpr_bench.leaderboard.standing import Board
from vpr_bench.page.curves import LEVELS
from vpr_bench.page.looks import displayed
from vpr_bench.page.radii import unit_in_words
from vpr_bench.page.scatter import Scatter
from vpr_bench.page.shown import Shown
from vpr_bench.report.foreign import shortened
from vpr_bench.report.grid import Grid
from vpr_bench.report.numbers import UNDEFINED, fine_bounds, milliseconds, share
from vpr_bench.types.protocol import Protocol


def curve_grid(methods: Sequence[Shown]) -> Grid:
    """Lay out the precision that each method has at some recalls."""
    head = ["method", *(f"recall ≥ {level:g}" for level in LEVELS)]
    rows = [[shortened(one.name), *map(share, one.curves.reached)] for one in methods]
    return Grid("Highest precision at which so much recall is reached", head, rows, f"{UNDEFINED}: never reached")


def radius_grid(methods: Sequence[Shown], protocol: Protocol) -> Grid:
    """Lay out recall@1 and pr_auc against the radius."""
    head = ["method", *(f"{one.radius:g}" for one in methods[0].curves.at)]
    rows = [
        [shortened(one.name), *(f"{share(at.recall_at_1)} · {share(at.pr_auc)}" for at in one.curves.at)]
        for one in methods
    ]
    return Grid(f"recall@1 · pr_auc at each radius ({unit_in_words(protocol) or 'no radius'})", head, rows)


def recalls_grid(methods: Sequence[Shown]) -> Grid:
    """Lay out recall@k."""
    deepest = max(len(one.curves.recalls) for one in methods)
    rows = [[shortened(one.name), *map(share, one.curves.recalls)] for one in methods]
    filled = [[*row, *[""] * (deepest + 1 - len(row))] for row in rows]
    return Grid("recall@k", ["method", *(str(k) for k in range(1, deepest + 1))], filled)


def latency_grid(scatters: Sequence[Scatter]) -> Grid:
    """Lay out recall@1 and latency, and who is on the front."""
    head = ["method", "machine", "ms p50", "recall@1", "95 %", "on the front"]
    rows = []
    for scatter in scatters:
        for standing in scatter.standings:
            entry, recall = standing.entry, standing.entry.metrics["recall@1"]
            time = milliseconds(entry.latency["latency_total_p50"])
            numbers = [time, share(recall.value), fine_bounds(recall.low, recall.high)]
            rows.append([shortened(entry.method), scatter.machine, *numbers, "yes" * (standing in scatter.front)])
    return Grid("recall@1 against median latency", head, rows)


def losses_grid(methods: Sequence[Shown]) -> Grid:
    """Lay out what each step lost, for the methods that noted it."""
    noted = [one for one in methods if one.curves.steps]
    steps = list(dict.fromkeys(step.name for one in noted for step in one.curves.steps))
    rows = []
    for one in noted:
        lost = {step.name: share(step.lost.value) for step in one.curves.steps}
        found = share(one.curves.steps[-1].recall.value)
        rows.append([shortened(one.name), found, *(lost.get(step, "") for step in steps)])
    head = ["method", "found (recall@1)", *(f"lost by {one_line(step)}" for step in steps)]
    return Grid("Share of the queries", head, rows)


def origin_grid(board: Board, machines: Mapping[str, str]) -> Grid:
    """Lay out how each row was measured, so that it can be repeated."""
    head = ["method", "run", "p of tie", "fit s", "peak MiB", "threads", "seed", "k", "weights", "vpr-bench", "made"]
    rows = []
    for standing in board.standings:
        entry = standing.entry
        p_value = UNDEFINED if standing.p_value is None else f"{standing.p_value:.3g}"
        memory = f"{max(entry.peak_memory.values()) / 2**20:,.0f}" if entry.peak_memory else ""
        numbers = [p_value, f"{entry.fit_seconds:.1f}", memory, str(entry.threads), str(entry.seed), str(entry.k)]
        name = f"{displayed(entry.method)} (version {one_line(entry.version)})"
        machine = machines[entry.machine]
        origin = [
            _weights(entry.weights),
            _source(entry.package, entry.commit, entry.changed),
            f"{entry.created[:10]} on {machine}",
        ]
        rows.append([name, entry.run, *numbers, *origin])
    note = "p of tie: McNemar's exact test against the best method, on the same queries"
    return Grid("Run, cost and origin of each row", head, rows, note)


def _weights(weights: str | None) -> str:
    """Name weights, with as much of their digest as tells them apart."""
    name, digest, rest = one_line(weights or "none").partition("sha256:")
    return f"{name}{digest}{rest[:12]}"


def _source(package: str, commit: str | None, changed: bool | None) -> str:
    state = "" if commit is None else f" ({one_line(commit)[:12]}{', changed since' * (changed is True)})"
    return one_line(package) + state
