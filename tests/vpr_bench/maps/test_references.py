import pytest

from vpr_bench.errors import DataError, UsageError
from vpr_bench.maps.references import find_again, of_dataset, of_folder


def test_the_references_of_a_dataset(tiny_dataset):
    for words in ({}, {"protocol": "day_left-day_right"}, {"references": "day_left"}):
        found = of_dataset("tiny", **words)
        assert found.part.names[:2] == ("day_left/Image000.jpg", "day_left/Image001.jpg")
        assert str(found.part) == "tiny/day_left"
    assert of_dataset("tiny/day_right-day_left").part.traverse == "day_right"


def test_parts_and_joined_ones(tiny_dataset):
    found = of_dataset("tiny", "day_left.every3+night_right.first2")
    assert found.part.names[3:] == (
        "day_left/Image009.jpg",
        "night_right/Image000.jpg",
        "night_right/Image001.jpg",
    )
    assert found.part.places == (0, 3, 6, 9, 0, 1)


def test_the_digest_is_of_these_images_in_this_order(tiny_dataset):
    asked = ["day_left", "day_right", "day_left.every2", "day_left+day_right", "day_right+day_left"]
    assert len({of_dataset("tiny", name).part.digest for name in asked}) == 5
    assert of_dataset("tiny", "day_left").part.digest == of_dataset("tiny").part.digest


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ({"references": "day_lefty"}, "In tiny there is no traverse 'day_lefty'. Did you mean 'day_left'"),
        ({"references": "day_left.evry2"}, "is not part of a traverse"),
        ({"references": "day_left", "protocol": "day_left-day_right"}, "say it twice"),
        ({"protocol": "day_left-nights"}, "has no protocol"),
        ({"edition": "simulatd"}, "must be one of auto, real, simulated"),
    ],
)
def test_what_is_not_there(tiny_dataset, words, said):
    with pytest.raises(UsageError, match=said):
        of_dataset("tiny", **words)


def test_images_are_found_again(tiny_dataset, tiny_images):
    for found in (of_dataset("tiny", "day_left.every2+day_right"), of_folder(tiny_images / "day_left")):
        assert find_again(found.part).traverse.sources == found.traverse.sources


def test_images_that_are_gone_or_others(tiny_dataset, tmp_path, tiny_images):
    part = of_dataset("tiny").part
    for file in (tiny_dataset.folder / "day_left").iterdir():
        file.unlink()
    with pytest.raises(DataError):
        find_again(part)
    own = of_folder(tiny_images / "day_left").part
    (tmp_path / "moved").mkdir()
    with pytest.raises(DataError, match="holds no images"):
        find_again(own.model_copy(update={"folder": str(tmp_path / "moved")}))
    with pytest.raises(DataError, match="does not hold the images that the map was made of"):
        find_again(own.model_copy(update={"names": own.names[:3], "places": None}))
