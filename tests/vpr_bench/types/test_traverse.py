import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from vpr_bench.errors import DataError
from vpr_bench.types.traverse import Traverse


def grey(level, shape=(4, 6)):
    return np.full((*shape, 3), level, np.uint8)


@pytest.fixture
def walk(tmp_path):
    """Five files whose grey level is ten times their number."""
    paths = [tmp_path / f"Image{index:03d}.png" for index in range(5)]
    for index, path in enumerate(paths):
        Image.fromarray(grey(10 * index)).save(path)
    return Traverse("day_left", paths)


def levels(traverse):
    return [int(image[0, 0, 0]) for image in traverse]


def test_images_come_in_order_however_they_are_asked_for(walk):
    assert len(walk) == 5
    assert levels(walk) == [0, 10, 20, 30, 40]
    assert walk[-1][0, 0, 0] == 40 and walk[np.int64(2)][0, 0, 0] == 20
    assert levels(reversed(walk)) == [40, 30, 20, 10, 0]
    with pytest.raises(IndexError):
        walk[5]


def test_nothing_is_decoded_until_it_is_asked_for(walk):
    walk.sources[3].write_text("not an image")
    parts = walk[1:], walk.subset([4, 3]), walk.subset([0])
    assert [len(part) for part in parts] == [4, 2, 1]
    assert walk[2][0, 0, 0] == 20
    with pytest.raises(DataError, match=r"Image003\.png is not an image"):
        walk[3]


def test_a_file_is_read_anew_each_time(walk):
    assert walk[0][0, 0, 0] == 0
    Image.fromarray(grey(99)).save(walk.sources[0])
    assert walk[0][0, 0, 0] == 99


def test_a_missing_file_is_a_data_error(walk):
    walk.sources[1].unlink()
    with pytest.raises(DataError, match=r"Image001\.png cannot be read"):
        walk[1]


def test_a_slice_is_a_traverse_of_the_same_name(walk):
    part = walk[1::2]
    assert isinstance(part, Traverse) and part.name == "day_left"
    assert levels(part) == [10, 30]
    assert len(walk[5:]) == 0


def test_a_subset_keeps_the_order_it_is_asked_in(walk):
    part = walk.subset(np.array([3, 0, 3]))
    assert part.name == "day_left" and levels(part) == [30, 0, 30]
    assert len(walk.subset([])) == 0


@pytest.mark.parametrize("indices", [[0.0, 1.0], [9], [[0, 1]]])
def test_a_subset_of_something_else_is_refused(walk, indices):
    with pytest.raises((TypeError, IndexError)):
        walk.subset(indices)


def test_the_conversion_is_applied_to_each_image_and_kept_by_parts(walk):
    brighter = Traverse("bayer", walk.sources, convert=lambda image: image + np.uint8(1))
    assert levels(brighter) == [1, 11, 21, 31, 41]
    assert levels(brighter[3:]) == [31, 41] and levels(brighter.subset([2])) == [21]


def test_images_in_memory_are_copied_out():
    source = grey(7)
    walk = Traverse("memory", [source, source])
    walk[0][:] = 0
    assert levels(walk) == [7, 7] and source[0, 0, 0] == 7


def test_the_list_of_sources_may_change_afterwards():
    sources = [grey(1), grey(2)]
    walk = Traverse("memory", sources)
    sources.clear()
    assert len(walk) == 2


@pytest.mark.parametrize("image", [np.zeros((4, 6), np.uint8), np.zeros((4, 6, 4), np.uint8), np.zeros((4, 6, 3))])
def test_an_array_that_is_no_image_is_refused(image):
    with pytest.raises(ValueError, match=r"must be \(H, W, 3\) uint8. Got \(4, 6"):
        Traverse("memory", [image])[0]


def test_images_have_names_for_messages(walk):
    assert walk.name_of(2) == "day_left/Image002.png"
    assert Traverse("memory", [grey(1)]).name_of(0) == "memory[0]"
    assert repr(walk) == "Traverse('day_left', 5 images)"


@given(st.lists(st.integers(0, 4), min_size=1, max_size=5))
def test_joining_and_splitting_again_loses_nothing(lengths):
    image = np.zeros((2, 2, 3), np.uint8)
    parts = [Traverse(f"part{number}", [image + number] * length) for number, length in enumerate(lengths)]
    joined = Traverse.join(parts)
    again = joined.split()
    assert [(part.name, len(part)) for part in again] == [(part.name, len(part)) for part in parts]
    assert all(
        one is other
        for new, old in zip(again, parts, strict=True)
        for one, other in zip(new.sources, old.sources, strict=True)
    )
    assert Traverse.join([joined, parts[0]]).split()[-1].sources == parts[0].sources


def test_traverses_of_different_cameras_are_not_joined():
    image = np.zeros((2, 2, 3), np.uint8)
    with pytest.raises(ValueError, match="converted alike"):
        Traverse.join([Traverse("a", [image]), Traverse("b", [image], convert=np.negative)])
    with pytest.raises(ValueError, match="can be joined if there are some"):
        Traverse.join([])


def test_a_traverse_that_was_not_joined_is_its_own_part():
    walk = Traverse("walk", [np.zeros((2, 2, 3), np.uint8)] * 3)
    assert [(part.name, len(part)) for part in walk.split()] == [("walk", 3)]
