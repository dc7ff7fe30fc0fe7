"""One protocol of the page: its table, its charts and its galleries, as far as they can be shown."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from vpr_bench.dataset.card import Card, find_card
from vpr_bench.errors import VprBenchError
from vpr_bench.leaderboard.entry import Entry
from vpr_bench.leaderboard.standing import Board
from vpr_bench.page.data_tables import (
    curve_grid,
    latency_grid,
    losses_grid,
    origin_grid,
    radius_grid,
    recalls_grid,
)
from vpr_bench.page.gallery import Galleries
from vpr_bench.page.looks import Look, displayed
from vpr_bench.page.radii import distance, unit_in_words
from vpr_bench.page.ranking import Ranking, ranking
from vpr_bench.page.scatter import scatters
from vpr_bench.page.shown import shown_methods
from vpr_bench.report.foreign import shortened
from vpr_bench.report.grid import Grid
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol

_UNMATCHED = {
    "exclude": "Queries whose place the map does not show are left out.",
    "miss": "Queries whose place the map does not show count as not found.",
    "reject": "Queries whose place the map does not show are to be rejected.",
}


@dataclass(frozen=True)
class Chart:
    """A chart and the numbers behind it.

    Attributes
    ----------
    id : str
        By which the page's script knows it.
    title, about : str
        What it shows, and how to read it.
    numbers : Grid
        The same as a table.
    """

    id: str
    title: str
    about: str
    numbers: Grid


@dataclass(frozen=True)
class Section:
    """Everything about one protocol.

    Attributes
    ----------
    protocol : Protocol
        Its id heads the section.
    simulated : bool
        Whether it is about simulated images.
    dataset : str
        Name of the dataset.
    facts : list of str
        What was asked, in sentences.
    ranking : Ranking
        The table.
    charts : list of Chart
        Those for which there is something to draw.
    missing : str
        Which methods have no curves and pictures, and why; may be empty.
    origin : Grid
        How each row was measured.
    credit : list of str
        Licence and citation of the pictures; empty where the dataset is not known.
    data : dict
        For the page's script.
    """

    protocol: Protocol
    simulated: bool
    dataset: str
    facts: list[str]
    ranking: Ranking
    charts: list[Chart]
    missing: str
    origin: Grid
    credit: list[str]
    data: dict[str, Any]


def section(
    board: Board,
    runs: Mapping[str, StoredRun],
    machines: Mapping[str, str],
    looks: Mapping[str, Look],
    galleries: Galleries,
) -> Section:
    """Gather everything about one protocol.

    Parameters
    ----------
    board : Board
        Its rows.
    runs : mapping of StoredRun
        By their 12 digits; of other rows there are no curves and no pictures.
    machines, looks : mappings
        Fingerprint to letter, method to look.
    galleries : Galleries
        Find the pictures.

    Raises
    ------
    DataError
        If a run is damaged.
    """
    methods, plots, protocol = shown_methods(board, runs), scatters(board, machines), board.protocol
    charts: list[Chart] = []
    if methods:
        several = len(methods[0].curves.at) > 1
        charts.append(Chart("curves", "Precision and recall", _CURVES, curve_grid(methods)))
        charts += [Chart("radius", "By radius", _RADIUS, radius_grid(methods, protocol))] if several else []
        charts.append(Chart("recalls", "Among the first k", _RECALLS, recalls_grid(methods)))
    if plots:
        charts.append(Chart("latency", "Accuracy and time", _LATENCY, latency_grid(plots)))
    if any(one.curves.steps for one in methods):
        charts.append(Chart("losses", "Where the right place was lost", _LOSSES, losses_grid(methods)))
    card = _card(protocol.dataset)
    data = {
        "radius": protocol.radius,
        "unit": unit_in_words(protocol),
        "looks": {name: asdict(looks[name]) for name in (displayed(one.entry.method) for one in board.standings)},
        "methods": [
            {"method": displayed(one.entry.method), "name": one.name, "gallery": galleries.gallery(one.run, protocol)}
            | one.curves.as_dict()
            for one in methods
        ],
        "scatters": [one.as_dict() for one in plots],
        "pictures": any(galleries.has_images(one.run) for one in methods),
    }
    return Section(
        protocol=protocol,
        simulated=board.simulated,
        dataset=card.name if card else protocol.dataset,
        facts=_facts(board),
        ranking=ranking(board, machines),
        charts=charts,
        missing=_missing(board, [one.entry for one in methods]),
        origin=origin_grid(board, machines),
        credit=_credit(card, board.simulated),
        data=data,
    )


_CURVES = (
    "The threshold on the score falls along each curve. A query answered wrongly costs recall, so that a curve ends "
    "at recall@1; pr_auc is the area below it."
)
_RADIUS = "How much depends on how far apart two images may be and still show the same place."
_RECALLS = "Share of the queries with a right place among the first k answers."
_LATENCY = (
    "Up and to the left is better; the line joins the methods that no other one beats in both. Bars are 95 % bootstrap "
    "intervals. Only times measured while the machine did little else."
)
_LOSSES = "All queries that count, divided into those answered rightly and what each step of answering lost."


def _facts(board: Board) -> list[str]:
    protocol, entry = board.protocol, max((one.entry for one in board.standings), key=lambda one: one.n_queries)
    told = protocol.unmatched != "exclude" or entry.n_counted != entry.n_queries
    counted = "" if entry.n_counted == entry.n_queries else f", of which {entry.n_counted:,} count"
    reach = {
        "pair": "The dataset says by pairs which images show the same place.",
        "given": "A file of the dataset says which images show the same place.",
        "nearest": f"The {protocol.radius:g} nearest references show the place of a query.",
    }.get(protocol.unit, f"Two images at most {distance(protocol.radius, protocol)} apart show the same place.")
    return [
        f"Map: {entry.n_references:,} references of {protocol.references}.",
        f"Asked: {entry.n_available:,} queries of {protocol.queries}{counted}.",
        reach,
        *([_UNMATCHED[protocol.unmatched]] if told else []),
    ]


def _missing(board: Board, shown: list[Entry]) -> str:
    rest = dict.fromkeys(one.entry.method for one in board.standings if not one.entry.partial)
    absent = [method for method in rest if method not in {entry.method for entry in shown}]
    if not absent:
        return ""
    what = (
        "None of the runs is here"
        if len(absent) == len(rest)
        else f"Not here: the runs of {', '.join(map(shortened, absent))}"
    )
    return f"{what}, so that there are no curves and pictures of them."


def _credit(card: Card | None, simulated: bool) -> list[str]:
    if simulated:
        return ["Rendered by vpr-bench: these are not photographs."]
    return [f"Images: {card.name}. {card.citation.rstrip('.')}.", f"Licence: {card.licence}."] if card else []


def _card(dataset: str) -> Card | None:
    """Return a dataset's card; a leaderboard may outlive the plug-in."""
    try:
        return find_card(dataset)
    except VprBenchError:
        return None
