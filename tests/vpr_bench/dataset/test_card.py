import copy

import pytest
from pydantic import ValidationError

from vpr_bench.dataset.card import DATASETS, Card, expand_groups, find_card
from vpr_bench.errors import DataError, UsageError

CARD = """
id = "tiny"
name = "Tiny"
summary = "Textures."
citation = "none"
licence = "CC0"
homepage = "https://example.org"
unit = "f"
loader = { layout = "numbered", options = { pattern = "{index}.png" } }
traverses = [{ name = "a", images = 3 }, { name = "b", images = 4, folder = "b/left" }]

[[protocols]]
references = "a"
queries = "b"
radius = 2

[[protocols]]
references = "b"
queries = "a"
radius = 0.5
unmatched = "reject"
"""


@pytest.fixture
def read(tmp_path):
    """Return a reader of cards from text."""

    def read(text):
        file = tmp_path / "tiny.toml"
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        return Card.from_toml(file)

    return read


def test_a_card_is_read_from_toml(read):
    card = read(CARD)
    assert card.id == "tiny" and card.loader.options == {"pattern": "{index}.png"}
    assert [(one.name, one.images, one.path) for one in card.traverses] == [("a", 3, "a"), ("b", 4, "b/left")]
    assert card.traverse("b").images == 4
    assert (card.download, card.simulation, card.published, card.folders) == (None, None, [], [])


def test_the_first_protocol_is_the_default_one(read):
    card = read(CARD)
    assert str(card.protocol()) == str(card.protocol("a-b")) == "tiny/a-b@2f"
    assert str(card.protocol("b-a", "simulated")) == "tiny:simulated/b-a@0.5f~reject"


def test_an_unknown_protocol_suggests_the_closest(read):
    with pytest.raises(UsageError, match=r"'tiny' has no protocol 'a-bb'. Did you mean 'a-b\'\?"):
        read(CARD).protocol("a-bb")


def test_a_card_is_frozen_and_survives_json(read):
    card = read(CARD)
    assert Card.model_validate_json(card.model_dump_json()) == card == copy.deepcopy(card)
    with pytest.raises(ValidationError, match="frozen"):
        card.id = "other"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('name = "Tiny"', 'name = "Tiny"\nnmae = "x"', "nmae: Extra inputs are not permitted"),
        ("images = 3", "images = 3, imags = 3", r"traverses.0.imags: Extra inputs"),
        ('references = "a"', 'references = "aa"', "there is no traverse 'aa'. Did you mean 'a'"),
        ('queries = "b"', 'queries = "b+c"', "there is no traverse 'c'"),
        ('name = "Tiny"', "", "name: Field required"),
        ('id = "tiny"', 'id = "Tiny set"', "id: String should match"),
        ('unit = "f"', 'unit = "km"', "unit: "),
        ("images = 3", "images = 0", "images: Input should be greater than 0"),
        ("images = 3", 'images = 3, digest = "md5:12"', "digest: String should match"),
        ("radius = 2", "radius = -1", "radius: Input should be greater"),
        ("radius = 2", "radius = nan", "radius: "),
        ('unmatched = "reject"', 'unmatched = "maybe"', "unmatched: "),
        ('unit = "f"', 'unit = "f"\ndownload = { url = "ftp://x/y.zip" }', "download.url: String should match"),
        ('unit = "f"', "unit = ", "cannot be read: Invalid value"),
        ('unit = "f"', 'unit = "f"\nunit = "f"', "cannot be read: Cannot overwrite a value"),
    ],
)
def test_a_wrong_card_is_a_data_error_that_names_the_first_wrong_field(read, old, new, message):
    assert old in CARD
    with pytest.raises(DataError, match=message) as caught:
        read(CARD.replace(old, new, 1))
    assert "tiny.toml" in str(caught.value)
    assert str(caught.value).count("\n") <= 1


def test_a_card_without_protocols_is_a_data_error(read):
    with pytest.raises(DataError, match="protocols"):
        read(CARD.partition("[[protocols]]")[0])


def test_a_card_that_cannot_be_read_is_a_data_error(read, tmp_path):
    with pytest.raises(DataError, match="cannot be read"):
        read(b"\xff\xfe\x00")
    with pytest.raises(DataError, match=r"missing\.toml cannot be read"):
        Card.from_toml(tmp_path / "missing.toml")


