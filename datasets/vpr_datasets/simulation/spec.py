"""What is to be rendered: a frozen description that fits into a table of a dataset card."""

from typing import Annotated, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, model_validator

from vpr_datasets.simulation.mosaic import Bayer

Light = Literal["day", "overcast", "dusk", "night"]
Season = Literal["spring", "summer", "autumn", "winter"]
Epoch = Literal["today", "archive"]
Shift = Annotated[float, Field(ge=-6, le=6, allow_inf_nan=False)]


def _even(value: int) -> int:
    if value % 2:
        raise ValueError(f"must be even, got {value}")
    return value


Pixels = Annotated[int, Field(ge=36, le=1920), AfterValidator(_even)]


class TraverseSpec(BaseModel):
    """One walk along the path: when it was made, and how the camera was carried.

    Attributes
    ----------
    name
        Folder of the traverse.
    light
        ``day`` (sun and shadows), ``overcast`` (a grey sky, no shadows), ``dusk`` (no sun, lamps on) or
        ``night`` (lamps and lit windows only, recorded in grey with a high gain).
    season
        Decides the colours of leaves and grass; trees are bare in winter.
    exposure
        How much brighter than usual under this light the camera is set to record.
    haze
        Distance in metres at which fog takes half of the light, by day; clear when left out.
    snowfall
        Density of falling snow; 1 is heavy.
    sun
        Metres to the east and to the north by which a shadow shifts for every metre of height, by day; where the
        sun stands changes in the course of a day. By default it stands about 47 degrees high in the north-west.
    lateral
        Metres to the left (positive) or right (negative) of the middle of the path.
    eye_height
        Height of the camera above the ground in metres.
    tilt
        How far the camera looks up (positive) or down, as the tangent of the angle.
    pace_variation
        How far, in metres, the walker runs ahead of or falls behind the nominal place of a frame.
    shake
        Strength of the jitter of a hand-held camera; 0 is a rail, 1 a person walking.
    traffic
        Share of the spots for people, bicycles and cars that are taken, from 0 to 1.
    noise
        Strength of the sensor's noise relative to what is usual under this light.
    stray
        How far the camera is set up from its nominal place, in metres at random, frame by frame.
    turn
        How far it turns aside at random, frame by frame, as a tangent.
    width, height
        Size of its images in pixels; by default the simulation's.
    focal_length
        In widths of its images; by default the simulation's.
    epoch
        ``archive`` is a photograph of long ago, grey and worn: part of the houses are others, and what belongs to
        today is missing; only scenes that know an earlier time differ.
    frames
        Images of this traverse; by default as many as the simulation says.
    start
        Place of its first image, in metres along the path.
    step
        Distance between its neighbouring images in metres; by default the simulation's.
    seed
        Chooses what passes by, the weather of the sky and the jitter; the place itself does not change.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9_-]*$")]
    light: Light = "day"
    season: Season = "summer"
    exposure: Annotated[float, Field(ge=0.3, le=3, allow_inf_nan=False)] = 1.0
    haze: Annotated[float, Field(ge=5, le=10000, allow_inf_nan=False)] | None = None
    snowfall: Annotated[float, Field(ge=0, le=3, allow_inf_nan=False)] = 0.0
    sun: tuple[Shift, Shift] | None = None
    lateral: Annotated[float, Field(ge=-12, le=12, allow_inf_nan=False)] = 0.0
    eye_height: Annotated[float, Field(ge=0.5, le=4.5, allow_inf_nan=False)] = 1.6
    tilt: Annotated[float, Field(ge=-0.3, le=0.3, allow_inf_nan=False)] = 0.0
    pace_variation: Annotated[float, Field(ge=0, le=5, allow_inf_nan=False)] = 0.5
    shake: Annotated[float, Field(ge=0, le=3, allow_inf_nan=False)] = 1.0
    traffic: Annotated[float, Field(ge=0, le=1)] = 0.5
    noise: Annotated[float, Field(ge=0, le=3, allow_inf_nan=False)] = 1.0
    stray: Annotated[float, Field(ge=0, le=5, allow_inf_nan=False)] = 0.0
    turn: Annotated[float, Field(ge=0, le=0.6, allow_inf_nan=False)] = 0.0
    width: Pixels | None = None
    height: Pixels | None = None
    focal_length: Annotated[float, Field(ge=0.3, le=3, allow_inf_nan=False)] | None = None
    epoch: Epoch = "today"
    frames: Annotated[int, Field(ge=1, le=1000)] | None = None
    start: Annotated[float, Field(ge=0, allow_inf_nan=False)] = 0.0
    step: Annotated[float, Field(gt=0, le=50, allow_inf_nan=False)] | None = None
    seed: Annotated[int, Field(ge=0)] = 0


class SimulationSpec(BaseModel):
    """A place and the traverses that are recorded in it.

    Attributes
    ----------
    seed
        Chooses the place: the course of the path, every building, tree and sign.
    scene
        The kind of place.
    frames
        Images per traverse; unless a traverse says otherwise, image ``i`` of every one shows place ``i``.
    width, height
        Size of the images in pixels.
    step
        Distance between neighbouring places along the path, in metres.
    curvature
        Greatest slope of the path against its overall direction (0 is straight, 0.5 winds by 27 degrees).
    focal_length
        Focal length in image widths; 0.85 sees 61 degrees across, as a telephone does.
    gaze
        Greatest tangent by which cameras look aside of the path; at the same place all traverses look the same way.
    quality
        JPEG quality of the files.
    bayer
        Store raw pictures of one channel behind this colour filter array, see
        :mod:`vpr_datasets.simulation.mosaic`; by default pictures are in colour.
    traverses
        One or more recordings with distinct names.

    Examples
    --------
    >>> spec = SimulationSpec.model_validate({"seed": 1, "traverses": [{"name": "day"}]})
    >>> spec.frames, spec.traverse("day").light
    (200, 'day')
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    seed: Annotated[int, Field(ge=0)]
    scene: Literal["campus", "railway", "suburb", "street", "boulevard", "motorway", "oldtown"] = "campus"
    frames: Annotated[int, Field(ge=1, le=1000)] = 200
    width: Pixels = 640
    height: Pixels = 360
    step: Annotated[float, Field(gt=0, le=50, allow_inf_nan=False)] = 1.0
    curvature: Annotated[float, Field(ge=0, le=0.6, allow_inf_nan=False)] = 0.35
    focal_length: Annotated[float, Field(ge=0.3, le=3, allow_inf_nan=False)] = 0.85
    gaze: Annotated[float, Field(ge=0, le=2, allow_inf_nan=False)] = 0.0
    quality: Annotated[int, Field(ge=50, le=100)] = 90
    bayer: Bayer | None = None
    traverses: Annotated[tuple[TraverseSpec, ...], Field(min_length=1)]

    @model_validator(mode="after")
    def _distinct(self) -> Self:
        names = [traverse.name for traverse in self.traverses]
        if len(set(names)) != len(names):
            raise ValueError(f"traverses need distinct names, got {', '.join(names)}")
        return self

    def frames_of(self, traverse: TraverseSpec) -> int:
        """Return how many images a traverse has."""
        return self.frames if traverse.frames is None else traverse.frames

    def step_of(self, traverse: TraverseSpec) -> float:
        """Return the distance between neighbouring images of a traverse, in metres."""
        return self.step if traverse.step is None else traverse.step

    def size_of(self, traverse: TraverseSpec) -> tuple[int, int]:
        """Return the width and height of the images of a traverse, in pixels."""
        return traverse.width or self.width, traverse.height or self.height

    def focal_of(self, traverse: TraverseSpec) -> float:
        """Return the focal length of a traverse, in pixels."""
        widths = self.focal_length if traverse.focal_length is None else traverse.focal_length
        return widths * self.size_of(traverse)[0]

    @property
    def length(self) -> float:
        """Metres of the path that the traverses cover."""
        return max(one.start + self.frames_of(one) * self.step_of(one) for one in self.traverses)

    def traverse(self, name: str) -> TraverseSpec:
        """Return the traverse called ``name``."""
        for traverse in self.traverses:
            if traverse.name == name:
                return traverse
        names = ", ".join(traverse.name for traverse in self.traverses)
        raise ValueError(f"no traverse {name!r} in the simulation; it has {names}")
