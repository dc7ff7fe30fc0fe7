import shutil

import numpy as np
import pytest

from vpr_bench.errors import DataError, UsageError, VprBenchError
from vpr_bench.maps.extend import extend_map
from vpr_bench.maps.fit import fit_map
from vpr_bench.maps.map import load_map
from vpr_bench.maps.references import of_dataset, of_folder
from vpr_bench.method.build import build_method


@pytest.fixture
def night(tiny_dataset):
    return of_dataset("tiny", "night_right")


def test_new_references_come_behind_the_others(tiny_map, night, place):
    before = tiny_map.record
    extended = extend_map(place, night)
    assert len(extended) == 24
    assert [part.traverse for part in extended.record.parts] == ["day_left", "night_right"]
    assert extended.record.fit_seconds > before.fit_seconds
    best = extended.locate(night.traverse[5], k=24).locations[0]
    assert (best.reference, best.file, best.place) == (17, "night_right/Image005.jpg", 5.0)
    assert load_map(place, verify=True).record == extended.record
    assert sorted(path.name for path in place.parent.iterdir()) == [".tiny.map.lock", "tiny.map"]


def test_images_of_a_folder_and_twice(tiny_map, night, place, tiny_images):
    extend_map(place, night)
    extended = extend_map(place, of_folder(tiny_images / "day_right"))
    assert len(extended) == 36
    assert extended.locate(tiny_images / "day_right" / "Image001.jpg").locations[0].file == "Image001.jpg"


def test_the_map_can_be_left_as_it_is(tiny_map, night, place):
    other = place.with_name("larger.map")
    extend_map(place, night, other)
    assert (len(load_map(place)), len(load_map(other))) == (12, 24)
    with pytest.raises(UsageError, match=r"larger.map is there. --overwrite puts"):
        extend_map(place, night, other)
    extend_map(place, night, other, overwrite=True)


def test_what_is_in_it_already_is_not_added(tiny_map, place):
    with pytest.raises(UsageError, match=r"tiny/day_left is part of .* already"):
        extend_map(place, of_dataset("tiny", "day_left"))


def test_an_interruption_leaves_the_map_as_it_was(tiny_map, night, place, colours):
    colours.fail_after.append(RuntimeError("no"))
    with pytest.raises(VprBenchError, match="failed while fitting: RuntimeError: no"):
        extend_map(place, night)
    assert load_map(place, verify=True).record == tiny_map.record
    assert len(extend_map(place, night)) == 24
    assert colours.done == [12, 12]  # described once each


def test_methods_that_cannot(tiny_dataset, colours, night, place):
    fit_map(build_method("hog", {"width": 64, "height": 64}), of_dataset("tiny"), place)
    with pytest.raises(UsageError, match=r"'hog' cannot add references to this map: it has no extend"):
        extend_map(place, night)
    assert len(load_map(place)) == 12


def test_a_wrapper_around_one_that_cannot(tiny_map, night, place, colours, monkeypatch):
    def refuse(self, references):
        raise NotImplementedError("all of it would be trained again")

    monkeypatch.setattr(colours.Colours, "extend", refuse)
    with pytest.raises(
        UsageError, match=r"cannot add references to this map: all of it would be trained again. Fit a map"
    ):
        extend_map(place, night)
    assert sorted(path.name for path in place.parent.iterdir()) == [".tiny.map.lock", "tiny.map"]


def test_nothing_is_made_beside_a_map_that_is_not_there(night, place):
    with pytest.raises(DataError, match="There is no map"):
        extend_map(place, night)
    assert list(place.parent.iterdir()) == []


def test_a_damaged_map_is_not_extended(tiny_map, night, place):
    np.save(place / "state" / "map.npy", np.zeros(3))
    with pytest.raises(DataError, match="is damaged"):
        extend_map(place, night)


def test_an_image_that_cannot_be_read(tiny_map, tiny_images, place, tmp_path):
    folder = tmp_path / "photos"
    shutil.copytree(tiny_images / "day_right", folder)
    (folder / "Image004.jpg").write_bytes(b"")
    with pytest.raises(DataError, match=r"Image004.jpg is empty"):
        extend_map(place, of_folder(folder))
    assert len(load_map(place, verify=True)) == 12
