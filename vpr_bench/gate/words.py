"""A verdict in words: the cells of tables, and the lines below them."""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from vpr_bench.errors import one_line
from vpr_bench.gate.metric_change import MetricChange
from vpr_bench.gate.verdict import Changed, Judgement, Verdict
from vpr_bench.report.numbers import UNDEFINED, share

T = TypeVar("T")

SHOWN = 20
"""How many queries are listed; all of them are in the JSON."""

HEAD = ("method", "verdict", "metric", "baseline", "now", "change", "allowed", "flips")
UNREADABLE = "runs that cannot be read"


def by_protocol(judgement: Judgement) -> dict[str, list[Verdict]]:
    """Return the verdicts of each protocol; only those stand in one table."""
    found: dict[str, list[Verdict]] = {}
    for verdict in judgement.verdicts:
        found.setdefault(one_line(verdict.protocol) or UNREADABLE, []).append(verdict)
    return found


def table_rows(verdict: Verdict) -> list[Sequence[str]]:
    """Return one row per metric, what is of the whole cell in the first one only."""
    rows = [_metric_cells(change) for change in verdict.metrics] or [[""] * 5]
    flips = f"-{len(verdict.lost)} +{len(verdict.gained)}" if verdict.lost or verdict.gained else ""
    first, *others = rows
    return [[one_line(verdict.label), verdict.outcome, *first, flips], *(["", "", *row, ""] for row in others)]


def reasons(verdict: Verdict) -> list[str]:
    """Return why a cell did not pass, and what else is to be said of it, a line each."""
    return [one_line(reason) for reason in verdict.reasons] + [one_line(f"note: {note}") for note in verdict.notes]


def details(judgement: Judgement, protocol: str) -> list[Verdict]:
    """Return the verdicts of a protocol of which there is more to say than stands in its table."""
    verdicts = by_protocol(judgement)[protocol]
    return [one for one in verdicts if one.outcome != "new" and (reasons(one) or any(moved(one)))]


def legend(judgement: Judgement) -> list[str]:
    """Say how to read what the tables say is allowed; nothing where they say nothing."""
    if not any(verdict.metrics for verdict in judgement.verdicts):
        return []
    return ["allowed: -0.02, no larger fall; p > 0.05, no fall that chance alone would make less often than that"]


def skipped(judgement: Judgement) -> list[str]:
    """Name the runs that nothing is judged by, on one line; no line where there are none."""
    if not judgement.skipped:
        return []
    return [f"skipped, as only some queries were asked (--limit): {listed(judgement.skipped, one_line)}"]


def advice(judgement: Judgement) -> list[str]:
    """Say what can be done about what was found, a line each."""
    told = []
    if any(verdict.improved for verdict in judgement.verdicts):
        told.append("Some became better: --update makes that the baseline.")
    if judgement.count("new"):
        told.append("The baseline does not hold what is new: --update records it.")
    return told


def moved(verdict: Verdict) -> Iterator[tuple[str, str]]:
    """Yield each list of queries that moved: what they are, and which, the first few."""
    changed = {one.query: one for one in verdict.changed}
    for title, queries in (("lost", verdict.lost), ("gained", verdict.gained)):
        if queries:
            yield title, listed(queries, lambda query: f"{query} ({_name(verdict, query, changed.get(query))})")
    flipped = {*verdict.lost, *verdict.gained}
    other = [one for one in verdict.changed if one.query not in flipped]
    if other:
        yield "answered otherwise", listed(other, lambda one: f"{one.query} ({_change(one)})")


def listed(items: Sequence[T], write: Callable[[T], str] = str) -> str:
    """Write the first items of a list, and how many more there are.

    Examples
    --------
    >>> listed(range(22))[-17:]
    '18, 19 and 2 more'
    """
    more = f" and {len(items) - SHOWN} more" if len(items) > SHOWN else ""
    return ", ".join(map(write, items[:SHOWN])) + more


def failure(verdict: Verdict) -> str:
    """Say everything about one verdict, as the message of a test that fails."""
    lines = [f"{one_line(verdict.label)} on {one_line(verdict.protocol)}: {verdict.outcome}"]
    lines += [f"  {line}" for line in reasons(verdict)]
    for change in verdict.metrics:
        lines.append(f"  {change.metric}: {share(change.before)} → {share(change.after)}, allowed {allowed(change)}")
    lines += [f"  {title}: {queries}" for title, queries in moved(verdict)]
    return "\n".join(lines)


def allowed(change: MetricChange) -> str:
    """Write what a metric's rule allows."""
    rule = change.rule
    parts = [f"-{rule.tolerance:g}"] if rule.tolerance is not None else []
    parts += [f"p > {rule.significance:g}"] if rule.significance else []
    return ", ".join(parts) or "anything"


def _metric_cells(change: MetricChange) -> list[str]:
    if math.isnan(change.difference):
        difference = UNDEFINED
    else:
        difference = f"{change.difference:+.3f}" if change.difference else "="
    return [change.metric, share(change.before), share(change.after), difference, allowed(change)]


def _name(verdict: Verdict, query: int, change: Changed | None) -> str:
    parts = [one_line(verdict.names[query])] if query in verdict.names else []
    parts += [_change(change)] if change else []
    return ": ".join(parts) or "same answer"


def _change(one: Changed) -> str:
    return f"{_reference(one.before)} → {_reference(one.after)}"


def _reference(reference: int) -> str:
    return "none" if reference < 0 else str(reference)
