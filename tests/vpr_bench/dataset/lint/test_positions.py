from pathlib import Path

import numpy as np
import pytest

from vpr_bench.dataset.lint.positions import find_jumps
from vpr_bench.dataset.recording import Recording
from vpr_bench.types.traverse import Traverse


@pytest.fixture
def driven(made):
    """Give both traverses positions in metres, ten from each other."""
    made.unit = "m"
    track = [[500000.0 + 10 * step, 6000000.0] for step in range(10)]
    made.options = {"day": {"labels": track}, "night": {"labels": [[east + 1, north] for east, north in track]}}
    made.protocols = [{"references": "day", "queries": "night", "radius": 25}]
    return made


def test_a_good_drive(driven):
    assert driven.lint() == []


def test_a_jump(driven):
    for traverse in driven.options.values():
        traverse["labels"][5][1] += 500
    found = driven.lint()
    assert [(one.check, one.severity, one.where) for one in found] == [
        ("position-jump", "warning", "day"),
        ("position-jump", "warning", "night"),
    ]
    assert found[0].message == (
        "2 jumps, where the median step is 10.0 m: day/04.png to day/05.png (500 m), day/05.png to day/06.png (500 m)"
    )


@pytest.mark.parametrize("metres", [90, 150])
def test_a_gap_in_the_signal_is_no_jump(driven, metres):
    for traverse in driven.options.values():
        for label in traverse["labels"][6:]:
            label[0] += metres
    assert driven.lint() == []


def test_a_stop_does_not_make_driving_a_jump(driven):
    for traverse in driven.options.values():
        east = np.array([0.0] * 7 + [101, 202, 303])
        traverse["labels"] = [[500000 + one, 6000000.0] for one in east]
    assert driven.lint() == []


def drive(positions, folders=None):
    """Return a recording along a line, each image in its folder."""
    folders = folders or ["all"] * len(positions)
    files = [Path(folder, f"{index}.png") for index, folder in enumerate(folders)]
    return Recording(Traverse("drive", files), np.array(positions, dtype=np.float64))


@pytest.mark.parametrize(("jumps", "found"), [(0, 0), (1, 1), (5, 1), (6, 0)])
def test_panoramas_of_a_city_are_no_drive(jumps, found):
    steps = np.ones(100)
    steps[10 : 10 + jumps] = 500
    assert len(find_jumps(drive([0, *steps.cumsum()]))) == found


def test_another_folder_is_another_drive():
    positions = [0, 10, 20, 30, 9000, 9010, 9020]
    assert len(find_jumps(drive(positions))) == 1
    assert find_jumps(drive(positions, ["a"] * 4 + ["b"] * 3)) == []


@pytest.mark.parametrize("positions", [[], [5], [5, 900], [7, 7, 7]])
def test_too_little_to_tell(positions):
    assert find_jumps(drive(positions)) == []


@pytest.mark.parametrize("shift", [[0, -12000000.0], [30, 200.0], [-700, 0]])
def test_a_map_in_another_part_of_the_world(driven, shift):
    driven.options["night"]["labels"] = [
        [east + shift[0], north + shift[1]] for east, north in driven.options["night"]["labels"]
    ]
    finding = driven.only()
    assert (finding.check, finding.severity, finding.where) == ("far-apart", "error", "made/day-night@25m")
    assert "wrong sign, zone or order" in finding.message


def test_queries_beside_the_map_are_not_far(driven):
    driven.options["night"]["labels"] = [[east, north + 24] for east, north in driven.options["night"]["labels"]]
    assert driven.lint() == []
