"""What others published on a protocol, and where."""

from collections.abc import Collection, Iterable

from vpr_bench.dataset.card import Card, Published
from vpr_bench.errors import one_line
from vpr_bench.types.protocol import Protocol


def published_for(card: Card, protocol: Protocol) -> list[Published]:
    """Return the published numbers of a protocol: same pairing, and the same reach where one is stated."""
    if protocol.edition != "real":
        return []
    return [
        one
        for one in card.published
        if f"{one.references}-{one.queries}" == protocol.pairing
        and (one.radius is None or (one.radius, one.unit or card.unit) == (protocol.radius, protocol.unit))
    ]


def with_sources(
    published: Iterable[Published], metrics: Collection[str], protocol: Protocol
) -> tuple[list[tuple[Published, int]], list[str]]:
    """Give the sources of the published numbers that a table shows their numbers.

    Parameters
    ----------
    published : iterable of Published
        As :func:`published_for` returns them.
    metrics : collection of str
        Those that the table shows.
    protocol : Protocol
        Of the table.

    Returns
    -------
    list of (Published, int), list of str
        Those of these metrics, each with the number of its source from 1, and the sources: foreign text on one line,
        with the radius that it states.
    """
    shown = [one for one in published if one.metric in metrics]
    sources = list(dict.fromkeys(_source(one, protocol) for one in shown))
    return [(one, sources.index(_source(one, protocol)) + 1) for one in shown], sources


def _source(one: Published, protocol: Protocol) -> str:
    """Name the source; a radius that it states is the protocol's, or it would not stand beside it."""
    radius = "radius not stated" if one.radius is None else f"radius {protocol.reach}"
    return f"{one_line(one.source)}, {radius}"
