"""A railway in the north: a single track through woods, farms and cuttings, past lakes and through tunnels."""

from dataclasses import dataclass
from itertools import pairwise

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.countryside import Country, fill, grow
from vpr_datasets.simulation.floors import MEADOW
from vpr_datasets.simulation.path import Course
from vpr_datasets.simulation.rocks import put_cutting, put_tunnel
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.spec import Season, TraverseSpec
from vpr_datasets.simulation.stage import Floor, Mover, Stage
from vpr_datasets.simulation.trackside import put_bridge, put_station, set_posts, string_wires

SETTING = Setting(
    knot=70.0,
    beyond=260.0,
    density=9.0,
    margin=12.0,
    land=170.0,
    reach=190.0,
    slab_reach=110.0,
    kerb=None,
    skyline="hills",
    snow={"spring": 0.34, "winter": 0.7},
)

SIDES = ("wood", "wood", "wood", "meadow", "farm", "lake", "birches", "heath", "village", "meadow")
"""What lies beside the track, as it is dealt to each side; what is listed twice is twice as common."""

LINE = ("cutting", "station", "bridge", "cutting")
"""What reaches across the track, as it is dealt."""

BED = 2.5
"""Half the width of the ballast in metres."""


@dataclass(frozen=True)
class Piece:
    """What lies on one side of the track, or across it, from ``start`` to ``stop`` metres."""

    kind: str
    start: float
    stop: float


def lay_out(seed: int, season: Season, course: Course, length: float) -> Stage:
    """Build the scene."""
    stage = Stage(course)
    country = grow(seed, season, SETTING.snow.get(season, 0.0))
    line = _deal_line(Dice(seed, "line"), length)
    sides = {side: _deal_side(Dice(seed, "side", side + 1), line, length) for side in (1, -1)}
    _lay_floors(stage, line, sides)
    for number, piece in enumerate(line):
        _put_across(stage, Dice(seed, "across", number), country, piece)
    for side, pieces in sides.items():
        for number, piece in enumerate(pieces):
            fill(stage, Dice(seed, "beside", side + 1, number), country, piece.kind, side, piece.start, piece.stop)
    string_wires(stage, Dice(seed, "wires"), length, stage.tunnels)
    set_posts(stage, Dice(seed, "posts"), length, stage.tunnels)
    return stage


def _deal_line(dice: Dice, length: float) -> list[Piece]:
    """Decide where tunnels, cuttings, stations and bridges are."""
    pieces: list[Piece] = []
    deck: list[str] = []
    s, tunnel = dice.between(40, 70), dice.between(230, 330)
    short = dice.chance(0.5)
    while s < length + 200:
        if s > tunnel:
            extent = dice.between(46, 54) if short else dice.between(68, 76)
            pieces += [Piece("approach", s, s + 34), Piece("tunnel", s + 34, s + 34 + extent)]
            s += 34 + extent
            short, tunnel = not short, s + dice.between(360, 460)
        else:
            deck = deck or dice.shuffled(LINE)
            kind = deck.pop()
            extent = dice.between(*{"cutting": (36, 70), "station": (48, 66), "bridge": (24, 40)}[kind])
            pieces.append(Piece(kind, s, s + extent))
            s += extent
        s += dice.between(50, 110)
    return pieces


def _deal_side(dice: Dice, line: list[Piece], length: float) -> list[Piece]:
    """Fill one side between what reaches across the track; stations have a side of their own."""
    pieces: list[Piece] = []
    deck: list[str] = []
    gaps = [(-30.0, line[0].start)]
    gaps += [(one.stop, other.start) for one, other in pairwise(line)]
    for start, stop in [*gaps, (line[-1].stop, length + 250)]:
        s = start
        while s < stop - 1:
            deck = deck or dice.shuffled(SIDES)
            extent = dice.between(34, 80)
            extent = stop - s if stop - s - extent < 25 else extent
            pieces.append(Piece(deck.pop(), s, s + extent))
            s += extent
    # Opposite a platform, and behind a station's house.
    pieces.extend(Piece("yard", piece.start, piece.stop) for piece in line if piece.kind == "station")
    return pieces


GROUNDS = {
    "wood": "woodland", "birches": "woodland", "meadow": "meadow", "farm": "field", "lake": "water",
    "heath": "woodland", "village": "grass", "cutting": "rubble", "approach": "rubble", "tunnel": "rubble",
    "bridge": "water", "station": "gravel", "yard": "gravel", "heights": "rubble",
}  # fmt: skip


def _lay_floors(stage: Stage, line: list[Piece], sides: dict[int, list[Piece]]) -> None:
    """Lay the track, and on both sides what the land there is like."""
    left, right = ([*line, *sides[side]] for side in (1, -1))
    marks = sorted({mark for piece in [*left, *right] for mark in (piece.start, piece.stop)})
    for start, stop in pairwise(marks):
        middle = (start + stop) / 2
        kinds = [
            next((one.kind for one in pieces if one.start <= middle < one.stop), "wood") for pieces in (left, right)
        ]
        half = 4.4 if "lake" in kinds else BED
        stage.floors.append(Floor(start, stop, half, "track", GROUNDS[kinds[0]], GROUNDS[kinds[1]]))


def _put_across(stage: Stage, dice: Dice, country: Country, piece: Piece) -> None:
    """Build what reaches across the track."""
    extent, turf = piece.stop - piece.start, MEADOW[country.season]
    if piece.kind == "tunnel":
        put_tunnel(stage, dice, piece.start, extent, turf, country.snow)
    elif piece.kind == "bridge":
        put_bridge(stage, dice, piece.start, extent)
        for side in (1, -1):
            fill(stage, dice, country, "lake", side, piece.start, piece.stop)
    elif piece.kind == "station":
        put_station(stage, dice, dice.pick((1, -1)), piece.start, extent, country.snow)
    else:
        most = 9.0 if piece.kind == "approach" else dice.between(3.0, 7.0)
        for side in (1, -1):
            spots = put_cutting(stage, dice, side, piece.start, extent, turf, country.snow, most)
            for s, t, level in spots:
                country.plant(stage, dice, s, t, level, dice.between(0.35, 0.8))
            fill(stage, dice, country, "heights", side, piece.start, piece.stop)


def park(stage: Stage, dice: Dice, traverse: TraverseSpec, length: float) -> None:
    """Leave nothing: what differs between two journeys is the season."""


def send_out(dice: Dice, traverse: TraverseSpec, frames: int) -> list[Mover]:
    """Send nobody out on the track."""
    return []
