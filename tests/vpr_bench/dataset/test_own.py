import shutil

import pytest

from vpr_bench.dataset.describe_own import CARD_FILE, describe_own, slug
from vpr_bench.dataset.layout import LAYOUTS
from vpr_bench.dataset.load import load_case
from vpr_bench.dataset.own import own_card
from vpr_bench.dataset.request import own_folder
from vpr_bench.errors import DataError, UsageError

CARD = """
id = "my-walk"
name = "My walk"
summary = "Twice round the block."
citation = "none"
licence = "mine"
homepage = "none"
unit = "f"
loader = { layout = "numbered", options = { pattern = "Image{index:03d}.jpg" } }
traverses = [{ name = "left", folder = "day_left" }, { name = "right", folder = "day_right" }]
protocols = [{ references = "left", queries = "right", radius = 1 }]
"""


@pytest.fixture
def own(tiny_images, tmp_path):
    """Return a folder with two traverses and no card."""
    folder = tmp_path / "My Walk (2024)"
    for name in ("day_left", "day_right"):
        shutil.copytree(tiny_images / name, folder / name)
    return folder


def test_a_card_beside_the_images_describes_them(own):
    (own / CARD_FILE).write_text(CARD)
    case = load_case(str(own))
    assert str(case.protocol) == "my-walk/left-right@1f"
    assert case.folder == own and len(case.references) == 12


def test_without_a_card_the_layout_is_recognised(own):
    case = load_case(str(own), radius=1)
    assert case.protocol.dataset == "my-walk-2024"
    assert case.ground_truth.has_match.all()


def test_a_layout_can_be_asked_for(own):
    with pytest.raises(UsageError, match="There is no layout 'numberd'"):
        describe_own(own, "numberd")
    with pytest.raises(UsageError, match="'numbered' recognises no folders"):
        describe_own(own, "numbered")


def test_a_folder_of_no_layout_says_what_there_is(tmp_path):
    (tmp_path / "notes.txt").write_text("nothing to see")
    with pytest.raises(DataError, match=f"(?s)is not recognised: it holds no images.*{LAYOUTS.entries()[0].name}"):
        own_card(tmp_path)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ('simulation = { renderer = "os:system", options = {} }', r"must not have a \[simulation\]"),
        ('download = { url = "https://example.org/x.zip" }', r"must not have .*\[download\]"),
        ('colour = "red"', "colour: Extra inputs are not permitted"),
        (
            '[[editions]]\nname = "b"\nfolders = ["b"]\nloader = { layout = "os:system" }',
            "no known layout: 'os:system'",
        ),
    ],
)
def test_a_card_beside_images_is_not_trusted(own, line, message):
    (own / CARD_FILE).write_text(CARD + line)
    with pytest.raises(DataError, match=message):
        own_card(own)


@pytest.mark.parametrize("layout", ["os:system", "vpr_datasets.layouts.numbered:LAYOUT", "numberd"])
def test_a_card_beside_images_names_installed_layouts_only(own, layout):
    (own / CARD_FILE).write_text(CARD.replace("numbered", layout))
    with pytest.raises(DataError, match="names no known layout"):
        own_card(own)


@pytest.mark.parametrize("folder", ["../day_left", "/etc", "a/../../b", "c:\\\\x"])
def test_a_card_does_not_lead_out_of_its_folder(own, folder):
    (own / CARD_FILE).write_text(CARD.replace("day_left", folder))
    with pytest.raises(DataError, match="leads out of the dataset's folder"):
        own_card(own)


def test_what_names_a_folder(own, tiny_dataset, monkeypatch):
    monkeypatch.chdir(own.parent)
    (own.parent / "tiny").mkdir()
    assert own_folder("./My Walk (2024)") == own_folder(str(own)) == own_folder("My Walk (2024)") == own
    for dataset in ("tiny", "tiny/day_left-day_right", "tiny:simulated", "gardens", "nowhere"):
        assert own_folder(dataset) is None
    for missing in ("./tiny2", "/nowhere/at/all", "~nobody/x"):
        with pytest.raises(DataError, match="There is no folder"):
            own_folder(missing)


@pytest.mark.parametrize(
    ("folder", "name"), [("Day Left (1)", "day_left_1"), ("__x__", "x"), ("100909_0845", "100909_0845"), ("été", "t")]
)
def test_names_of_folders_become_names_of_traverses(folder, name):
    assert slug(folder) == name
