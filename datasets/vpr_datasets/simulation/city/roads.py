"""Cross-sections of roads: lanes, kerbs, cycle paths and pavements, and where things have their place on them."""

from dataclasses import dataclass

from vpr_datasets.simulation.stage import Band, Floor, Stage

EDGE = 44.0
"""How far the ground of a junction reaches to either side, in metres."""


@dataclass(frozen=True)
class Lane:
    """A lane: its middle, metres to the left of the path, whether it leads along the path, and what uses it."""

    t: float
    onward: bool
    use: str = "cars"


@dataclass(frozen=True)
class Profile:
    """A cross-section; all lengths in metres to the left (positive) of the path.

    Attributes
    ----------
    kerbs
        Right and left edge of the carriageways.
    islands
        Strips between carriageways, from right to left.
    lines
        What is painted on the carriageways: place, width and material.
    lanes
        Lanes that are driven on.
    parked
        Rows of parked cars.
    cycles
        Cycle paths, from right to left.
    trees
        Rows of trees.
    walks
        Where people walk.
    fronts
        Fronts of the houses on the right (as a positive number) and on the left.
    """

    kerbs: tuple[float, float]
    islands: tuple[tuple[float, float], ...]
    lines: tuple[tuple[float, float, str], ...]
    lanes: tuple[Lane, ...]
    parked: tuple[Lane, ...]
    cycles: tuple[tuple[float, float], ...]
    trees: tuple[float, ...]
    walks: tuple[float, ...]
    fronts: tuple[float, float]

    def verge(self, side: int) -> float:
        """Return the distance, on one side, of where lamps and signs stand: beyond the kerb and a cycle path."""
        kerb = abs(self.kerbs[0] if side < 0 else self.kerbs[1])
        outer = [max(abs(low), abs(high)) for low, high in self.cycles if (low > 0) == (side > 0)]
        return max([kerb, *outer])

    def front(self, side: int) -> float:
        """Return the distance of the fronts on one side."""
        return self.fronts[0] if side < 0 else self.fronts[1]


BOULEVARD = Profile(
    kerbs=(-5.6, 19.4),
    islands=((4.4, 9.4),),
    lines=((1.1, 0.14, "dash"), (-2.2, 0.25, "line"), (12.7, 0.14, "dash"), (16.0, 0.25, "line"),
           (-5.25, 0.12, "line"), (4.1, 0.12, "line"), (9.6, 0.12, "line")),
    lanes=(Lane(2.75, True), Lane(-0.55, True), Lane(-3.9, True, "buses"), Lane(11.1, False), Lane(14.3, False),
           Lane(17.7, False, "buses")),
    parked=(Lane(5.5, True), Lane(8.3, False)),
    cycles=((-7.5, -6.0), (19.8, 21.3)),
    trees=(-9.4, 6.9, 23.2),
    walks=(-13.0, -11.6, 25.0, 26.4),
    fronts=(15.2, 28.0),
)  # fmt: skip
"""A grand one: three lanes each way, cars between trees in the middle, broad pavements."""

STREET = Profile(
    kerbs=(-7.8, 7.8),
    islands=(),
    lines=((0.0, 0.14, "dash"), (-4.0, 0.14, "line"), (4.0, 0.14, "line"), (-5.65, 0.12, "short dash"),
           (5.65, 0.12, "short dash")),
    lanes=(Lane(-2.1, True), Lane(2.1, False)),
    parked=(Lane(-6.7, True), Lane(6.7, False)),
    cycles=((-5.55, -4.1), (4.1, 5.55)),
    trees=(-9.6, 9.6),
    walks=(-12.6, -11.4, 11.6, 12.8),
    fronts=(14.6, 14.8),
)  # fmt: skip
"""A busy one: a lane and a cycle lane each way between parked cars."""


def pave(stage: Stage, profile: Profile, start: float, stop: float, junctions: list[tuple[float, float]]) -> None:
    """Lay the road, with its kerbs, and open it where side streets join."""
    stretches = [start, *[edge for junction in junctions for edge in junction], stop]
    for first, last in zip(stretches[::2], stretches[1::2], strict=True):
        _lay(stage, first, last, _between(profile))
    for first, last in junctions:
        # The first floors are the uppermost ones: crossings lie on the junction, stop lines before it.
        _lay(stage, first, last, _across(profile))
        for place in (first - 3.2, last + 0.4):
            stage.floors.insert(0, Floor(place, place + 2.8, 2.0, "tarmac", "plates", "plates", _zebra(profile)))
        stop_line = (*_between(profile), Band(profile.kerbs[0], _middle(profile), "line"))
        stage.floors.insert(0, Floor(first - 5.0, first - 4.5, 2.0, "tarmac", "plates", "plates", stop_line))


def _lay(stage: Stage, start: float, stop: float, bands: tuple[Band, ...]) -> None:
    stage.floors.append(Floor(start, stop, 2.0, "tarmac", "plates", "plates", bands))


def _middle(profile: Profile) -> float:
    """Return where the right-hand traffic ends."""
    return profile.islands[0][0] if profile.islands else 0.0


def _between(profile: Profile) -> tuple[Band, ...]:
    """Return the bands of the road between two junctions."""
    right, left = profile.kerbs
    bands = [
        Band(-EDGE, EDGE, "plates"),
        Band(-profile.fronts[0] - 0.1, -profile.fronts[0] + 1.6, "mosaic"),
        Band(profile.fronts[1] - 1.6, profile.fronts[1] + 0.1, "mosaic"),
        Band(right - 3.0, right, "mosaic"),
        Band(left, left + 3.0, "mosaic"),
    ]
    bands += [Band(t - 0.9, t + 0.9, "mosaic") for t in profile.trees]
    bands += _carriageway(profile)
    for low, high in profile.cycles:
        bands.append(Band(low, high, "cycle path" if not right < low < left else "cycle lane"))
        bands += [Band(edge - 0.06, edge + 0.06, "line") for edge in (low, high)]
    bands += [Band(t - width / 2, t + width / 2, material) for t, width, material in profile.lines]
    return tuple(bands)


def _carriageway(profile: Profile) -> list[Band]:
    right, left = profile.kerbs
    bands = [
        Band(right - 0.3, left + 0.3, "kerbstone"),
        Band(right, left, "gutter"),
        Band(right + 0.35, left - 0.35, "tarmac"),
    ]
    for low, high in profile.islands:
        bands += [Band(low, high, "kerbstone"), Band(low + 0.3, high - 0.3, "cobbles")]
        bands.append(Band((low + high) / 2 - 0.5, (low + high) / 2 + 0.5, "grass"))
    return bands


def _across(profile: Profile) -> tuple[Band, ...]:
    """Return the bands where a side street joins: tarmac from house to house."""
    return (Band(-EDGE, EDGE, "tarmac"), *(Band(low, high, "cycle path") for low, high in profile.cycles))


def _zebra(profile: Profile) -> tuple[Band, ...]:
    """Return the bands of a crossing for people on foot: stripes along the road."""
    right, left = profile.kerbs
    bands = [*_between(profile), Band(right, left, "tarmac")]
    place = right + 0.5
    while place + 0.5 < left:
        bands.append(Band(place, place + 0.5, "line"))
        place += 1.0
    return tuple(bands)
