import math
import struct
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image
from PIL.TiffImagePlugin import IFDRational

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.describe_own import describe_own
from vpr_bench.dataset.load import DatasetWarning
from vpr_bench.errors import DataError
from vpr_datasets.layouts.exif import load, recognise
from vpr_datasets.layouts.exif_header import read_header

CARD = TraverseCard(name="walk")
PIXEL = Image.new("RGB", (2, 2))


def sexagesimal(degrees):
    """Return degrees, minutes and seconds as a camera writes them."""
    whole, rest = divmod(round(abs(degrees) * 3600 * 10**6), 3600 * 10**6)
    minutes, seconds = divmod(rest, 60 * 10**6)
    return IFDRational(whole), IFDRational(minutes), IFDRational(seconds, 10**6)


def header(latitude=52.5, longitude=13.3, direction=None, taken=None, fraction=None, **tags):
    gps, details = {}, {}
    if latitude is not None:
        gps = {1: "N" if latitude >= 0 else "S", 2: sexagesimal(latitude)}
        gps |= {3: "E" if longitude >= 0 else "W", 4: sexagesimal(longitude)}
    if direction is not None:
        gps[17] = IFDRational(round(direction * 100), 100)
    gps |= {int(tag[1:]): value for tag, value in tags.items()}
    if taken is not None:
        details[0x9003] = taken
    if fraction is not None:
        details[0x9291] = fraction
    exif = Image.Exif()
    for tag, fields in ((0x8825, gps), (0x8769, details)):
        exif.get_ifd(tag).update(fields)
        exif[tag] = fields
    return exif


def write(file, **fields):
    file.parent.mkdir(parents=True, exist_ok=True)
    PIXEL.save(file, exif=header(**fields))
    return file


def refused(folder, card=CARD):
    with pytest.raises(DataError) as caught:
        load(folder, card, "33U")
    message = str(caught.value)
    assert str(folder) in message and message.count("\n") <= 1
    return message


def names(recording):
    return [source.name for source in recording.traverse.sources]


@given(st.floats(-80, 84), st.floats(-180, 180))
def test_positions_are_read_as_they_were_written(tmp_path_factory, latitude, longitude):
    read = read_header(write(tmp_path_factory.getbasetemp() / "one.jpg", latitude=latitude, longitude=longitude))
    assert abs(read.latitude - latitude) < 1e-8 and abs(read.longitude - longitude) < 1e-8


@pytest.mark.parametrize("suffix", ["jpg", "tif", "png"])
def test_each_kind_of_photograph_is_read(tmp_path, suffix):
    read = read_header(write(tmp_path / f"a.{suffix}", direction=271.5, taken="2024:05:06 07:08:09", fraction="25"))
    assert (read.latitude, read.longitude) == pytest.approx((52.5, 13.3))
    assert (read.direction, read.taken) == (271.5, "2024:05:06 07:08:09.25")


@pytest.mark.parametrize("parts", [(52.5,), (52, 30), (52, 30, 0), (52, 29, 60)])
def test_degrees_may_have_one_to_three_parts(tmp_path, parts):
    read = read_header(write(tmp_path / "a.jpg", t2=tuple(IFDRational(round(part * 10), 10) for part in parts)))
    assert read.latitude == pytest.approx(52.5)


@pytest.mark.parametrize(
    "fields",
    [
        {"latitude": None},
        {"t2": (IFDRational(0, 0), IFDRational(0), IFDRational(0))},
        {"t2": (IFDRational(1), IFDRational(61), IFDRational(0))},
        {"t1": "X"},
        {"t1": ""},
        {"t3": "N"},
        {"t4": ()},
    ],
)
def test_half_a_fix_is_none(tmp_path, fields):
    read = read_header(write(tmp_path / "a.jpg", **fields))
    assert math.isnan(read.latitude) and math.isnan(read.longitude)


def test_labels_are_metres_and_the_compass_is_the_direction(tmp_path):
    for index in range(3):
        write(tmp_path / f"{index}.jpg", latitude=52.5 + index / 1e4, direction=index * 10)
    recording = load(tmp_path, CARD, "33U")
    assert recording.labels.shape == (3, 2) and recording.labels.dtype == np.float64
    np.testing.assert_allclose(np.diff(recording.labels, axis=0)[:, 1], 11.1, atol=0.1)
    assert recording.compass.tolist() == [0, 10, 20]


def test_photographs_come_in_the_order_in_which_they_were_taken(tmp_path):
    write(tmp_path / "1.jpg", taken="2024:05:06 07:08:10")
    write(tmp_path / "2.jpg", taken="2024:05:06 07:08:09", fraction="5")
    write(tmp_path / "3.jpg", taken="2024:05:06 07:08:09", fraction="25")
    write(tmp_path / "10.jpg", taken="2024:05:06 07:08:10")
    assert names(load(tmp_path, CARD, "33U")) == ["3.jpg", "2.jpg", "1.jpg", "10.jpg"]


