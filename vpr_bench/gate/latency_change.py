"""How long queries took then and now, and whether the two times can be compared."""

from dataclasses import dataclass
from typing import Any

from vpr_bench.gate.cell import Cell
from vpr_bench.runner.fair_times import doubt

NOTABLE = 1.25
"""How many times as long, or as short, is told though nobody asked for times to be judged."""

_TOTAL = "total_p50"


@dataclass(frozen=True)
class LatencyChange:
    """Times per query in milliseconds, ``<stage>_p50`` and ``<stage>_p95``.

    Attributes
    ----------
    before, after : dict
        In the baseline, and now.
    limit : float or None
        Largest ratio that passes; None: times never fail.
    doubt : str
        Why the two cannot be compared; empty if they can.
    """

    before: dict[str, float]
    after: dict[str, float]
    limit: float | None
    doubt: str

    @property
    def ratio(self) -> float | None:
        """How many times as long the median query takes now; None if that is not known."""
        before, after = self.before.get(_TOTAL), self.after.get(_TOTAL)
        return after / before if before and after is not None else None

    @property
    def fault(self) -> str | None:
        """Why this is not allowed, None if it is or if the two cannot be compared."""
        if self.limit is None or self.doubt or self.ratio is None or self.ratio <= self.limit:
            return None
        return f"{self.told()}: {self.limit:g} times is allowed"

    @property
    def note(self) -> str | None:
        """What is to be said of times that fail nothing, None if nothing is."""
        if self.limit is not None and self.doubt:
            return f"times are not judged: {self.doubt}; {self.told()}"
        if self.doubt or self.fault or not self.ratio or 1 / NOTABLE <= self.ratio <= NOTABLE:
            return None
        return self.told()

    def told(self) -> str:
        """Say in a few words what became of the median query."""
        if self.ratio is None:
            return "no times to compare"
        return (
            f"the median query takes {self.ratio:.2f} times as long "
            f"({self.before[_TOTAL]:.3g} → {self.after[_TOTAL]:.3g} ms)"
        )

    def as_dict(self) -> dict[str, Any]:
        """Return everything JSON-able."""
        return {
            "before_ms": self.before,
            "after_ms": self.after,
            "ratio": self.ratio,
            "limit": self.limit,
            "judged": self.limit is not None and not self.doubt,
            "doubt": self.doubt or None,
        }


def latency_change(before: Cell, after: Cell, limit: float | None) -> LatencyChange:
    """Compare the times of two recordings of one cell."""
    return LatencyChange(before.latency, after.latency, limit, _doubt(before, after))


def _doubt(before: Cell, after: Cell) -> str:
    if before.machine.fingerprint != after.machine.fingerprint:
        return "they were measured on different machines"
    for when, cell in (("the baseline", before), ("the run", after)):
        if said := doubt(cell.machine.elsewhere):
            return f"{said} during {when}"
    return ""
