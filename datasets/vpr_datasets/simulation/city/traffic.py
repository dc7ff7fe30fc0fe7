"""Who is about on a road: parked cars, people on the pavements, and what drives on the lanes."""

from vpr_datasets.simulation import props
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.cars import car, van
from vpr_datasets.simulation.city.cyclists import cyclist
from vpr_datasets.simulation.city.heavy import bus, lorry
from vpr_datasets.simulation.city.roads import Lane, Profile
from vpr_datasets.simulation.city.roadside import Junctions, near
from vpr_datasets.simulation.city.vehicles import Vehicle
from vpr_datasets.simulation.spec import TraverseSpec
from vpr_datasets.simulation.stage import Mover, Stage

STEP = 4.0
"""Metres between frames where a traverse does not say; only the speed of others depends on it."""


def draw_fleet(dice: Dice, cars: int, *, heavy: bool = False) -> list[Vehicle]:
    """Draw some cars, and a van for every five of them; lorries too if ``heavy``."""
    fleet = [car(dice) for _ in range(cars)] + [van(dice) for _ in range(cars // 5 + 1)]
    return fleet + ([lorry(dice) for _ in range(cars // 4 + 1)] if heavy else [])


def line_up(
    stage: Stage, dice: Dice, traverse: TraverseSpec, profile: Profile, length: float, junctions: Junctions
) -> None:
    """Park cars bumper to bumper, with gaps."""
    fleet = draw_fleet(dice, 20)
    for row in profile.parked:
        s = -24.0
        while s < length:
            s += dice.between(5.4, 6.6)
            if near(s, junctions, 8.0) or not dice.chance(0.35 + 0.6 * traverse.traffic):
                continue
            one = dice.pick(fleet)
            one.put(stage, s, row.t + dice.between(-0.1, 0.1), onward=row.onward)
            stage.shade(s, row.t, one.length - 0.6, one.width - 0.4, 0, one.height - 0.3)


def stand_about(stage: Stage, dice: Dice, traverse: TraverseSpec, profile: Profile, length: float) -> None:
    """Let people walk and stand on the pavements, and lean bicycles against the houses."""
    people = [props.person(dice).bake() for _ in range(14)]
    bicycles = [props.bicycle(dice).bake() for _ in range(4)]
    for t in profile.walks:
        s = -10.0
        while s < length:
            s += dice.between(3.0, 16.0)
            if dice.chance(traverse.traffic):
                place = t + dice.between(-0.6, 0.6)
                for number in range(1 + dice.below(2)):
                    stage.cutout(s + number * 0.3, place + number * 0.6, 0.9 * dice.pick((1, -1)),
                                 dice.between(1.6, 1.9), dice.pick(people))  # fmt: skip
    for side in (1, -1):
        s = 0.0
        while s < length:
            s += dice.between(8.0, 40.0)
            t = side * (profile.front(side) - 0.5)
            if dice.chance(traverse.traffic):
                stage.wall((s, t), (s + 1.8, t), 0, 1.1, dice.pick(bicycles), "both")


def set_out(dice: Dice, traverse: TraverseSpec, profile: Profile, frames: int, *, heavy: bool = False) -> list[Mover]:
    """Send vehicles along the lanes, and bicycles along the cycle paths."""
    step = traverse.step or STEP
    fleet, buses = draw_fleet(dice, 14, heavy=heavy), [bus(dice) for _ in range(3)]
    movers = []
    for lane in profile.lanes:
        if abs(lane.t - traverse.lateral) < 1.3:
            movers += _ahead(dice, traverse, lane, fleet, frames, step)
            continue
        # From a bicycle nearly everything on the road is faster.
        pace = step * (dice.between(1.2, 1.5) if lane.onward else -dice.between(0.9, 1.3))
        pace *= 2.0 if abs(traverse.lateral) > 5.7 else 1.0
        room = (20.0, 70.0) if lane.use == "cars" else (90.0, 300.0)
        meeting = -160.0 / abs(step - pace)
        while meeting < frames + 200.0 / abs(step - pace):
            meeting += dice.between(*room) / abs(step - pace)
            if dice.chance(traverse.traffic):
                movers.append(_driver(dice.pick(fleet if lane.use == "cars" else buses), meeting, pace, lane))
    for low, high in profile.cycles:
        middle = (low + high) / 2
        onward = middle < 0
        meeting = 0.0
        while meeting < frames + 30:
            meeting += 40.0 / step * dice.between(0.6, 2.0)
            if dice.chance(traverse.traffic):
                texture = cyclist(dice).bake()
                pace = step * dice.between(0.5, 0.85) * (1 if onward else -1)
                aside = middle + (0.5 if abs(middle - traverse.lateral) > 0.9 else 1.0) * dice.pick((1, -1))
                movers.append(Mover(meeting, pace, aside, 0.8, dice.between(1.7, 1.85), texture))
    return movers


def _driver(one: Vehicle, meeting: float, pace: float, lane: Lane, last: float | None = None) -> Mover:
    """Let a vehicle drive on a lane, until it turns off ``last`` metres along the path."""

    def put(stage: Stage, s: float, t: float) -> None:
        if last is None or s < last:
            one.put(stage, s, t, onward=lane.onward)

    return Mover(meeting, pace, lane.t, one.length, one.height, one.shadow, put)


def _ahead(
    dice: Dice, traverse: TraverseSpec, lane: Lane, fleet: list[Vehicle], frames: int, step: float
) -> list[Mover]:
    """Let others drive ahead on the camera's own lane, one after the other; they turn off before they are reached."""
    movers = []
    start = 0.0
    while start < frames and lane.onward:
        slower = step * dice.between(0.12, 0.4)
        first, least = dice.between(25.0, 70.0), dice.between(9.0, 14.0)
        if dice.chance(traverse.traffic):
            meeting = start + first / slower
            last = traverse.start + meeting * step - least * (step - slower) / slower
            movers.append(_driver(dice.pick(fleet), meeting, step - slower, lane, last))
        start += (first - least) / slower + dice.between(1, 6)
    return movers
