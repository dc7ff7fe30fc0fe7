"""The radii at which the page draws curves, around the one that a protocol is ranked at."""

from vpr_bench.errors import UsageError
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import UNMEASURED, Protocol

_FRAMES = (0, 1, 2, 5, 10)
_NEAREST = (1, 2, 5, 10)
_TIMES = (0.2, 0.5, 1, 2, 4)  # of the protocol's own


def radii(protocol: Protocol) -> list[float]:
    """Return the radii of a protocol's charts, ascending, its own among them.

    Examples
    --------
    >>> radii(Protocol.parse("gardens/day_left-night_right@3f"))
    [0.0, 1.0, 2.0, 3.0, 5.0, 10.0]
    >>> radii(Protocol.parse("nordland/summer-winter@10f"))
    [2.0, 5.0, 10.0, 20.0, 40.0]
    >>> radii(Protocol.parse("own/a-b@25m")), radii(Protocol.parse("own/a-b@pair"))
    ([5.0, 12.5, 25.0, 50.0, 100.0], [0.0])
    """
    own = protocol.radius
    if protocol.unit in UNMEASURED:
        return [own]
    if protocol.unit == "nearest":
        return sorted({own, *map(float, _NEAREST)})
    if protocol.unit == "f" and own <= max(_FRAMES) / 2:
        return sorted({own, *map(float, _FRAMES)})
    return sorted({own * times for times in _TIMES})


def drawn(protocol: Protocol, places: Places) -> list[Protocol]:
    """Return the protocol at each of its radii; those that reach over the whole map are left out."""
    kept = []
    for radius in radii(protocol):
        one = protocol.with_radius(radius)
        try:
            places.check(one)
        except UsageError:
            continue
        kept.append(one)
    return kept


def unit_in_words(protocol: Protocol) -> str:
    """Name what the radius counts; nothing where there is none."""
    return {"f": "frames", "m": "metres", "nearest": "nearest references"}.get(protocol.unit, "")


def distance(length: float, protocol: Protocol) -> str:
    """Write a length in the unit of a protocol.

    Examples
    --------
    >>> distance(1, Protocol.parse("own/a-b@2f")), distance(12.345, Protocol.parse("own/a-b@25m"))
    ('1 frame', '12.35 metres')
    """
    words = unit_in_words(protocol)
    return f"{length:.4g} {words.removesuffix('s') if length == 1 else words}".rstrip()