@pytest.mark.parametrize("taken", [None, "", "yesterday", "0000:00:00 00:00:00"])
def test_if_one_does_not_say_when_all_come_in_the_order_of_names(tmp_path, taken):
    write(tmp_path / "1.jpg", taken="2024:05:06 07:08:10")
    write(tmp_path / "2.jpg", taken="2024:05:06 07:08:09")
    write(tmp_path / "10.jpg", taken=taken)
    assert names(load(tmp_path, CARD, "33U")) == ["1.jpg", "2.jpg", "10.jpg"]


def test_a_direction_that_some_lack_is_left_out_with_a_warning(tmp_path):
    write(tmp_path / "1.jpg", direction=5)
    write(tmp_path / "2.jpg")
    with pytest.warns(DatasetWarning, match="1 of the 2 images"):
        assert load(tmp_path, CARD, "33U").compass is None


def test_photographs_without_a_position_are_named_and_counted(tmp_path):
    write(tmp_path / "1.jpg")
    for number in (2, 3, 4):
        PIXEL.save(tmp_path / f"{number}.jpg")
    message = refused(tmp_path)
    assert "2.jpg has no position in its header (and 2 more with faults)" in message and "away" in message


def png_claiming(width, height):
    """Return a PNG of a few bytes that claims to be large."""
    chunk = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)

    def packed(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    data = packed(b"IHDR", chunk) + packed(b"IDAT", zlib.compress(b"0" * 1000)) + packed(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + data


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (b"", "is no photograph"),
        (b"GIF89a" + b"x" * 20, "is no photograph"),
        (b"\xff\xd8\xff", "is no photograph"),
        (png_claiming(100_000, 100_000), "image bomb"),
        (png_claiming(12_000, 12_000), "no position"),
    ],
)
def test_damaged_and_hostile_files_are_named(tmp_path, content, why):
    write(tmp_path / "1.jpg")
    (tmp_path / "2.jpg").write_bytes(content)
    message = refused(tmp_path)
    assert why in message and "2.jpg" in message


@given(st.integers(0, 250), st.binary(min_size=1, max_size=4))
def test_damaged_headers_are_read_or_refused(tmp_path_factory, place, content):
    file = write(tmp_path_factory.getbasetemp() / "damaged.jpg", direction=5, taken="2024:05:06 07:08:09")
    damaged = bytearray(file.read_bytes())
    damaged[place : place + len(content)] = content
    file.write_bytes(damaged)
    try:
        read = read_header(file)
    except DataError as error:
        assert str(file) in str(error) and "\n" not in str(error)
    else:
        assert math.isnan(read.latitude) == math.isnan(read.longitude)


def test_no_pixel_is_decoded(tmp_path, monkeypatch):
    for name in ("1.jpg", "2.png", "3.tif"):
        write(tmp_path / name)
    PIXEL.save(tmp_path / "4.png")
    monkeypatch.setattr(Image.Image, "load", lambda *_: pytest.fail("decoded"))
    for kind in ("PngImagePlugin.PngImageFile", "TiffImagePlugin.TiffImageFile", "ImageFile.ImageFile"):
        monkeypatch.setattr(f"PIL.{kind}.load", lambda *_: pytest.fail("decoded"))
    assert [math.isnan(read_header(file).latitude) for file in sorted(tmp_path.iterdir())] == [False] * 3 + [True]


def test_positions_far_from_the_zone_and_other_counts_are_told(tmp_path):
    write(tmp_path / "1.jpg")
    write(tmp_path / "2.jpg", latitude=-27.5, longitude=153)
    assert "2.jpg: (-27.5, 153)" in refused(tmp_path)
    (tmp_path / "2.jpg").unlink()
    assert "found 1" in refused(tmp_path, TraverseCard(name="walk", images=3))
    (tmp_path / "1.jpg").unlink()
    assert "holds no images" in refused(tmp_path)


def test_folders_of_photographs_are_recognised(tmp_path):
    for index in range(20):
        write(tmp_path / "Day 1" / f"{index}.jpg", latitude=-27.5, longitude=153 + index / 1e4)
        write(tmp_path / "query" / f"{index}.jpg", latitude=-27.5, longitude=153 + index / 1e4)
    PIXEL.save(tmp_path / "query" / "0.jpg")  # one that must be moved away
    card = describe_own(tmp_path, "exif").card
    assert card.loader.options == {"zone": "56J"}
    assert [(one.references, one.queries, one.radius) for one in card.protocols] == [("day_1", "query", 25)]
    assert len(load(tmp_path / card.traverses[0].path, card.traverses[0], **card.loader.options)) == 20


def test_folders_without_positions_are_not_recognised(tmp_path):
    assert recognise(tmp_path) is None
    assert recognise(tmp_path / "missing") is None
    for side in ("a", "b"):
        (tmp_path / side).mkdir()
        for index in range(5):
            PIXEL.save(tmp_path / side / f"{index}.jpg")
        (tmp_path / side / "damaged.jpg").write_bytes(b"\xff\xd8")
    write(tmp_path / "a" / "5.jpg")
    assert recognise(tmp_path) is None
