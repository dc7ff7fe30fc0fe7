"""Which folder of somebody's images is the map, and which are looked up in it."""

from collections.abc import Sequence

_MAPS = ("ref", "reference", "references", "database", "db", "map", "train", "gallery")
_QUERIES = ("query", "queries", "q", "test", "probe")


def pairings(names: Sequence[str]) -> list[tuple[str, str]]:
    """Say which traverse is looked up in which, the most natural pairing first.

    A traverse called ``ref``, ``database`` or the like is the map, one called ``query`` or the like never is; else
    the first is the map. Every other one is looked up in it.

    Examples
    --------
    >>> pairings(["queries", "database"]), pairings(["dawn", "day", "night"])
    ([('database', 'queries')], [('dawn', 'day'), ('dawn', 'night')])
    """
    maps = [name for name in names if name.lower() in _MAPS]
    others = [name for name in names if name.lower() not in _QUERIES]
    map_ = next(iter(maps or others or names), None)
    return [(map_, name) for name in names if name != map_] if map_ is not None else []
