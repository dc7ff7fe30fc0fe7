import io
import random
import struct
import zlib

import numpy as np
import pytest
from PIL import Image

from vpr_bench.errors import DataError
from vpr_bench.types.image import FORMATS, decode_image

RED = (255, 0, 0)


def encoded(image, form="PNG", **options):
    buffer = io.BytesIO()
    image.save(buffer, form, **options)
    return buffer.getvalue()


def picture(width=31, height=24):
    """Something whose every pixel differs from its neighbours."""
    return Image.fromarray(np.random.default_rng(0).integers(0, 256, (height, width, 3), dtype=np.uint8))


def png_header(width, height):
    """A PNG of under 100 bytes that claims to be this large."""

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"")) + chunk(b"IEND", b"")


def bmp_header(width, height):
    info = struct.pack("<IiiHHIIiiII", 40, width, height, 1, 24, 0, 0, 0, 0, 0, 0)
    return b"BM" + struct.pack("<IHHI", 54, 0, 0, 54) + info


@pytest.mark.parametrize("form", FORMATS)
def test_every_format_becomes_rgb(form):
    options = {"WEBP": {"lossless": True}, "JPEG": {"quality": 100, "subsampling": 0}}.get(form, {})
    image = decode_image(encoded(picture(), form, **options))
    assert image.shape == (24, 31, 3) and image.dtype == np.uint8 and image.flags.c_contiguous
    difference = np.abs(image.astype(int) - np.asarray(picture()))
    assert difference.max() <= (6 if form == "JPEG" else 0)


@pytest.mark.parametrize("size", [(1, 1), (1, 7), (7, 1), (3, 5), (641, 3)])
def test_odd_sizes_keep_their_shape(size):
    assert decode_image(encoded(Image.new("RGB", size))).shape == (size[1], size[0], 3)


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "PA", "RGBA", "CMYK", "YCbCr", "RGB"])
def test_every_mode_becomes_rgb(mode):
    form = "JPEG" if mode in ("CMYK", "YCbCr") else "TIFF" if mode == "PA" else "PNG"
    white = Image.new("RGB", (6, 4), "white").convert(mode)
    image = decode_image(encoded(white, form))
    assert image.shape == (4, 6, 3) and image.dtype == np.uint8
    assert image.min() >= 254


def test_colours_of_palettes_and_cmyk_are_kept():
    red = Image.new("RGB", (16, 16), RED)
    for content in (encoded(red.convert("P")), encoded(red.convert("CMYK"), "JPEG")):
        assert np.abs(decode_image(content).astype(int) - RED).max() <= 2


def test_transparency_is_dropped_and_the_colour_kept():
    assert decode_image(encoded(Image.new("RGBA", (2, 2), (*RED, 0))))[0, 0].tolist() == list(RED)


@pytest.mark.parametrize("form", ["PNG", "TIFF", "PPM"])
def test_sixteen_bits_become_eight_by_their_high_byte(form):
    grey = np.array([[0, 0x00FF, 0x0100], [0x7FFF, 0xFF00, 0xFFFF]], dtype=np.uint16)
    image = decode_image(encoded(Image.fromarray(grey), form))
    assert image.shape == (2, 3, 3)
    for channel in range(3):
        assert image[..., channel].tolist() == [[0, 0, 1], [127, 255, 255]]


@pytest.mark.parametrize("orientation", range(1, 9))
def test_every_exif_orientation_becomes_upright(orientation):
    upright = np.zeros((16, 32, 3), np.uint8)
    upright[:8, :8] = 255  # the top left corner
    # How a camera stores an upright picture, for each orientation that it may write.
    stored = {
        1: upright,
        2: upright[:, ::-1],
        3: upright[::-1, ::-1],
        4: upright[::-1],
        5: upright.transpose(1, 0, 2),
        6: np.rot90(upright, 1),
        7: upright.transpose(1, 0, 2)[::-1, ::-1],
        8: np.rot90(upright, -1),
    }[orientation]
    exif = Image.Exif()
    exif[0x0112] = orientation
    image = decode_image(encoded(Image.fromarray(np.ascontiguousarray(stored)), "JPEG", exif=exif, quality=100))
    assert image.shape == upright.shape
    assert np.abs(image.astype(int) - upright).max() < 10