EDITIONS = """
[[editions]]
name = "small"
folders = ["tiny-small"]
traverses = [{ name = "a", images = 2 }, { name = "c" }]
protocols = [{ references = "a", queries = "c", radius = 5, unit = "nearest" }]

[simulation]
renderer = "somewhere:Renderer"
options = {}
loader = { layout = "folders" }
"""


def test_an_edition_replaces_what_it_names_and_keeps_the_rest(read):
    card = read(CARD.replace("images = 3", f'images = 3, digest = "sha256:{"0" * 64}"') + EDITIONS)
    assert card.edition_names() == ["real", "small", "simulated"]
    small, simulated = card.in_edition("small"), card.in_edition("simulated")
    assert str(small.protocol(edition="small")) == "tiny:small/a-c@5nearest"
    assert small.loader == card.loader and simulated.loader.layout == "folders"
    assert [one.name for one in simulated.traverses] == ["a", "b"]
    assert card.traverse("a").digest and not simulated.traverse("a").digest
    assert card.in_edition("real") is card
    with pytest.raises(UsageError, match=r"has no edition 'smal'\. Did you mean 'small'"):
        card.in_edition("smal")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('name = "small"', 'name = "simulated"', "two editions have the same name"),
        ('name = "small"', 'name = "auto"', "two editions have the same name"),
        ('queries = "c"', 'queries = "b"', "there is no traverse 'b'"),
        ("radius = 5", "radius = 0", "nearest references must be whole"),
        ('unit = "nearest"', 'unit = "given"', "has no radius"),
        ('radius = 5, unit = "nearest"', 'unit = "given"', r"a-c is @given, but \[\[given\]\] does not list it"),
    ],
)
def test_a_wrong_edition_is_a_data_error(read, old, new, message):
    with pytest.raises(DataError, match=message):
        read(CARD + EDITIONS.replace(old, new, 1))


def test_one_pairing_may_have_several_reaches(read):
    card = read(CARD + '[[protocols]]\nreferences = "a"\nqueries = "b"\nradius = 5\nunit = "nearest"\n')
    assert str(card.protocol("a-b")) == "tiny/a-b@2f"
    assert str(card.protocol("a-b@5nearest")) == "tiny/a-b@5nearest"
    assert str(card.protocol("b-a@7f")) == "tiny/b-a@7f~reject"
    with pytest.raises(UsageError, match="is in 'm', but tiny is measured in f or nearest"):
        card.protocol("a-b@7m")
    with pytest.raises(DataError, match="two traverses or two protocols have the same name"):
        read(CARD + '[[protocols]]\nreferences = "a"\nqueries = "b"\nradius = 2\n')


def test_a_group_stands_for_its_datasets():
    assert {"gardens", "nordland"} <= set(expand_groups(["thesis"]))
    assert expand_groups(["gardens", "gardens:simulated", "./here", "gardens"]) == [
        "gardens",
        "gardens:simulated",
        "./here",
    ]
    assert "gardens:simulated" in expand_groups(["thesis:simulated"])


@pytest.mark.parametrize(("name", "near"), [("berlim", "berlin"), ("gardn:real", "gardens"), ("thesi", "thesis")])
def test_a_misspelt_name_is_compared_with_datasets_and_groups(name, near):
    with pytest.raises(UsageError, match=f"no dataset and no group .* Did you mean '{near}'"):
        expand_groups([name])


def test_a_folder_is_no_misspelt_group(tmp_path, monkeypatch):
    (tmp_path / "walks").mkdir()
    monkeypatch.chdir(tmp_path)
    assert expand_groups(["walks"]) == ["walks"]


def test_a_dataset_is_found_by_its_id(tiny_dataset):
    assert find_card("tiny") is tiny_dataset.card
    assert DATASETS.load_all()["tiny"] is tiny_dataset.card


def test_an_unknown_dataset_suggests_the_closest():
    with pytest.raises(UsageError, match=r"There is no dataset 'garden'. Did you mean 'gardens\'\?"):
        find_card("garden")


def test_a_plug_in_that_is_no_card_is_refused():
    with pytest.raises(UsageError, match=r"must be a vpr_bench.dataset.card.Card. Got float instead"):
        find_card("math:pi")
