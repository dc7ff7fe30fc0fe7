"""Scoring stored runs as the options say, and printing the rows."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from vpr_bench.cli.console import show, write
from vpr_bench.cli.options import Format
from vpr_bench.errors import VprBenchError

if TYPE_CHECKING:
    from vpr_bench.dataset.card import Card
    from vpr_bench.report.rows import Row
    from vpr_bench.runner.store import StoredRun
    from vpr_bench.types.protocol import Protocol, Unmatched


@dataclass(frozen=True)
class Scoring:
    """How runs are scored: which metrics, at which radii, with how many resamples.

    Attributes
    ----------
    metrics : list of str
        Metric ids.
    radii : list of float or None
        None for the protocol's own.
    unmatched : {"exclude", "miss", "reject"} or None
        None for the protocol's own.
    resamples : int
        Of the bootstrap; 0 for no intervals.
    """

    metrics: list[str]
    radii: list[float] | None
    unmatched: "Unmatched | None"
    resamples: int

    def rows(self, run: "StoredRun", protocol: "Protocol | None" = None) -> list["Row"]:
        """Score one run at every radius.

        Parameters
        ----------
        run : StoredRun
            A complete run.
        protocol : Protocol, optional
            Instead of the one that the run was stored with.
        """
        from vpr_bench.report.rows import score_run

        protocol = protocol or run.protocol
        protocol = replace(protocol, unmatched=self.unmatched or protocol.unmatched)
        protocols = [protocol.with_radius(radius) for radius in self.radii] if self.radii else [protocol]
        return [score_run(run, self.metrics, one, self.resamples) for one in protocols]


def check_metrics(names: list[str] | None, default: Sequence[str]) -> list[str]:
    """Return the metrics that were asked for, or the default ones.

    Raises
    ------
    UsageError
        If there is no metric of that name.
    """
    from vpr_bench.metrics.definitions import lookup

    return [lookup(name).id for name in names or default]


def print_rows(rows: Sequence["Row"], form: Format) -> None:
    """Print scored runs on stdout."""
    from vpr_bench.report.markdown import to_markdown
    from vpr_bench.report.table import render_tables

    if form in ("json", "csv"):
        _write_rows(rows, form)
    elif form == "markdown" and rows:
        write(to_markdown(rows))
    elif rows:
        show(render_tables(rows, _cards(rows)))


def print_sweep(rows: Sequence["Row"], form: Format) -> None:
    """Print runs that were scored at several radii on stdout."""
    from vpr_bench.report.sweep import sweep_grids

    if form in ("json", "csv"):
        _write_rows(rows, form)
    elif form == "markdown":
        write("\n\n".join(grid.markdown() for grid in sweep_grids(rows)))
    else:
        for grid in sweep_grids(rows):
            show(grid.rich())


def _write_rows(rows: Sequence["Row"], form: Format) -> None:
    from vpr_bench.report.table import to_csv, to_json

    write(to_json(rows) if form == "json" else to_csv(rows))


def _cards(rows: Sequence["Row"]) -> dict[str, "Card"]:
    """Find the cards of the rows' datasets; a stored run may outlive its dataset's plug-in."""
    from vpr_bench.dataset.card import find_card

    cards = {}
    for dataset in {row.protocol.dataset for row in rows}:
        try:
            cards[dataset] = find_card(dataset)
        except VprBenchError:
            continue
    return cards
