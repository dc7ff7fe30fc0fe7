"""Rows as a table for people, or as JSON or CSV for programs."""

import csv
import io
import json
import math
from collections.abc import Iterable, Sequence

from rich.box import SIMPLE_HEAD
from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from vpr_bench.dataset.card import Card, Published
from vpr_bench.report.foreign import guarded_cells
from vpr_bench.report.losses import losses_line
from vpr_bench.report.numbers import bounds, milliseconds, share
from vpr_bench.report.published import published_for, with_sources
from vpr_bench.report.rows import Row
from vpr_bench.report.unbroken import Unbroken

_BESIDE_TIMES, _WITHOUT_TIMES = 4, 6  # metrics per table, so that it fits a window of 80 columns
_STAGES = ("encode", "match", "rerank", "total")


def render_tables(rows: Sequence[Row], cards: dict[str, Card]) -> RenderableType:
    """Lay rows out as one table per protocol, images and number of queries: only such numbers are ever ranked.

    Published numbers for the same pairing stand below the measured ones, grey, on the real edition only.

    Parameters
    ----------
    rows : sequence of Row
        With the same metrics.
    cards : dict
        Dataset id to card, for published numbers; datasets without one show none.
    """
    tables: list[RenderableType] = []
    for alike in dict.fromkeys(map(_comparable, rows)):
        same = [row for row in rows if _comparable(row) == alike]
        protocol = same[0].protocol
        card = cards.get(protocol.dataset)
        published = published_for(card, protocol) if card and not same[0].partial else []
        metrics = list(same[0].metrics)
        head, rest = metrics[:_BESIDE_TIMES], metrics[_BESIDE_TIMES:]
        tables.append(_table(same, head, _stages(same), published))
        parts = range(0, len(rest), _WITHOUT_TIMES)
        tables += [_table(same, rest[part : part + _WITHOUT_TIMES], [], published) for part in parts]
    return Group(*tables)


def _stages(rows: Sequence[Row]) -> list[str]:
    return [stage for stage in _STAGES if any(f"latency_{stage}_p50" in row.latency for row in rows)]


def _table(
    rows: Sequence[Row], metrics: Sequence[str], stages: Sequence[str], published: Sequence[Published]
) -> RenderableType:
    """Lay out one protocol, each row on two lines, so that it fits a narrow window."""
    records = [row.run.record for row in rows]
    size = f"{records[0].n_references} references, {records[0].n_queries} queries"
    title = Text(f"{rows[0].protocol}  {size}{' (partial)' if rows[0].partial else ''}")
    table = Table(
        title=title,
        title_justify="left",
        title_style="bold",
        box=SIMPLE_HEAD,
        show_edge=False,
        padding=(0, 1, 0, 0),
        pad_edge=False,
    )
    table.add_column("method\nrun", overflow="fold", min_width=10)
    heads = [*map(_broken, metrics), *(f"{stage}\nms" for stage in stages)]
    for head in heads:
        table.add_column(head, justify="right", no_wrap=True)
    cells = [
        [*(_value(row, metric) for metric in metrics), *(_percentiles(row, stage) for stage in stages)] for row in rows
    ]
    for row, values in zip(rows, cells, strict=True):
        table.add_row(_name(row), *values)
    shown, sources = with_sources(published, metrics, rows[0].protocol)
    if shown:
        table.add_section()
        table.add_row("published:", style="dim")
    for one, number in shown:
        values = [f"{one.value:.3f}" if metric == one.metric else "" for metric in metrics]
        table.add_row(Text(f"{one.method} [{number}]"), *values, style="dim")
    threads = " or ".join(sorted({str(record.key.threads) for record in records}))
    notes = []
    if stages:
        notes.append(f"ms: p50 over p95 per query, one at a time, threads: {threads}, image already decoded")
    if any(math.isnan(row.metrics[metric]) for row in rows for metric in metrics):
        notes.append("–: undefined here, or needs more answers per query than were kept (--k)")
    if any(row.intervals for row in rows):
        notes.append("below a value: its 95 % bootstrap interval over queries")
    notes += [losses_line(row) for row in rows if stages and row.steps]
    notes += [f"[{number}] {source}" for number, source in enumerate(sources, 1)]
    # Not the table's caption, which would be as narrow as the table.
    return Group(Unbroken.of(table, zip(heads, *cells, strict=True)), Text("\n".join([*notes, ""]), style="italic dim"))


def _comparable(row: Row) -> tuple[str, str, int]:
    """Return what rows of one table share: the protocol, the images, and how many queries were asked."""
    record = row.run.record
    return str(row.protocol), record.key.dataset_digest, record.n_queries


def _name(row: Row) -> Text:
    return Text.assemble(row.method + (" (partial)" if row.partial else ""), "\n", (row.run.folder.name[:6], "dim"))


def _broken(metric: str) -> str:
    """Break a metric's id into two lines where that makes its column narrower."""
    for mark in ("@", "_"):
        head, found, tail = metric.rpartition(mark)
        if found and len(metric) > len("pr_auc"):
            return f"{head}\n{found}{tail}"
    return metric


def _value(row: Row, metric: str) -> str:
    interval = bounds(*row.intervals[metric]) if metric in row.intervals else ""
    return f"{share(row.metrics[metric])}\n{interval}".rstrip()


def _percentiles(row: Row, stage: str) -> str:
    name = f"latency_{stage}_p"
    if f"{name}50" not in row.latency:
        return ""
    return "\n".join(milliseconds(row.latency[f"{name}{percentile}"]) for percentile in (50, 95))


def to_json(rows: Iterable[Row]) -> str:
    """Write rows as a JSON array of objects; undefined numbers are null."""
    return json.dumps([row.as_dict() for row in rows], indent=2, ensure_ascii=False)


def to_csv(rows: Sequence[Row]) -> str:
    """Write rows as CSV with one column per number; undefined ones are empty, and no text begins a formula."""
    flat = [guarded_cells(row.flat()) for row in rows]
    columns = list(dict.fromkeys(name for line in flat for name in line))
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, lineterminator="\n")
    writer.writeheader()
    writer.writerows(flat)
    return text.getvalue().rstrip("\n")
