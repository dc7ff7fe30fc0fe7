"""What a kind of scene decides about the land around it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from vpr_datasets.simulation.path import KNOT
from vpr_datasets.simulation.spec import Season
from vpr_datasets.simulation.texture import Colour

Skyline = Literal["town", "hills", "trees"]


@dataclass(frozen=True)
class Setting:
    """How wide and how bendy the land is, and what one sees at its end; all lengths in metres.

    Attributes
    ----------
    knot
        Distance between the points at which the slope of the path is drawn.
    beyond
        How far the path goes on after the last place.
    density
        Texels of the ground per metre.
    margin
        How far the ground is painted to either side of the path.
    land
        How far it goes on, painted coarsely; 0 where buildings hide it.
    reach, slab_reach
        How far walls and level pieces are drawn.
    least
        Walls that would be lower or narrower than so many pixels are not drawn.
    kerb
        Colour of the edge of the path, if it has one.
    skyline
        What stands at the horizon.
    snow
        Share of the ground that lies under snow in a season, 0 where none is given.
    """

    knot: float = KNOT
    beyond: float = 80.0
    density: float = 12.0
    margin: float = 30.0
    land: float = 0.0
    reach: float = 95.0
    slab_reach: float = 45.0
    least: float = 3.5
    kerb: Colour | None = (172, 168, 160)
    skyline: Skyline = "town"
    snow: Mapping[Season, float] = field(default_factory=dict)
