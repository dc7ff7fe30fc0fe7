from pathlib import Path

import pytest

from vpr_bench.errors import DataError
from vpr_datasets.layouts.fix_of_image import fixes_of


@pytest.fixture
def gps(tmp_path):
    """Ten positions, ten metres apart, towards the north."""
    file = tmp_path / "fGPS.txt"
    file.write_text("".join(f"{-27.5 + line * 10 / 110_790:.7f},153.0\n" for line in range(10)))
    return file


def north(gps, images, **options):
    """How far north of the first line the images are, in tens of metres."""
    files = [Path(f"image{number:03d}.jpg") for number in images]
    everything = fixes_of([Path("x")] * 10, gps, "56J", False)
    return [round(float(one)) for one in (fixes_of(files, gps, "56J", False, **options)[:, 1] - everything[0, 1]) / 10]


def test_one_line_per_image(gps):
    assert north(gps, range(10)) == list(range(10))


@pytest.mark.parametrize("count", [9, 11])
def test_other_counts_are_refused_unless_an_option_says_which_line_is_whose(gps, count):
    with pytest.raises(DataError, match=f"has 10 positions for {count} images.*option stride, or first_frame"):
        north(gps, range(count))


def test_a_stride_takes_every_so_many_th_line(gps):
    assert north(gps, range(4), stride=3) == [0, 3, 6, 9]
    assert north(gps, range(4), stride=1) == [0, 1, 2, 3]
    with pytest.raises(DataError, match=r"image004\.jpg would need number 13"):
        north(gps, range(5), stride=3)


def test_numbers_of_frames_may_be_in_the_names(gps):
    assert north(gps, [2, 3, 7], first_frame=0) == [2, 3, 7]
    assert north(gps, [2, 3, 10], first_frame=1) == [1, 2, 9]
    for number, first in ((10, 0), (0, 1)):
        with pytest.raises(DataError, match="Check the option first_frame"):
            north(gps, [number], first_frame=first)
    with pytest.raises(DataError, match="has no number in its name"):
        fixes_of([Path("library.jpg")], gps, "56J", False, first_frame=0)


@pytest.mark.parametrize("options", [{"stride": 0}, {"stride": -1}, {"stride": 2, "first_frame": 0}])
def test_options_that_make_no_sense_are_refused(gps, options):
    with pytest.raises(DataError, match="stride must be at least 1, and goes without first_frame"):
        north(gps, range(3), **options)
