"""Rows as a table for people, or as JSON or CSV for programs."""

import csv
import io
import json
import math
from collections.abc import Iterable, Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from vpr_bench.dataset.card import Card, Published
from vpr_bench.report.rows import Row
from vpr_bench.types.protocol import Protocol

_STAGES = ("encode", "match", "rerank", "total")


def render_tables(rows: Sequence[Row], cards: dict[str, Card]) -> RenderableType:
    """Lay rows out as one table per protocol, because numbers of different protocols are never ranked together.

    Published numbers for the same pairing stand below the measured ones, grey, on the real edition only.

    Parameters
    ----------
    rows : sequence of Row
        With the same metrics.
    cards : dict
        Dataset id to card, for published numbers; datasets without one show none.
    """
    tables: list[RenderableType] = []
    for protocol in dict.fromkeys(row.protocol for row in rows):
        same = [row for row in rows if row.protocol == protocol]
        card = cards.get(protocol.dataset)
        tables.append(_table(protocol, same, published_for(card, protocol) if card else []))
    return Group(*tables)


def published_for(card: Card, protocol: Protocol) -> list[Published]:
    """Return the published numbers of a protocol: same pairing, and the same radius where one is stated."""
    if protocol.edition != "real":
        return []
    return [
        one
        for one in card.published
        if f"{one.references}-{one.queries}" == protocol.pairing and one.radius in (None, protocol.radius)
    ]


def _table(protocol: Protocol, rows: Sequence[Row], published: Sequence[Published]) -> Table:
    metrics = list(rows[0].metrics)
    stages = [stage for stage in _STAGES if any(f"latency_{stage}_p50" in row.latency for row in rows)]
    record = rows[0].run.record
    title = f"{protocol}   {record.n_references} references, {record.n_queries} queries"
    table = Table(title=Text(title), title_justify="left", title_style="bold", caption_justify="left")
    table.add_column("method", overflow="fold")
    for metric in metrics:
        table.add_column(metric, justify="right")
    for stage in stages:
        table.add_column(f"{stage} ms", justify="right")
    for row in rows:
        values = [_value(row, metric) for metric in metrics]
        times = [_percentiles(row, stage) for stage in stages]
        table.add_row(Text(row.method + (" (partial)" if row.partial else "")), *values, *times)
    sources = list(dict.fromkeys(_source(one) for one in published if one.metric in metrics))
    if sources:
        table.add_section()
    for one in published:
        if one.metric in metrics:
            mark = f" [{sources.index(_source(one)) + 1}]"
            values = [f"{one.value:.3f}" if metric == one.metric else "" for metric in metrics]
            table.add_row(Text("published: " + one.method + mark), *values, *[""] * len(stages), style="dim")
    threads = ", ".join(sorted({str(row.run.record.key.threads) for row in rows}))
    notes = [f"ms: p50 / p95 per query, one at a time, {threads} threads, image already decoded"]
    notes += [f"[{number}] {source}" for number, source in enumerate(sources, 1)]
    table.caption = Text("\n".join(notes))
    return table


def _value(row: Row, metric: str) -> str:
    value = row.metrics[metric]
    if math.isnan(value):
        return "–"
    if metric not in row.intervals:
        return f"{value:.3f}"
    low, high = row.intervals[metric]
    return f"{value:.3f}\n{low:.3f}–{high:.3f}"


def _percentiles(row: Row, stage: str) -> str:
    name = f"latency_{stage}_p"
    if name + "50" not in row.latency:
        return ""
    return f"{row.latency[name + '50']:.1f} / {row.latency[name + '95']:.1f}"


def _source(one: Published) -> str:
    radius = "radius not stated" if one.radius is None else f"radius {one.radius:g}"
    return f"{one.source}, {radius}"


def to_json(rows: Iterable[Row]) -> str:
    """Write rows as a JSON array of objects; undefined numbers are null."""
    return json.dumps([row.as_dict() for row in rows], indent=2, ensure_ascii=False)


def to_csv(rows: Sequence[Row]) -> str:
    """Write rows as CSV with one column per number; undefined ones are empty."""
    flat = []
    for row in rows:
        content = row.as_dict()
        metrics, intervals, times = content.pop("metrics"), content.pop("intervals"), content.pop("latency_ms")
        memory = content.pop("peak_memory_bytes")
        bounds = {f"{name}_low": low for name, (low, _) in intervals.items()}
        bounds |= {f"{name}_high": high for name, (_, high) in intervals.items()}
        peaks = {f"peak_memory_{phase}_bytes": size for phase, size in memory.items()}
        flat.append({**content, **metrics, **bounds, **times, **peaks})
    columns = list(dict.fromkeys(name for line in flat for name in line))
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, lineterminator="\n")
    writer.writeheader()
    writer.writerows(flat)
    return text.getvalue().rstrip("\n")
