import numpy as np
import pytest
from PIL import Image

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.describe_own import CARD_FILE, describe_own
from vpr_bench.dataset.load import load_case
from vpr_bench.errors import DataError
from vpr_datasets.layouts.folders import LAYOUT, load, recognise


def write(folder, **names):
    for name, images in names.items():
        (folder / name).mkdir(parents=True)
        for image in images:
            (folder / name / image).write_bytes(b"x")
    return folder


def frames(*numbers, pattern="img{}.jpg"):
    return [pattern.format(number) for number in numbers]


WALK = TraverseCard(name="walk")


def test_numbers_count_as_numbers(tmp_path):
    write(tmp_path, walk=frames(10, 9, 2, 1))
    read = load(tmp_path / "walk", WALK)
    assert [file.name for file in read.traverse.sources] == frames(1, 2, 9, 10)
    assert read.labels.tolist() == [0, 1, 2, 3] and read.traverse.name == "walk"


@pytest.mark.parametrize(("align", "labels"), [("order", [0, 1, 2]), ("number", [2, 3, 10]), ("stem", [2, 3, 10])])
def test_a_label_is_the_position_or_what_the_name_says(tmp_path, align, labels):
    write(tmp_path, walk=frames(2, 3, 10, pattern="{:04d}.png"))
    assert load(tmp_path / "walk", WALK, align=align).labels.tolist() == labels


@pytest.mark.parametrize("align", ["names", "", 3, None, ["order"]])
def test_other_alignments_are_refused(tmp_path, align):
    with pytest.raises(DataError, match="There is no alignment by"):
        load(write(tmp_path, walk=frames(1)) / "walk", WALK, align=align)


def test_missing_images_are_counted(tmp_path):
    write(tmp_path, walk=frames(1, 2), empty=[])
    with pytest.raises(DataError, match="must hold the 3 images of walk: found 2"):
        load(tmp_path / "walk", TraverseCard(name="walk", images=3))
    with pytest.raises(DataError, match="holds no images"):
        load(tmp_path / "empty", WALK)
    with pytest.raises(DataError, match="is missing"):
        load(tmp_path / "none", WALK)


def test_folders_of_one_length_are_aligned_by_order(tmp_path):
    write(tmp_path, day=frames(*range(8, 13)), night=frames(*range(95, 100), pattern="n_{}.png"))
    said = recognise(tmp_path)
    assert said.found == (
        "2 folders of images (day (5), night (5)), aligned by order: image i of every folder is the same place, "
        "its neighbours are 1 frame away"
    )
    case = load_case(str(tmp_path))
    assert str(case.protocol).endswith("/day-night@2f")
    assert [file.name for file in case.references.sources] == frames(8, 9, 10, 11, 12)
    assert case.ground_truth[0].tolist() == [0, 1, 2]


def test_every_folder_is_looked_up_in_the_map(tmp_path):
    write(tmp_path, **{name: frames(1, 2, 3, 4) for name in ("Dusk walk", "reference", "dawn (2)")})
    card = describe_own(tmp_path, "folders").card
    assert [one.pairing for one in card.listed_protocols()] == ["reference-dusk_walk", "reference-dawn_2"]
    assert [one.folder for one in card.traverses] == ["Dusk walk", "dawn (2)", "reference"]
    assert load_case(str(tmp_path)).ground_truth.n_queries == 4


def amstertime(folder):
    """Pairs by number with gaps; one new picture and one old one have no partner."""
    new, old = (1, 2, 5, 9, 10, 14), (2, 5, 9, 10, 14, 15)
    return write(folder, new=frames(*new, pattern="{:04d}.png"), old=frames(*old, pattern="{:04d}.jpg"))


def test_pairs_are_recognised_and_a_missing_partner_is_no_error(tmp_path):
    said = recognise(amstertime(tmp_path))
    assert said.unit == "pair" and "images of the same name are the same place, and no others are" in said.found
    case = load_case(str(tmp_path))
    assert str(case.protocol).endswith("/new-old@pair")
    assert [case.ground_truth[query].tolist() for query in range(6)] == [[1], [2], [3], [4], [5], []]


@pytest.mark.parametrize("align", ["number", "stem"])
def test_pairs_may_be_described_in_a_card(tmp_path, align):
    amstertime(tmp_path)
    (tmp_path / CARD_FILE).write_text(
        f"""
        id = "amstertime"
        name = "AmsterTime"
        summary = "Old and new"
        citation = "none"
        licence = "none"
        homepage = "https://example.org"
        unit = "pair"
        loader = {{ layout = "folders", options = {{ align = "{align}" }} }}
        traverses = [{{ name = "new", images = 6 }}, {{ name = "old", images = 6 }}]
        protocols = [{{ references = "new", queries = "old", unmatched = "reject" }}]
        """
    )
    case = load_case(str(tmp_path))
    assert str(case.protocol) == "amstertime/new-old@pair~reject"
    assert case.ground_truth.has_match.tolist() == [True] * 5 + [False]


def test_the_radius_is_never_the_whole_map(tmp_path):
    write(tmp_path, day=frames(1, 2, 3), night=frames(1, 2, 3))
    case = load_case(str(tmp_path))
    assert case.protocol.radius == 0 and np.diff(case.ground_truth.offsets).tolist() == [1, 1, 1]


def test_folders_that_differ_only_in_case_or_have_no_latin_letters_get_names(tmp_path):
    write(tmp_path, **{name: frames(1, 2, 3, 4) for name in ("Day", "day", "朝", "夜")})
    card = describe_own(tmp_path, "folders").card
    assert [one.name for one in card.traverses] == ["day", "day_2", "traverse", "traverse_2"]
    assert len(load_case(str(tmp_path), "day-traverse_2").queries) == 4


def test_what_says_nothing_is_not_recognised(tmp_path):
    assert recognise(tmp_path) is None and recognise(tmp_path / "none") is None
    write(tmp_path, day=frames(*range(10)), empty=[], **{".hidden": frames(*range(10))})
    assert recognise(tmp_path) is None
    write(tmp_path, night=frames(*range(7)))
    assert recognise(tmp_path) is None
    assert LAYOUT.rank == 10


def test_a_folder_that_no_card_can_name_is_passed_by(tmp_path):
    write(tmp_path, **{name: frames(1, 2, 3, 4) for name in ("day", "night", "walk 10:30", "a\\b")})
    assert "2 folders of images (day (4), night (4))" in recognise(tmp_path).found


def test_mosaics_become_colour_images(tmp_path):
    mosaic = np.zeros((8, 8), np.uint8)
    mosaic[::2, ::2] = 200  # red, where the pattern is RGGB
    Image.fromarray(mosaic).save(tmp_path / "0.png")
    red = load(tmp_path, TraverseCard(name="walk"), bayer="RGGB").traverse[0]
    assert red[2:6, 2:6].mean(axis=(0, 1)).tolist() == [200, 0, 0]
