import numpy as np
import pytest
from PIL import Image, ImageColor

from vpr_bench.dataset.load import Case
from vpr_bench.errors import DataError
from vpr_bench.report.contact_sheet import WIDTH, draw_contact_sheet
from vpr_bench.report.ink import AMBER, GREEN, GREY, RED, cut, fitted, font
from vpr_bench.report.sheet_columns import choose_columns, choose_queries
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol
from vpr_bench.types.traverse import Traverse

WALK = np.arange(12.0)


def picture(width=48, height=32, shade=120):
    return np.full((height, width, 3), shade, dtype=np.uint8)


def case(protocol="walk/day-night@2f", queries=WALK, references=WALK, given=None, images=None, convert=None):
    """A case whose images are in memory."""
    one = Protocol.parse(protocol)
    counts = (given.n_queries, given.n_references) if given else (len(queries), len(references))
    night, day = (
        Traverse(name, images or [picture()] * n, convert) for name, n in zip(["night", "day"], counts, strict=True)
    )
    return Case(one, day, night, Places(queries, references, given), "sha256:" + "0" * 64, None)


def pixels(file, colour):
    with Image.open(file) as image:
        return int((np.asarray(image) == ImageColor.getrgb(colour)).all(axis=-1).sum())


def test_is_a_png_of_one_width(tmp_path):
    file = draw_contact_sheet(case(), tmp_path / "sheet.png")
    assert file == tmp_path / "sheet.png"
    with Image.open(file) as image:
        assert image.format == "PNG"
        assert image.width == WIDTH
    assert pixels(file, GREEN) > 2000  # frames around the matches
    assert pixels(file, AMBER) == pixels(file, RED) == 0


def test_same_case_same_bytes_another_seed_others(tmp_path):
    first = draw_contact_sheet(case(), tmp_path / "1.png").read_bytes()
    assert draw_contact_sheet(case(), tmp_path / "2.png").read_bytes() == first
    assert draw_contact_sheet(case(), tmp_path / "3.png", count=5, seed=1).read_bytes() != first


def test_only_what_is_shown_is_decoded(tmp_path):
    decoded = []

    def convert(image):
        decoded.append(image)
        return image

    labels = np.arange(500.0)
    draw_contact_sheet(case(queries=labels, references=labels, convert=convert), tmp_path / "sheet.png", count=4)
    assert len(decoded) == 4 * (1 + 3)


def test_damaged_image_is_named_and_nothing_is_left(tmp_path):
    damaged = tmp_path / "Image007.jpg"
    damaged.write_bytes(b"\xff\xd8\xff")
    with pytest.raises(DataError, match=r"Image007\.jpg"):
        draw_contact_sheet(case(images=[damaged] * 12), tmp_path / "sheet.png")
    assert list(tmp_path.iterdir()) == [damaged]


def test_case_without_queries(tmp_path):
    with pytest.raises(DataError, match="no images to look at"):
        draw_contact_sheet(case(queries=WALK[:0]), tmp_path / "sheet.png")


