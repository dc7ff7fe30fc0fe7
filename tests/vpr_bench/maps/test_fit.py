import json
import shutil
import threading

import numpy as np
import pytest

from vpr_bench.errors import DataError, UsageError, VprBenchError
from vpr_bench.maps.fit import find_map, fit_map
from vpr_bench.maps.map import load_map
from vpr_bench.maps.references import of_dataset, of_folder
from vpr_bench.method.build import build_method


@pytest.fixture
def references(tiny_dataset, colours):
    return of_dataset("tiny")


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_a_map_is_a_record_and_a_state(tiny_map, place, colours):
    assert names(place) == ["map.json", "state"]
    assert names(place.parent) == [".tiny.map.lock", "tiny.map"]
    record = json.loads((place / "map.json").read_text())
    assert record["method"]["id"] == "colours"
    assert record["method"]["parameters"] == {"cells": 4, "seed": 0}
    (part,) = record["parts"]
    assert part["names"][3] == "day_left/Image003.jpg"
    assert part["places"] == [float(number) for number in range(12)]
    assert (part["dataset"], part["edition"], part["traverse"]) == ("tiny", "real", "day_left")
    assert list(record["files"]) == ["map.npy"]
    assert record["fit_seconds"] > 0
    assert record["machine"]["threads"] == 1
    assert colours.done == [12]


def test_the_same_map_is_not_fitted_again(tiny_map, references, place, colours):
    before = (place / "map.json").read_bytes()
    again = fit_map(build_method("colours"), references, place)
    assert again.record == tiny_map.record
    assert (place / "map.json").read_bytes() == before
    assert colours.done == [12]
    fit_map(build_method("colours"), references, place, overwrite=True)
    assert colours.done == [12, 12]


def test_another_map_is_not_replaced_unless_told(tiny_map, references, place):
    other = build_method("colours", {"cells": 2})
    for built, images in ((other, references), (build_method("colours"), of_dataset("tiny", "day_right"))):
        with pytest.raises(UsageError, match=r"is another map: colours on tiny/day_left. --overwrite puts"):
            fit_map(built, images, place)
    assert load_map(place).record == tiny_map.record
    assert fit_map(other, references, place, overwrite=True).record.method.parameters["cells"] == 2
    assert names(place.parent) == [".tiny.map.lock", "tiny.map"]


def test_what_is_no_map_is_left_alone(references, place):
    place.mkdir()
    (place / "thesis.tex").write_text("years of work")
    for overwrite in (False, True):
        with pytest.raises(UsageError, match="is not a map: it is left alone"):
            fit_map(build_method("colours"), references, place, overwrite=overwrite)
    assert names(place) == ["thesis.tex"]
    file = place.with_name("file")
    file.write_text("a file")
    with pytest.raises(UsageError, match="is not a map"):
        fit_map(build_method("colours"), references, file, overwrite=True)
    with pytest.raises(UsageError, match="needs a name"):
        fit_map(build_method("colours"), references, place.parent / "..")


def test_an_empty_folder_is_a_free_place(references, place):
    place.mkdir()
    assert find_map(build_method("colours"), references, place) is None
    assert len(fit_map(build_method("colours"), references, place)) == 12


def test_a_damaged_map_is_replaced_only_if_told(tiny_map, references, place):
    (place / "state" / "map.npy").write_bytes(b"half")
    with pytest.raises(DataError, match="--overwrite replaces it"):
        fit_map(build_method("colours"), references, place)
    fit_map(build_method("colours"), references, place, overwrite=True)
    assert len(load_map(place, verify=True)) == 12


@pytest.mark.parametrize("error", [KeyboardInterrupt, RuntimeError("no")])
def test_an_interrupted_fit_goes_on(references, place, colours, error):
    colours.fail_after.append(error)
    with pytest.raises((KeyboardInterrupt, VprBenchError)):
        fit_map(build_method("colours"), references, place)
    assert names(place.parent) == [".tiny.map.lock", "tiny.map.partial"]
    with pytest.raises(DataError, match="is unfinished"):
        load_map(place)
    fit_map(build_method("colours"), references, place)
    assert colours.done == [12]  # described once
    assert names(place.parent) == [".tiny.map.lock", "tiny.map"]


def test_another_fit_does_not_go_on_from_there(references, place, colours):
    colours.fail_after.append(KeyboardInterrupt)
    with pytest.raises(KeyboardInterrupt):
        fit_map(build_method("colours"), references, place)
    fit_map(build_method("colours", {"cells": 2}), references, place)
    assert colours.done == [12, 12]


def test_killed_while_an_older_map_is_replaced(tiny_map, references, place):
    place.replace(place.with_name("tiny.map.former"))
    fit_map(build_method("colours", {"cells": 2}), of_dataset("tiny"), place, overwrite=True)
    assert names(place.parent) == [".tiny.map.lock", "tiny.map"]


def test_somebody_elses_folders_beside_it_are_left_alone(references, place):
    former, partial = (place.with_name(f"tiny.map.{what}") for what in ("former", "partial"))
    for folder in (former, partial):
        folder.mkdir()
        (folder / "thesis.tex").write_text("years of work")
    fit_map(build_method("colours"), references, place)
    assert (former / "thesis.tex").exists()
    assert (place / "thesis.tex").exists()


def test_methods_that_cannot_save(references, place, colours):
    with pytest.raises(UsageError, match=r"'forgetful' cannot be kept on disk: it has no save\(folder\)"):
        fit_map(build_method("forgetful"), references, place)
    with pytest.raises(UsageError, match="a method inside it has no save and load"):
        fit_map(build_method("seqslam", {"inner": "forgetful"}), references, place)
    assert names(place.parent) == [".tiny.map.lock"]


@pytest.mark.parametrize("name", ["hog", "sad", "sift", "seqslam", "hmm"])
def test_methods_that_can(references, place, name):
    parameters = {"inner": "colours"} if name in ("seqslam", "hmm") else {}
    fitted = fit_map(build_method(name, parameters), references, place)
    answer = load_map(place).locate(references.traverse[4], k=3)
    assert len(fitted) == 12
    assert answer.locations[0].reference == 4


def test_two_processes_do_not_make_the_same_map_twice(references, place, colours):
    threads = [threading.Thread(target=fit_map, args=(build_method("colours"), references, place)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert colours.done == [12]


def test_images_of_a_folder(tiny_images, colours, place):
    fitted = fit_map(build_method("colours"), of_folder(tiny_images / "day_left"), place)
    (part,) = fitted.record.parts
    assert part.dataset is None
    assert part.places is None
    assert part.names[2] == "Image002.jpg"
    location = fitted.locate(tiny_images / "day_right" / "Image005.jpg").locations[0]
    assert (location.file, location.place) == ("Image005.jpg", None)


def test_an_image_that_cannot_be_read_stops_the_fit(tiny_dataset, colours, place):
    folder = tiny_dataset.folder / "day_left"
    (folder / "Image003.jpg").write_bytes(b"no image")
    with pytest.raises(DataError, match=r"Image003.jpg is not an image"):
        fit_map(build_method("colours"), of_folder(folder), place)
    shutil.copy(folder / "Image004.jpg", folder / "Image003.jpg")
    assert len(fit_map(build_method("colours"), of_folder(folder), place)) == 12


def test_positions_are_kept(tiny_map, place, edit):
    edit(lambda content: content["parts"][0].update(places=[[1.5, number] for number in range(12)]))
    answer = load_map(place).locate(np.zeros((8, 8, 3), np.uint8), k=1)
    assert answer.locations[0].place == (1.5, answer.locations[0].reference)
