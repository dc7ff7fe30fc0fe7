import pytest

from vpr_bench.dataset.card import find_card
from vpr_bench.errors import DataError
from vpr_datasets.simulation.edition import SimulatedEdition

OPTIONS = {
    "seed": 1,
    "frames": 2,
    "width": 96,
    "height": 64,
    "traverses": [{"name": "walk", "light": "day", "seed": 1}],
}


def test_renders_the_layout(tmp_path):
    SimulatedEdition(OPTIONS).render(tmp_path)
    assert sorted(str(file.relative_to(tmp_path)) for file in tmp_path.rglob("*.jpg")) == [
        "walk/Image000.jpg",
        "walk/Image001.jpg",
    ]


def test_fingerprint_changes_with_the_description():
    assert SimulatedEdition(OPTIONS).fingerprint() == SimulatedEdition(dict(OPTIONS)).fingerprint()
    assert SimulatedEdition(OPTIONS).fingerprint() != SimulatedEdition({**OPTIONS, "seed": 2}).fingerprint()


@pytest.mark.parametrize("change", [{"pattern": "{traverse}/{number}.png"}, {"first": 1}, {"beside": ["fgps"]}])
def test_fingerprint_changes_with_the_files(change):
    assert SimulatedEdition(OPTIONS).fingerprint() != SimulatedEdition({**OPTIONS, **change}).fingerprint()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"frames": 0}, "frames"),
        ({"pattern": "one.jpg"}, "pattern"),
        ({"beside": ["tea leaves"]}, "beside: 'tea leaves' is none of fgps,"),
        ({"bayer": "RGGB"}, "pattern: raw pictures are stored as .png only"),
        ({"sede": 1}, "sede"),
    ],
)
def test_bad_description_names_the_field(change, words):
    with pytest.raises(DataError, match=words):
        SimulatedEdition({**OPTIONS, **change})


def test_writes_what_is_beside_the_images(tmp_path):
    SimulatedEdition({**OPTIONS, "beside": ["fgps"]}).render(tmp_path)
    assert len((tmp_path / "walk/fGPS.txt").read_text().splitlines()) == OPTIONS["frames"]


def test_gardens_is_described_as_the_real_one_is():
    card = find_card("gardens")
    spec = SimulatedEdition(card.simulation.options).spec
    assert [one.name for one in spec.traverses] == [one.name for one in card.traverses]
    assert {one.images for one in card.traverses} == {spec.frames}
