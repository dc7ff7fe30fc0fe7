import numpy as np
import pytest

from vpr_bench.errors import DataError
from vpr_datasets.layouts.gps_text import read_fixes

GOOD = "27.5000,153.0000\n27.5001,153.0000\n27.5001,153.0001\n"


@pytest.fixture
def file(tmp_path):
    return tmp_path / "fGPS.txt"


def refused(file, content, zone="56J", flip_latitude=True):
    file.write_text(content)
    with pytest.raises(DataError) as caught:
        read_fixes(file, zone, flip_latitude=flip_latitude)
    message = str(caught.value)
    assert str(file) in message and "\n" not in message
    return message


def test_southern_latitudes_without_a_sign_go_south(file):
    file.write_text(GOOD)
    metres = read_fixes(file, "56J", flip_latitude=True)
    assert metres.shape == (3, 2) and metres.dtype == np.float64
    steps = np.diff(metres, axis=0)
    assert steps[0, 1] == pytest.approx(-11.1, abs=0.1)  # a larger latitude is farther south
    assert steps[1, 0] == pytest.approx(9.9, abs=0.1)


def test_signed_latitudes_are_taken_as_they_are(file):
    file.write_text(GOOD.replace("27.5", "-27.5"))
    signed = read_fixes(file, "56J", flip_latitude=False)
    file.write_text(GOOD)
    np.testing.assert_array_equal(signed, read_fixes(file, "56J", flip_latitude=True))


@pytest.mark.parametrize("between", [" ", "\t", " , ", ",  "])
def test_commas_and_blanks_separate(file, between):
    file.write_text(GOOD)
    expected = read_fixes(file, "56J", flip_latitude=True)
    file.write_text(GOOD.replace(",", between).replace("\n", "\r\n") + "\n \n\n")
    np.testing.assert_array_equal(read_fixes(file, "56J", flip_latitude=True), expected)


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("", "the line is empty"),
        ("   ", "the line is empty"),
        ("nan,nan", "'nan' is not a number"),
        ("0,0", "no fix"),
        ("0.0 0.0", "no fix"),
        ("27.5", "expected two numbers, found '27.5'"),
        ("27.5,153,12", "expected two numbers"),
        ("27.5,", "is not a number"),
        ("27.5;153", "expected two numbers"),
        ("-27.5,153", "the latitude's sign looks wrong"),
        ("27.5,13", "more than 6 degrees"),
        ("153,27.5", "the latitude must lie"),
    ],
)
def test_a_line_without_a_fix_is_named(file, line, why):
    message = refused(file, f"27.5,153\n{line}\n27.5,153\n{line}\n27.5,153\n")
    assert why in message and ", line 2: " in message and "(and 1 more with faults)" in message


def test_the_missing_flip_is_noticed(file):
    assert "line 1: (27.5, 153) is not in the zone 56J, south of the equator" in refused(
        file, GOOD, flip_latitude=False
    )


@pytest.mark.parametrize("content", ["", "\n\n"])
def test_an_empty_file_has_no_fixes(file, content):
    assert "line 1" in refused(file, content)


def test_a_missing_file_and_another_kind_of_file_are_named(file):
    with pytest.raises(DataError, match="is missing"):
        read_fixes(file, "56J", flip_latitude=True)
    file.write_bytes(b"\x80\x04\x95")
    with pytest.raises(DataError, match="not UTF-8"):
        read_fixes(file, "56J", flip_latitude=True)
