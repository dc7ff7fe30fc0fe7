"""Which protocols one run serves: answers do not depend on how far off they may be."""

from vpr_bench.dataset.card import find_card
from vpr_bench.errors import UsageError, VprBenchError
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol


def protocols_of(run: StoredRun) -> list[Protocol]:
    """Return the protocol that a run was asked for, and the others that its dataset lists for the same two traverses.

    A leaderboard may outlive its dataset's plug-in: without the card there is only the first.
    """
    own = run.protocol
    try:
        listed = find_card(own.dataset).in_edition(own.edition).listed_protocols(own.edition)
    except VprBenchError:
        return [own]
    alike = [one for one in listed if (one.source, one.pairing) == (own.source, own.pairing)]
    return list(dict.fromkeys([own, *alike]))


def serves(run: StoredRun, protocol: Protocol) -> bool:
    """Say whether the run's places tell what is right in a protocol of :func:`protocols_of`; nothing is scored.

    Raises
    ------
    DataError
        If the places cannot be read.
    """
    places = run.places
    try:
        places.check(protocol)
    except UsageError:
        return False
    return True
