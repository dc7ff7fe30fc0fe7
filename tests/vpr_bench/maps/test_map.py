import numpy as np
import pytest

from vpr_bench import load_map
from vpr_bench.errors import DataError, UsageError, VprBenchError
from vpr_bench.maps.answer import Photo
from vpr_bench.maps.fit import fit_map
from vpr_bench.maps.map import read_photo
from vpr_bench.maps.references import of_dataset
from vpr_bench.method.build import build_method
from vpr_bench.types.match import Match


def test_says_where_a_photo_was_taken(tiny_map, tiny_images, place):
    answer = load_map(place).locate(tiny_images / "day_right" / "Image007.jpg", k=3)
    assert [location.rank for location in answer.locations] == [1, 2, 3]
    best = answer.locations[0]
    assert (best.reference, best.file, best.place) == (7, "day_left/Image007.jpg", 7.0)
    assert np.diff([location.score for location in answer.locations]).max() <= 0
    assert {"decode", "encode", "match", "total"} == answer.seconds.keys()
    assert answer.seconds["total"] >= answer.seconds["encode"]


def test_an_image_in_memory_or_a_path_as_text(tiny_map, tiny_images):
    file = tiny_images / "night_right" / "Image002.jpg"
    answers = [tiny_map.locate(one).locations for one in (str(file), file, read_photo(file).image)]
    assert answers[0] == answers[1] == answers[2]


def test_answers_are_those_of_the_method_that_was_fitted(tiny_map, tiny_dataset):
    fresh = build_method("colours").method
    references = of_dataset("tiny", "day_right").traverse
    fresh.fit(of_dataset("tiny").traverse)
    for image in references:
        match = fresh.match(image, 12)
        found = tiny_map.locate(image, 12).locations
        assert [one.reference for one in found] == match.indices.tolist()
        assert [one.score for one in found] == match.scores.tolist()


def test_opening_reads_nothing_that_the_method_has_learnt(tiny_map, place, colours, monkeypatch):
    monkeypatch.setattr(colours.Colours, "load", lambda self, folder: pytest.fail("read"))
    assert len(load_map(place)) == 12


@pytest.mark.parametrize("k", [0, 13, -1])
def test_k_out_of_range(tiny_map, k):
    with pytest.raises(UsageError, match=f"between 1 and 12, the number of references. Got {k}"):
        tiny_map.locate(np.zeros((8, 8, 3), np.uint8), k)


def test_what_is_no_image(tiny_map, place):
    with pytest.raises(DataError, match="is not an image"):
        tiny_map.locate(place / "map.json")
    with pytest.raises(DataError, match="cannot be read"):
        tiny_map.locate("nowhere.jpg")


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (Match([12], [1.0]), "reference 12 of a map of 12"),
        (Match([0, 1, 2], [1.0, 0.5, 0.1]), "3 references where 2 were asked for"),
        ("here", "a str instead of a Match"),
    ],
)
def test_nonsense_is_refused(tiny_map, monkeypatch, answer, said):
    monkeypatch.setattr(type(tiny_map.method), "match", lambda self, image, k: answer)
    with pytest.raises(VprBenchError, match=said):
        tiny_map.locate(np.zeros((8, 8, 3), np.uint8), 2)


def test_no_answer_is_an_answer(tiny_map, monkeypatch):
    monkeypatch.setattr(type(tiny_map.method), "match", lambda self, image, k: Match([], []))
    assert tiny_map.locate(np.zeros((8, 8, 3), np.uint8)).locations == ()


def test_a_method_that_fails_names_the_photo(tiny_map, monkeypatch):
    def fail(self, image, k):
        raise RuntimeError("no light")

    monkeypatch.setattr(type(tiny_map.method), "match", fail)
    with pytest.raises(VprBenchError, match=r"'colours' failed while answering night.jpg: RuntimeError: no light"):
        list(tiny_map.locate_each([Photo("night.jpg", np.zeros((8, 8, 3), np.uint8))]))


@pytest.mark.parametrize("future", [0, 2])
def test_a_sequence_method_takes_photos_for_a_sequence(tiny_dataset, colours, place, future):
    built = build_method("seqslam", {"inner": "colours", "past": 3, "future": future, "contrast": 0})
    fitted = fit_map(built, of_dataset("tiny"), place)
    queries = of_dataset("tiny", "day_right").traverse
    photos = [Photo(str(index), image) for index, image in enumerate(queries)]
    for _ in range(2):  # what was asked before is forgotten with the map
        answers = list(load_map(place).locate_each(iter(photos), 1))
        assert [answer.photo.name for answer in answers] == [str(index) for index in range(12)]
        assert [answer.locations[0].reference for answer in answers][2:10] == list(range(2, 10))
    assert len(list(fitted.locate_each(photos[:1], 1))) == 1
