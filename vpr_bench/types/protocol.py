"""What exactly a number was measured on, as one canonical string.

This module imports nothing heavy: listings use it.
"""

import dataclasses
import math
import re
from dataclasses import dataclass
from typing import Any, Literal, get_args

from vpr_bench.errors import UsageError

Unit = Literal["f", "m", "nearest", "pair", "given"]
"""What the radius is measured in: frames, metres, or how many of the ``nearest`` references are the same place.

With ``pair`` the labels are ids, equal or not, and with ``given`` a file of the dataset lists the pairs: there is
no radius then; it is 0 and not written.
"""

UNMEASURED: tuple[Unit, ...] = ("pair", "given")
"""The units without a radius."""

Unmatched = Literal["exclude", "miss", "reject"]
"""What becomes of a query that has no true match (see ``vpr_bench.metrics.answers``)."""

_NAME = r"[a-z0-9][a-z0-9._]*"
_PATTERN = re.compile(
    rf"(?P<dataset>[a-z0-9][a-z0-9-]*)(:(?P<edition>{_NAME}))?"
    rf"/(?P<references>{_NAME}(\+{_NAME})*)-(?P<queries>{_NAME}(\+{_NAME})*)"
    r"@((?P<radius>[0-9.e+-]+)(?P<unit>f|m|nearest)|(?P<unmeasured>pair|given))"
    r"(~(?P<unmatched>[a-z]+))?"
)


@dataclass(frozen=True)
class Protocol:
    """Dataset, edition, references, queries, radius and unmatched policy, frozen.

    Attributes
    ----------
    dataset : str
        Dataset id, for example ``gardens``.
    references, queries : str
        Traverse names; several joined by ``+``, parts of one as ``summer.every10`` (see ``vpr_bench.dataset.parts``).
    radius : float
        How far apart two place labels may be and still be the same place, inclusive; with the unit ``nearest``,
        how many of the nearest references are.
    unit : {"f", "m", "nearest", "pair", "given"}
        The unit of the radius.
    edition : str
        Where the images come from; ``real`` is not written in the id.
    unmatched : {"exclude", "miss", "reject"}
        Policy for queries without a true match; ``exclude`` is not written in the id.

    Examples
    --------
    >>> str(Protocol("gardens", "day_left", "night_right", 2, "f"))
    'gardens/day_left-night_right@2f'
    >>> Protocol.parse("gardens:simulated/day_left-night_right@2.5m~reject").unmatched
    'reject'
    """

    dataset: str
    references: str
    queries: str
    radius: float
    unit: Unit
    edition: str = "real"
    unmatched: Unmatched = "exclude"

    def __post_init__(self) -> None:
        """Check the parts, so that every protocol prints and parses.

        Raises
        ------
        UsageError
            If the radius is negative or not a number, or a name or policy is not one.
        """
        if not isinstance(self.radius, int | float) or not math.isfinite(self.radius) or self.radius < 0:
            raise UsageError(f"The radius must be a number of at least 0. Got {self.radius!r} instead.")
        object.__setattr__(self, "radius", float(self.radius))
        if self.unmatched not in get_args(Unmatched):
            raise UsageError(
                f"The unmatched policy must be one of {', '.join(get_args(Unmatched))}. Got {self.unmatched!r} instead."
            )
        if self.unit in UNMEASURED and self.radius != 0:
            what = "Pair labels have" if self.unit == "pair" else "A given ground truth has"
            raise UsageError(f"{what} no radius: it must be 0. Got {self.radius:g} instead.")
        if self.unit == "nearest" and (self.radius < 1 or not self.radius.is_integer()):
            raise UsageError(
                f"The number of nearest references must be whole, at least 1. Got {self.radius:g} instead."
            )
        if _PATTERN.fullmatch(str(self)) is None:
            raise UsageError(f"{str(self)!r} is not a protocol: names are lower-case letters, digits, '_', '.'.")

    def __str__(self) -> str:
        """Return the canonical id."""
        policy = "" if self.unmatched == "exclude" else f"~{self.unmatched}"
        return f"{self.source}/{self.pairing}@{self.reach}{policy}"

    @property
    def reach(self) -> str:
        """The radius with its unit, as written in the id: ``2f``, ``25m``, ``5nearest``, ``pair`` or ``given``."""
        return self.unit if self.unit in UNMEASURED else f"{_shortest(self.radius)}{self.unit}"

    @property
    def source(self) -> str:
        """Dataset with its edition, as written in the id: ``gardens`` or ``gardens:simulated``."""
        return self.dataset if self.edition == "real" else f"{self.dataset}:{self.edition}"

    @property
    def pairing(self) -> str:
        """References and queries, as written in the id: ``day_left-night_right``."""
        return f"{self.references}-{self.queries}"

    @property
    def simulated(self) -> bool:
        """Whether the project rendered the images: such a number says nothing about the real dataset."""
        return self.edition == "simulated"

    def with_radius(self, radius: float) -> "Protocol":
        """Return the same protocol with another radius."""
        return dataclasses.replace(self, radius=radius)

    @classmethod
    def parse(cls, text: str) -> "Protocol":
        """Read a canonical id.

        Raises
        ------
        UsageError
            If the text is not one.
        """
        found = _PATTERN.fullmatch(text)
        if found is None:
            raise UsageError(
                f"{text!r} is not a protocol id. "
                "Write it like gardens/day_left-night_right@2f or gardens:simulated/day_left-day_right@3f~reject."
            )
        part = found.groupdict()
        try:
            radius = 0.0 if part["unmeasured"] else float(part["radius"])
        except ValueError:
            raise UsageError(f"{part['radius']!r} in {text!r} is not a number.") from None
        unit: Any = part["unmeasured"] or part["unit"]  # the pattern and __post_init__ check both
        unmatched: Any = part["unmatched"] or "exclude"
        return cls(
            dataset=part["dataset"],
            references=part["references"],
            queries=part["queries"],
            radius=radius,
            unit=unit,
            edition=part["edition"] or "real",
            unmatched=unmatched,
        )


def _shortest(radius: float) -> str:
    """Write a float so that it parses back exactly, whole numbers without a point."""
    return str(int(radius)) if radius.is_integer() and radius < 1e15 else repr(radius)
