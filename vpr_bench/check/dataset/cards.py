"""What a dataset's card says."""

from vpr_bench.check.dataset.subject import DatasetSubject
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.check.suite import check
from vpr_bench.dataset.request import Request
from vpr_bench.types.protocol import Protocol


@check("card-says-whose")
def card_says_whose(subject: DatasetSubject) -> None:
    """Check that the card gives a name, a summary, a citation, a licence and a homepage."""
    if subject.source.own is not None:
        raise Skipped("it is a folder of one's own, without a card")
    missing = [
        field
        for field in ("name", "summary", "citation", "licence", "homepage")
        if not str(getattr(subject.source.whole, field)).strip()
    ]
    if missing:
        raise Failed(f"the card says nothing about: {', '.join(missing)}")


@check("protocol-ids-round-trip")
def protocol_ids_round_trip(subject: DatasetSubject) -> None:
    """Check that each protocol's id parses back, and asks for that protocol."""
    for protocol in subject.protocols:
        if Protocol.parse(str(protocol)) != protocol:
            raise Failed(f"{protocol} parses back as {Protocol.parse(str(protocol))!r}")
        asked = Request.parse(str(protocol))
        found = subject.source.card.protocol(asked.pairing, subject.source.edition)
        if found.with_radius(protocol.radius).pairing != protocol.pairing or found.reach != protocol.reach:
            raise Failed(f"who asks for {protocol} gets {found}")


CHECKS = (card_says_whose, protocol_ids_round_trip)
