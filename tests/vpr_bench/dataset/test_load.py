import shutil
import warnings
from dataclasses import replace

import numpy as np
import pytest

from vpr_bench.dataset.card import Card, find_card
from vpr_bench.dataset.content import traverse_digest
from vpr_bench.dataset.layout import find_layout
from vpr_bench.dataset.load import DatasetWarning, load_case, load_from, load_traverse
from vpr_bench.dataset.request import Request
from vpr_bench.errors import DataError, UsageError
from vpr_bench.types.ground_truth import GroundTruth

REAL = "tiny/day_left-day_right@1f"


@pytest.fixture(autouse=True)
def _strict():
    """Fail on any warning that a test does not expect."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def change_a_byte(path):
    content = bytearray(path.read_bytes())
    content[-3] ^= 1
    path.write_bytes(content)


def test_the_first_protocol_of_the_real_images_is_the_default(tiny_dataset):
    case = load_case("tiny")
    assert str(case.protocol) == REAL
    assert (case.references.name, case.queries.name) == ("day_left", "day_right")
    assert len(case.references) == len(case.queries) == 12 and case.references[0].shape == (48, 64, 3)
    assert case.places.references.tolist() == case.places.queries.tolist() == list(range(12))
    assert case.places.references.dtype == np.float64
    assert case.folder == tiny_dataset.folder and case.digest.startswith("sha256:")


def test_the_ground_truth_is_that_of_the_protocols_radius(tiny_dataset):
    pairs = {radius: load_case("tiny", radius=radius).ground_truth for radius in (0, 2)}
    assert list(pairs[0][5]) == [5] and list(pairs[2][5]) == [3, 4, 5, 6, 7]


@pytest.mark.parametrize(
    ("arguments", "protocol"),
    [
        (("tiny", "day_left-night_right"), "tiny/day_left-night_right@1f~miss"),
        (("tiny/day_left-night_right",), "tiny/day_left-night_right@1f~miss"),
        (("tiny/day_left-night_right", "day_left-night_right", "real"), "tiny/day_left-night_right@1f~miss"),
        (("tiny/day_left-night_right@2f",), "tiny/day_left-night_right@2f"),
        (("tiny/day_left-night_right@2f~reject",), "tiny/day_left-night_right@2f~reject"),
        (("tiny:simulated",), "tiny:simulated/day_left-day_right@1f"),
        (("tiny", None, "simulated"), "tiny:simulated/day_left-day_right@1f"),
        (("tiny:simulated", None, "simulated"), "tiny:simulated/day_left-day_right@1f"),
        (("tiny:simulated/day_left-day_right@0.5f",), "tiny:simulated/day_left-day_right@0.5f"),
        (("tiny:real/day_left-day_right",), REAL),
        (("tiny:auto",), REAL),
        (("tiny", None, "auto", 3), "tiny/day_left-day_right@3f"),
        (("tiny", None, "auto", 0), "tiny/day_left-day_right@0f"),
        (("tiny/day_left-day_right@2f", None, "auto", 3), "tiny/day_left-day_right@3f"),
        (("tiny", None, "auto", None, "reject"), "tiny/day_left-day_right@1f~reject"),
        (("tiny/day_left-night_right", None, "auto", None, "exclude"), "tiny/day_left-night_right@1f"),
    ],
)
def test_a_protocol_can_be_asked_for_in_many_ways(tiny_dataset, arguments, protocol):
    assert str(load_case(*arguments).protocol) == protocol


def test_every_id_loads_what_it_names(tiny_dataset):
    for arguments in (("tiny",), ("tiny:simulated", "day_left-night_right", "auto", 2.5, "reject")):
        case = load_case(*arguments)
        again = load_case(str(case.protocol))
        assert again.protocol == case.protocol and again.digest == case.digest


def test_the_id_of_a_real_protocol_never_loads_simulated_images(tiny_dataset):
    tiny_dataset.without_images()
    assert load_case("tiny/day_left-day_right").protocol.edition == "simulated"
    with pytest.raises(DataError, match="The real images of tiny are not under"):
        load_case(REAL)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("tiny:real", None, "simulated"), "'tiny:real' names the edition 'real', but --edition says 'simulated'"),
        ((REAL, None, "simulated"), "names the edition 'real', but --edition says 'simulated'"),
        (("tiny:simulated/day_left-day_right@1f", None, "real"), "but --edition says 'real'"),
        (("tiny/day_left-day_right", "day_left-night_right"), "names the protocol 'day_left-day_right', but"),
        (("tiny/day_left-day_right@1m",), "is in 'm', but tiny is measured in f or nearest"),
        (("tiny/day_left-day_right@pair",), "is in 'pair', but tiny is measured in f or nearest"),
        (("tinny",), "There is no dataset 'tinny'. Did you mean 'tiny'"),
        (("tiny", "day_left-day_rigt"), "no protocol 'day_left-day_rigt'. Did you mean 'day_left-day_right'"),
        (("tiny/",), "no protocol ''"),
        (("tiny:",), "Got '' instead"),
        (("tiny:synthetic",), "must be one of auto, real, simulated. Got 'synthetic'"),
        (("tiny", None, "synthetic"), "Got 'synthetic' instead"),
        (("tiny/day_left@1f",), "is not a protocol id"),
        (("tiny", None, "auto", None, "maybe"), "Got 'maybe' instead"),
    ],
)
def test_what_contradicts_itself_or_does_not_exist_is_refused(tiny_dataset, arguments, message):
    with pytest.raises(UsageError, match=message):
        load_case(*arguments)


@pytest.mark.parametrize("radius", [-1, float("nan"), float("inf")])
def test_a_radius_that_is_none_is_refused_before_anything_is_rendered(tiny_dataset, radius):
    with pytest.raises(UsageError, match="radius must be a number of at least 0"):
        load_case("tiny", edition="simulated", radius=radius)
    assert tiny_dataset.rendered == []


@pytest.mark.parametrize("radius", [11, 11.5, 1e9])
def test_a_radius_that_reaches_over_the_map_is_refused(tiny_dataset, radius):
    with pytest.raises(UsageError, match=r"reaches over the whole map \(11f from end to end\)"):
        load_case("tiny", radius=radius)


def test_a_radius_a_little_smaller_than_the_map_is_taken(tiny_dataset):
    assert load_case("tiny", radius=10.9).protocol.radius == 10.9


def test_another_radius_can_be_checked(tiny_dataset):
    case = load_case("tiny")
    case.places.check(case.protocol.with_radius(10))
    with pytest.raises(UsageError, match="Give a smaller one"):
        case.places.check(case.protocol.with_radius(11))


def test_the_digest_says_which_images_and_labels_it_was(tiny_dataset):
    first = load_case("tiny", radius=1).digest
    assert load_case("tiny", radius=2).digest == first
    assert load_case("tiny", "day_left-night_right").digest != first
    change_a_byte(tiny_dataset.folder / "day_right" / "Image007.jpg")
    with pytest.warns(DatasetWarning):
        assert load_case("tiny").digest != first


def test_another_copy_is_used_with_a_warning(tiny_dataset):
    change_a_byte(tiny_dataset.folder / "day_left" / "Image007.jpg")
    with pytest.warns(DatasetWarning, match="day_left is not the copy.*`vpr-bench data verify tiny`") as warned:
        case = load_case("tiny")
    assert len(warned) == 1 and len(case.references) == 12


def test_the_simulated_edition_is_not_held_against_the_real_digests(tiny_dataset):
    assert all(one.digest for one in tiny_dataset.card.traverses)
    assert not any(one.digest for one in tiny_dataset.card.in_edition("simulated").traverses)
    load_case("tiny:simulated")  # which are the same files, and would be warned of if they were another copy
    change_a_byte(load_case("tiny:simulated").folder / "day_left" / "Image007.jpg")
    load_case("tiny:simulated")


def test_an_image_that_is_missing_is_a_data_error_that_names_it(tiny_dataset):
    (tiny_dataset.folder / "day_right" / "Image011.jpg").unlink()
    with pytest.raises(DataError, match=r"day_right.*found 11, Image011\.jpg is missing"):
        load_case("tiny")


def test_images_in_any_folder_can_be_loaded(tiny_dataset, tmp_path):
    folder = shutil.copytree(tiny_dataset.folder, tmp_path / "mine")
    case = load_from(tiny_dataset.card, tiny_dataset.card.protocol(), folder)
    assert case.references.sources[0] == folder / "day_left" / "Image000.jpg"
    assert case.digest == load_case("tiny").digest


def test_a_map_may_join_traverses_and_take_parts_of_them(tiny_dataset):
    case = load_case("tiny", "day_left.every5+day_right-night_right.first4")
    assert str(case.protocol) == "tiny/day_left.every5+day_right-night_right.first4@1f"
    assert case.places.references.tolist() == [0, 5, 10, *range(12)]
    assert case.places.queries.tolist() == [0, 1, 2, 3]
    assert [part.name for part in case.references.split()] == ["day_left", "day_right"]
    assert [path.parent.name for path in case.references.sources[2:4]] == ["day_left", "day_right"]
    assert case.ground_truth[0].tolist() == [0, 3, 4]  # the same place of either walk
    assert case.digest != load_case("tiny", "day_left+day_right-night_right.first4").digest


def test_a_pairing_that_the_card_does_not_name_has_the_reach_of_its_first(tiny_dataset):
    assert str(load_case("tiny", "night_right-day_left").protocol) == "tiny/night_right-day_left@1f"
    assert str(load_case("tiny", "night_right-day_left@3nearest").protocol) == "tiny/night_right-day_left@3nearest"
    assert str(load_case("tiny/day_left-night_right@4nearest").protocol) == "tiny/day_left-night_right@4nearest"


def test_what_the_dataset_lists_is_cut_with_its_traverses(tiny_dataset, monkeypatch):
    def given(folder, references, queries, shift):
        places = range(len(references))
        hard = [[place + shift] if place + shift < len(references) else [] for place in places]
        return GroundTruth.from_lists(hard, len(references)).with_soft(
            GroundTruth.from_lists([[i] for i in places], 12)
        )

    layout = replace(find_layout("numbered"), given=given)
    monkeypatch.setattr("vpr_bench.dataset.load.find_layout", lambda name: layout)
    listed = [{"references": "day_left", "queries": "day_right", "options": {"shift": 2}}]
    card = Card.model_validate(tiny_dataset.card.model_dump() | {"given": listed})
    case = load_from(card, card.protocol("day_left.first8-day_right.every5@given"), tiny_dataset.folder)
    assert [case.ground_truth[query].tolist() for query in range(3)] == [[2], [7], []]
    assert [case.ground_truth.soft[query].tolist() for query in range(3)] == [[0], [5], []]
    by_number = load_from(card, card.protocol("day_left.first8-day_right.every5@1f"), tiny_dataset.folder)
    assert by_number.digest == case.digest  # one run serves both


def test_a_request_is_read_without_looking_anything_up():
    whole = Request.parse("nowhere:old/a-b@2.5m~miss")
    assert whole == Request("nowhere", "a-b@2.5m", "old", "miss")
    assert Request.parse("nowhere") == Request("nowhere", None, "auto")


def test_the_real_images_are_the_ones_that_the_card_knows(real_gardens):
    card = find_card("gardens")
    for one in card.traverses:
        traverse = load_traverse(card, one, real_gardens).traverse
        assert len(traverse) == 200
        assert traverse_digest(traverse, afresh=True) == one.digest
        assert traverse[0].shape == traverse[199].shape
        assert traverse[0].shape == ((360, 640, 3) if one.name == "night_right" else (540, 960, 3))


def test_the_real_gardens_are_the_default_where_they_are(real_gardens):
    case = load_case("gardens")
    assert str(case.protocol) == "gardens/day_left-night_right@2f"
    assert case.ground_truth.n_queries == 200 and case.ground_truth.has_match.all()