def test_each_call_returns_a_new_array(tmp_path):
    path = tmp_path / "image.png"
    path.write_bytes(encoded(picture()))
    first = decode_image(path)
    first[:] = 0
    assert decode_image(path).any()


SVG = b'<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"></svg>'


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (encoded(picture(640, 480), "JPEG")[:-3000], "truncated"),
        (encoded(picture(), "PNG")[:-100], "cannot be decoded"),
        (b"", r"is empty \(0 bytes\)"),
        (b"hello, I am a text\n", "is not an image"),
        (SVG, "is not an image"),
        (encoded(picture(), "GIF"), "is not an image"),
        (b"\xff\xd8\xff", "is not an image|cannot be decoded"),
        (encoded(Image.new("F", (2, 2)), "TIFF"), "no agreed range"),
        (b"P6 0 0 255\n", "is not an image"),
        (png_header(50_000, 50_000), "image bomb"),
        (bmp_header(50_000, 50_000), "image bomb"),
        pytest.param(
            png_header(15_000, 10_000),
            "claims 15000 × 10000 pixels.*image bomb",
            marks=pytest.mark.filterwarnings("ignore::PIL.Image.DecompressionBombWarning"),
        ),
    ],
    ids=[
        *("truncated jpeg", "truncated png", "empty", "text", "svg", "gif", "three bytes", "float"),
        *("no pixels", "png bomb", "bmp bomb", "smaller bomb"),
    ],
)
def test_what_is_not_a_whole_image_is_an_error_that_names_the_file(tmp_path, content, reason):
    path = tmp_path / "Image007.jpg"
    path.write_bytes(content)
    with pytest.raises(DataError, match=reason) as caught:
        decode_image(path)
    message = str(caught.value)
    assert str(path) in message
    assert message.count("\n") <= 1


def test_a_missing_file_and_a_folder_are_errors_that_name_them(tmp_path):
    for path in (tmp_path / "missing.jpg", tmp_path):
        with pytest.raises(DataError, match=rf"{path} (cannot be read: .+|is not a file)\."):
            decode_image(path)


def test_errors_about_bytes_use_the_name_they_are_given():
    with pytest.raises(DataError, match=r"^page 3 is empty"):
        decode_image(b"", name="page 3")


@pytest.mark.filterwarnings("ignore:::PIL")
@pytest.mark.parametrize("form", ["JPEG", "PNG", "BMP", "PPM", "WEBP"])
def test_damage_anywhere_is_either_survived_or_a_data_error(form):
    exif = Image.Exif()
    exif[0x0112], exif[0x010E] = 6, "a walk"
    options = {} if form in ("BMP", "PPM") else {"exif": exif}
    content = encoded(picture(), form, **options)
    chance = random.Random(1)  # noqa: S311
    outcomes = set()
    for _ in range(300):
        damaged = bytearray(content)
        for _ in range(chance.choice([1, 2, 4])):
            damaged[chance.randrange(min(len(damaged), 200))] = chance.choice([0, 255, chance.randrange(256)])
        try:
            image = decode_image(bytes(damaged))
        except DataError:
            outcomes.add("refused")
        else:
            outcomes.add("survived")
            assert image.ndim == 3 and image.shape[2] == 3 and image.dtype == np.uint8 and image.size
    assert outcomes == {"refused", "survived"}


def test_a_parser_that_fails_in_its_own_way_is_a_data_error(monkeypatch):
    def transpose(image):
        raise struct.error("required argument is not an integer")  # what a damaged EXIF block has led to

    monkeypatch.setattr("PIL.ImageOps.exif_transpose", transpose)
    with pytest.raises(DataError, match="cannot be decoded: required argument"):
        decode_image(encoded(picture()))
