import numpy as np
import pytest
from PIL import Image

from vpr_bench.envs.frames import Frames, resized
from vpr_bench.errors import DataError, UsageError
from vpr_bench.types.traverse import Traverse


def noise(height, width, seed=0):
    return np.random.default_rng(seed).integers(1, 256, (height, width, 3), dtype=np.uint8)


@pytest.mark.parametrize("in_memory", [False, True])
def test_images_of_one_size_stay_as_they_are(in_memory):
    images = [noise(4, 6, seed) for seed in range(3)]
    frames = Frames(Traverse("walk", images), in_memory=in_memory)
    assert frames.shape == (4, 6, 3)
    for _ in range(2):  # the second time from memory
        assert all(np.array_equal(frames[index], image) for index, image in enumerate(images))
        assert np.array_equal(frames.batch(np.array([2, 0]), 2), np.stack([images[2], images[0]]))


@pytest.mark.parametrize("in_memory", [False, True])
def test_mixed_sizes_stand_in_the_corner_of_one_frame(in_memory):
    tall, wide = noise(8, 3), noise(4, 6)
    frames = Frames(Traverse("walk", [tall, wide]), in_memory=in_memory)
    assert frames.shape == (8, 6, 3) and frames.sizes.tolist() == [[8, 3], [4, 6]]
    assert np.array_equal(frames[0][:8, :3], tall) and not frames[0][:, 3:].any()
    assert np.array_equal(frames[1][:4, :6], wide) and not frames[1][4:].any()
    assert np.array_equal(frames.batch(np.array([1, 0]), 2), np.stack([frames[1], frames[0]]))


def test_a_batch_is_filled_up_with_black():
    frames = Frames(Traverse("walk", [noise(4, 6)]))
    batch = frames.batch(np.array([0]), 3)
    assert batch.shape == (3, 4, 6, 3) and not batch[1:].any()


@pytest.mark.parametrize("in_memory", [False, True])
def test_what_is_returned_may_be_changed(in_memory):
    frames = Frames(Traverse("walk", [noise(4, 6)]), in_memory=in_memory)
    for _ in range(2):
        frames[0][:] = 0
        frames.batch(np.array([0]), 1)[:] = 0
    assert np.array_equal(frames[0], noise(4, 6))


def test_an_image_that_is_not_as_large_as_its_header_says(tmp_path):
    file = tmp_path / "one.png"
    Image.fromarray(noise(4, 6)).save(file)
    frames = Frames(Traverse("walk", [file]))
    Image.fromarray(noise(5, 6)).save(file)
    with pytest.raises(DataError, match=r"one\.png is 6 × 5 pixels.*size="):
        frames[0]


def test_no_images():
    with pytest.raises(DataError, match="walk has no images"):
        Frames(Traverse("walk", []))


def test_resizing_keeps_what_a_traverse_is():
    joined = Traverse.join([Traverse("a", [noise(8, 12)] * 2), Traverse("b", [noise(20, 6)])])
    small = resized(joined, [4, 6])
    assert {image.shape for image in small} == {(4, 6, 3)}
    assert [(part.name, len(part)) for part in small.split()] == [("a", 2), ("b", 1)]
    assert Frames(small).shape == (4, 6, 3)


def test_resizing_comes_after_the_conversion():
    walk = Traverse("walk", [noise(8, 12)], convert=lambda image: image[:4])
    assert np.array_equal(resized(walk, (4, 12))[0], noise(8, 12)[:4])


@pytest.mark.parametrize("size", [(0, 4), (4,), (4, 4, 3), 4, "ab", (4.5, 6), None])
def test_a_size_that_is_none(size):
    with pytest.raises(UsageError, match="size must be"):
        resized(Traverse("walk", [noise(4, 6)]), size)
