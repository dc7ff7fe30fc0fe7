"""The ranked table of a protocol, cell by cell as the page shows it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from vpr_bench.dataset.card import Published
from vpr_bench.errors import one_line
from vpr_bench.leaderboard.standing import Board, Standing
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.metrics.definitions import lookup
from vpr_bench.page.looks import displayed
from vpr_bench.report.numbers import UNDEFINED, fine_bounds, milliseconds, share
from vpr_bench.report.published import with_sources

METRICS = ("recall@1", "recall@5", "recall@10", "pr_auc", "pr_auc_matched")
"""The metrics of the table, in the order of its columns."""

COLUMNS = (
    ("rank", "by recall@1; where that is equal, by pr_auc"),
    ("method", "its id, with the parameters that differ from their defaults"),
    *((metric, lookup(metric).definition) for metric in METRICS),
    ("ms p50", "median time for one query, the image already decoded"),
    ("ms p95", "time that 95 % of the queries stay below"),
    ("machine", "what it was measured on; only times of one machine can be compared"),
)
"""Name and meaning of each column."""


@dataclass(frozen=True)
class Cell:
    """One cell.

    Attributes
    ----------
    text : str
        The value, empty where there is none.
    order : str
        What it is sorted by: a number, or nothing where there is none.
    interval : Interval or None
        Of the value, where there is one.
    """

    text: str = ""
    order: str = ""
    interval: Interval | None = None

    @property
    def between(self) -> str:
        """The interval in words."""
        return fine_bounds(self.interval.low, self.interval.high) if self.interval else ""


@dataclass(frozen=True)
class Line:
    """One row of the table.

    Attributes
    ----------
    kind : {"ranked", "unranked", "published"}
        They are kept apart however the table is sorted.
    rank : str
        Empty for what is not ranked.
    tied : bool
        Not significantly different from the best, and not the best itself.
    method : str
        On one line.
    marks : sequence of str
        What has to be known about it: that it is partial, or uses more than one frame.
    cells : sequence of Cell
        One per metric, two of latency.
    machine : str
        Its letter.
    frames : {"one", "several"}
        Whether it uses other frames than the one that is asked.
    source : int or None
        Number of the source that published it.
    """

    kind: str
    rank: str
    tied: bool
    method: str
    marks: Sequence[str]
    cells: Sequence[Cell]
    machine: str = ""
    frames: str = ""
    source: int | None = None


@dataclass(frozen=True)
class Ranking:
    """The table, and where its published rows come from."""

    lines: list[Line]
    sources: list[str] = field(default_factory=list)

    @property
    def machines(self) -> list[str]:
        """Letters of the machines in it."""
        return sorted({line.machine for line in self.lines if line.machine}, key=lambda one: (len(one), one))

    @property
    def has_blank_times(self) -> bool:
        """Whether a time is left out of a row that has metrics."""
        return any(line.kind == "ranked" and not line.cells[-1].text for line in self.lines)

    @property
    def has_both(self) -> bool:
        """Whether there are methods that use one frame, and others that use several."""
        return {"one", "several"} <= {line.frames for line in self.lines}


def ranking(board: Board, machines: Mapping[str, str]) -> Ranking:
    """Lay out a board.

    Parameters
    ----------
    board : Board
    machines : mapping of str
        Fingerprint to letter.
    """
    lines = [_line(one, machines[one.entry.machine]) for one in board.standings]
    published, sources = with_sources(board.published, METRICS, board.protocol)
    return Ranking([*lines, *(_published(one, source) for one, source in published)], sources)


def _line(standing: Standing, machine: str) -> Line:
    entry = standing.entry
    shown = {} if entry.partial else entry.metrics
    times = entry.latency if standing.fair_latency and not entry.partial else {}
    cells = [_metric(shown.get(name)) for name in METRICS]
    cells += [_time(times.get(f"latency_total_{part}")) for part in ("p50", "p95")]
    return Line(
        kind="unranked" if standing.rank is None else "ranked",
        rank="" if standing.rank is None else str(standing.rank),
        tied=standing.tied and standing.p_value is not None,
        method=displayed(entry.method),
        marks=_marks(standing),
        cells=cells,
        machine=machine,
        frames="several" if entry.sequential or entry.future else "one",
    )


def _marks(standing: Standing) -> list[str]:
    entry, marks = standing.entry, []
    if entry.partial:
        marks.append(f"partial: {entry.n_queries:,} of {entry.n_available:,} queries")
    if entry.sequential:
        marks.append("sequence")
    if entry.future:
        marks.append(f"{entry.future} frame{'s' * (entry.future != 1)} ahead")
    return marks


def _metric(interval: Interval | None) -> Cell:
    if interval is None:
        return Cell()
    if math.isnan(interval.value):
        return Cell(UNDEFINED)
    known = not math.isnan(interval.low) and not math.isnan(interval.high)
    return Cell(share(interval.value), repr(interval.value), interval if known else None)


def _time(value: float | None) -> Cell:
    return Cell() if value is None or math.isnan(value) else Cell(milliseconds(value), repr(value))


def _published(one: Published, source: int) -> Line:
    cells = [Cell(f"{one.value:.3f}", repr(one.value)) if name == one.metric else Cell() for name in METRICS]
    return Line("published", "", False, one_line(one.method), ["published"], [*cells, Cell(), Cell()], source=source)
