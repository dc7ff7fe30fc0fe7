"""Right answers against time: one chart per machine, for times of different machines cannot be compared."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from vpr_bench.leaderboard.standing import Board, Standing, pareto
from vpr_bench.page.looks import displayed


@dataclass(frozen=True)
class Scatter:
    """The rows of one machine that were measured while it did little else.

    Attributes
    ----------
    machine : str
        Its letter.
    standings : list of Standing
        Fastest first.
    front : list of Standing
        Those that no other one beats in both.
    """

    machine: str
    standings: list[Standing]
    front: list[Standing]

    def as_dict(self) -> dict[str, Any]:
        """Return what the page's script needs."""
        points = [_point(one) | {"front": one in self.front} for one in self.standings]
        return {"machine": self.machine, "points": points}


def scatters(board: Board, machines: Mapping[str, str]) -> list[Scatter]:
    """Return a chart for each machine of a board on which a latency was fairly measured; most rows first."""
    found = []
    for machine, letter in machines.items():
        fair = [one for one in board.standings if one.rank and one.fair_latency and one.entry.machine == machine]
        if fair:
            fair.sort(key=lambda one: (one.entry.latency["latency_total_p50"], one.rank))
            found.append(Scatter(letter, fair, pareto(board, machine)))
    return sorted(found, key=lambda one: -len(one.standings))


def _point(standing: Standing) -> dict[str, Any]:
    entry = standing.entry
    recall = entry.metrics["recall@1"]
    return {
        "method": displayed(entry.method),
        "ms": round(entry.latency["latency_total_p50"], 4),
        "recall": round(recall.value, 4),
        "low": round(recall.low, 4),
        "high": round(recall.high, 4),
    }