def test_unwritable_folder(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(DataError, match="Cannot write"):
        draw_contact_sheet(case(), tmp_path / "file" / "sheet.png")


def test_simulated_images_are_marked(tmp_path):
    file = draw_contact_sheet(case("walk:simulated/day-night@2f"), tmp_path / "sheet.png")
    assert pixels(file, RED) > 2000


def test_soft_matches_have_a_frame_of_their_own(tmp_path):
    right = GroundTruth.from_radius(WALK, WALK, 0)
    given = right.with_soft(GroundTruth.from_radius(WALK, WALK, 2))
    file = draw_contact_sheet(case("walk/day-night@given", None, None, given), tmp_path / "sheet.png")
    assert pixels(file, AMBER) > 2000


def test_positions_get_a_map(tmp_path):
    positions = np.stack([500_000 + 10 * WALK, 4_000_000 + WALK**2], axis=1)
    plain = draw_contact_sheet(case("walk/day-night@15m", WALK * 10, WALK * 10), tmp_path / "plain.png")
    mapped = draw_contact_sheet(case("walk/day-night@15m", positions, positions), tmp_path / "map.png")
    with Image.open(plain) as one, Image.open(mapped) as other:
        assert other.height > one.height


@pytest.mark.parametrize(
    "images",
    [
        [picture(1, 1), picture(1, 700), picture(900, 1)],
        [picture(360, 640), picture(640, 360), picture(64, 32)],
        [picture(1500, 1000)],
    ],
    ids=["thin", "mixed", "large"],
)
def test_images_of_any_shape(tmp_path, images):
    chosen = (images * 12)[:12]
    draw_contact_sheet(case(images=chosen), tmp_path / "sheet.png", count=3)


def test_hostile_and_long_file_names(tmp_path):
    names = ["[red]\n\x1b[31m\u202egpj.jpg", "x" * 200 + ".png", "写真.png", "\u0301.png"]
    files = []
    for name in names:
        Image.fromarray(picture()).save(tmp_path / name, format="PNG")
        files.append(tmp_path / name)
    labels = np.arange(4.0)
    draw_contact_sheet(case(queries=labels, references=labels, images=files), tmp_path / "sheet.png")


def test_many_queries_stand_in_several_bands(tmp_path):
    few = draw_contact_sheet(case(), tmp_path / "few.png", count=8)
    many = draw_contact_sheet(case(), tmp_path / "many.png", count=12)
    with Image.open(few) as one, Image.open(many) as other:
        assert other.height > one.height + 100


# Which queries, and which references under each.


def test_queries_are_evenly_spaced():
    chosen = choose_queries(np.ones(1000, dtype=bool), count=8)
    assert set(np.diff(chosen)) == {125}


@pytest.mark.parametrize("without", [[7], range(5), range(1, 100), range(100)])
def test_some_of_both_kinds_are_shown(without):
    has_match = np.ones(100, dtype=bool)
    has_match[list(without)] = False
    shown = has_match[choose_queries(has_match, count=8)]
    assert len(shown) == 8
    assert not shown.all()
    assert shown.any() == has_match.any()


def test_no_more_queries_than_there_are():
    assert choose_queries(np.ones(3, dtype=bool), count=8).tolist() == [0, 1, 2]
    assert len(choose_queries(np.zeros(3, dtype=bool), count=1)) == 1


def test_nearest_match_first_farthest_last():
    (column,) = choose_columns(case("walk/day-night@3f", queries=np.array([6.0])))
    assert [(one.reference, one.distance) for one in column.shown] == [(6, 0.0), (4, 2.0), (9, 3.0)]
    assert column.more == 4


def test_middle_match_first_where_nothing_is_measured():
    given = GroundTruth.from_lists([[2, 3, 4, 5, 6]], 12)
    (column,) = choose_columns(case("walk/day-night@given", None, None, given))
    assert [one.reference for one in column.shown] == [4, 5, 6]
    assert column.more == 2


def test_nearest_reference_of_a_query_without_a_match():
    (column,) = choose_columns(case("walk/day-night@2f", queries=np.array([40.0])))
    assert [(one.kind, one.reference, one.distance) for one in column.shown] == [("miss", 11, 29.0)]


def test_nothing_to_compare_with_where_nothing_is_measured():
    given = GroundTruth.from_lists([[], [1]], 3)
    columns = choose_columns(case("walk/day-night@given", None, None, given))
    assert [column.shown[0].kind for column in columns] == ["none", "match"]


# Words and pictures.


def test_long_text_is_cut_in_the_middle():
    face = font(12)
    short = cut("a" * 50 + "." + "z" * 50, 100, face)
    assert face.getlength(short) <= 100
    assert short.startswith("aaa")
    assert short.endswith("zzz")
    assert "…" in short
    assert cut("short.jpg", 100, face) == "short.jpg"
    assert cut("\x1b\x07", 100, face) == "?"


def test_small_pictures_are_enlarged_sharply():
    checks = np.zeros((2, 4, 3), dtype=np.uint8)
    checks[::2, ::2] = checks[1::2, 1::2] = 255
    large = np.asarray(fitted(checks, (160, 160)))
    assert large.shape == (80, 160, 3)
    assert set(np.unique(large)) == {0, 255}


def test_grey_is_for_what_is_no_match(tmp_path):
    file = draw_contact_sheet(case(queries=WALK + 100), tmp_path / "sheet.png")
    assert pixels(file, GREY) > 2000
    assert pixels(file, GREEN) == 0
