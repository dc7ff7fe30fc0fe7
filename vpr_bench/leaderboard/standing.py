"""Who stands where: the rows of one protocol, ranked by recall@1, with what may be chance marked as such."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from vpr_bench.dataset.card import Published, find_card
from vpr_bench.errors import DataError, VprBenchError, one_line
from vpr_bench.leaderboard.entry import Entry, moment
from vpr_bench.metrics.mcnemar import mcnemar
from vpr_bench.report.foreign import shortened
from vpr_bench.report.published import published_for
from vpr_bench.runner.fair_times import doubt
from vpr_bench.types.protocol import Protocol

SIGNIFICANCE = 0.05
"""A difference from the best with a smaller p-value is taken for real."""

_AGREE = "Run all its methods on the same images, or delete the rows of the others from results.csv."


@dataclass(frozen=True)
class Standing:
    """A row and its place on its board.

    Attributes
    ----------
    entry : Entry
        The row.
    rank : int or None
        1 is the best recall@1; where that is equal, pr_auc decides, and where both are, rows share a rank. A method
        measured on several machines takes one rank, that of its newest row. None for partial rows, and where recall
        is undefined.
    tied : bool
        Not significantly different from the best one, by McNemar's exact test on the same queries. True for the best
        one itself.
    p_value : float or None
        Of that test; None for the best one and for what has no rank.
    fair_latency : bool
        Its latency was measured, while the machine did little else.
    """

    entry: Entry
    rank: int | None
    tied: bool
    p_value: float | None
    fair_latency: bool


@dataclass(frozen=True)
class Board:
    """All rows of one protocol.

    Attributes
    ----------
    protocol : Protocol
        Of all of them.
    standings : list of Standing
        Best first, those without a rank last.
    published : list of Published
        What others published, for comparison by eye; never ranked. None on other editions than the real one.
    """

    protocol: Protocol
    standings: list[Standing]
    published: list[Published]

    @property
    def simulated(self) -> bool:
        """Whether the images are simulated."""
        return self.protocol.simulated


def boards(entries: Sequence[Entry]) -> list[Board]:
    """Rank the rows of each protocol; real editions come first, simulated ones after them, each by id.

    Raises
    ------
    DataError
        If rows of one protocol were measured on other images or other queries.
    """
    ordered = sorted(entries, key=lambda one: (one.protocol.simulated, str(one.protocol)))
    return [_board(protocol, list(same)) for protocol, same in groupby(ordered, key=lambda one: one.protocol)]


def pareto(board: Board, machine: str) -> list[Standing]:
    """Return the rows of one machine that no other of its rows beats in both recall@1 and median latency.

    Parameters
    ----------
    board : Board
        Only rows with a rank and a fair latency are looked at.
    machine : str
        Fingerprint.

    Returns
    -------
    list of Standing
        The fastest first.
    """
    rivals = [one for one in board.standings if one.rank and one.fair_latency and one.entry.machine == machine]
    front: list[Standing] = []
    for one in sorted(rivals, key=lambda one: (one.entry.latency["latency_total_p50"], -_recall(one.entry))):
        if not front or _recall(one.entry) > _recall(front[-1].entry):
            front.append(one)
    return front


def _board(protocol: Protocol, entries: list[Entry]) -> Board:
    _check_comparable(protocol, entries)
    rest = sorted((one for one in entries if not _is_ranked(one)), key=lambda one: one.cell)
    unranked = [Standing(one, None, False, None, _is_fair(one)) for one in rest]
    return Board(protocol, _ranked([one for one in entries if _is_ranked(one)]) + unranked, _published(protocol))


def _ranked(entries: list[Entry]) -> list[Standing]:
    by_method: dict[str, list[Entry]] = {}
    for one in sorted(entries, key=lambda one: (moment(one.created), one.run, one.machine), reverse=True):
        by_method.setdefault(one.method, []).append(one)
    newest = sorted((rows[0] for rows in by_method.values()), key=_merit)
    standings: list[Standing] = []
    rank = 0
    for place, one in enumerate(newest):
        if place == 0 or _merit(one)[:2] != _merit(newest[place - 1])[:2]:
            rank = place + 1
        p_value = mcnemar(newest[0].right, one.right).p_value if place else None
        tied = p_value is None or p_value >= SIGNIFICANCE
        standings += [Standing(row, rank, tied, p_value, _is_fair(row)) for row in by_method[one.method]]
    return standings


def _merit(entry: Entry) -> tuple[float, float, str]:
    """Return what rows are sorted by; an undefined area comes after every defined one."""
    area = entry.metrics["pr_auc"].value
    return -_recall(entry), math.inf if math.isnan(area) else -area, entry.method


def _recall(entry: Entry) -> float:
    return entry.metrics["recall@1"].value


def _is_ranked(entry: Entry) -> bool:
    return not entry.partial and not math.isnan(_recall(entry))


def _is_fair(entry: Entry) -> bool:
    return "latency_total_p50" in entry.latency and not doubt(entry.elsewhere)


def _check_comparable(protocol: Protocol, entries: list[Entry]) -> None:
    first = max(entries, key=lambda one: (one.precedence, one.machine))
    for one in entries:
        if one.dataset_digest != first.dataset_digest:
            found = [f"{_name(row)} has {one_line(row.dataset_digest)}" for row in (one, first)]
            raise DataError(f"The rows of {protocol} are about different images: {', '.join(found)}. {_AGREE}")
        counted = [(row.n_references, row.n_queries, row.n_counted) for row in (one, first)]
        if not one.partial and not first.partial and counted[0] != counted[1]:
            found = [
                f"{_name(row)} counts {row.n_counted} of {row.n_queries} on {row.n_references} references"
                for row in (one, first)
            ]
            raise DataError(f"The rows of {protocol} are about different queries: {', '.join(found)}. {_AGREE}")


def _name(entry: Entry) -> str:
    return f"{shortened(entry.method)} (run {entry.run})"


def _published(protocol: Protocol) -> list[Published]:
    """Return what the dataset's card knows; a leaderboard may outlive its dataset's plug-in."""
    try:
        return published_for(find_card(protocol.dataset), protocol)
    except VprBenchError:
        return []
