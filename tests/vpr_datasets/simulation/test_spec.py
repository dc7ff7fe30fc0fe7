import pytest
from pydantic import ValidationError

from vpr_datasets.simulation import SimulationSpec


def spec(**changes: object) -> SimulationSpec:
    return SimulationSpec.model_validate({"seed": 1, "traverses": [{"name": "day"}], **changes})


def test_defaults_and_round_trip() -> None:
    made = spec()
    assert (made.frames, made.width, made.height) == (200, 640, 360)
    assert SimulationSpec.model_validate_json(made.model_dump_json()) == made
    hash(made)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"sede": 1}, "sede"),
        ({"frames": 0}, "frames"),
        ({"width": 161}, "must be even, got 161"),
        ({"scene": "moon"}, "campus"),
        ({"traverses": []}, "traverses"),
        ({"traverses": [{"name": "day"}, {"name": "day"}]}, "distinct names, got day, day"),
        ({"traverses": [{"name": "../day"}]}, "name"),
        ({"traverses": [{"name": "day", "light": "noon"}]}, "light"),
        ({"traverses": [{"name": "day", "lateral": float("nan")}]}, "lateral"),
        ({"traverses": [{"name": "day", "seed": -1}]}, "seed"),
    ],
)
def test_wrong_values_are_named(changes: dict[str, object], words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        spec(**changes)


def test_unknown_traverse_is_named_with_the_known_ones() -> None:
    with pytest.raises(ValueError, match="no traverse 'night' in the simulation; it has day"):
        spec().traverse("night")
