"""What a user writes to name a dataset, an edition, or a protocol."""

from dataclasses import dataclass

from vpr_bench.errors import UsageError
from vpr_bench.types.protocol import Protocol, Unit, Unmatched


@dataclass(frozen=True)
class Request:
    """What was asked for on the command line, before anything is looked up."""

    dataset: str
    pairing: str | None
    edition: str
    radius: float | None = None
    unit: Unit | None = None
    unmatched: Unmatched | None = None

    @classmethod
    def parse(cls, text: str, pairing: str | None = None, edition: str = "auto") -> "Request":
        """Read ``gardens``, ``gardens:simulated``, ``gardens/day_left-day_right`` or a whole protocol id.

        Raises
        ------
        UsageError
            If the edition or protocol is given twice and differently.
        """
        source, slash, rest = text.partition("/")
        dataset, colon, named = source.partition(":")
        radius, unit, unmatched = None, None, None
        if "@" in rest:
            whole = Protocol.parse(text)
            rest, radius, unit, unmatched = whole.pairing, whole.radius, whole.unit, whole.unmatched
            named, colon = whole.edition, ":"
        if colon:
            if edition not in ("auto", named):
                raise UsageError(f"{text!r} names the edition {named!r}, but --edition says {edition!r}.")
            edition = named
        if slash:
            if pairing not in (None, rest):
                raise UsageError(f"{text!r} names the protocol {rest!r}, but --protocol says {pairing!r}.")
            pairing = rest
        return cls(dataset, pairing, edition, radius, unit, unmatched)
