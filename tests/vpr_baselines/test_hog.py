import numpy as np
import pytest

from vpr_baselines.hog import Hog
from vpr_bench.dataset.load import load_case
from vpr_bench.types.traverse import Traverse


def test_the_descriptor_has_the_length_of_vpr_bench():
    descriptor = Hog().describe(np.zeros((30, 40, 3), np.uint8))
    assert descriptor.shape == (34_596,) and descriptor.dtype == np.float32


@pytest.mark.parametrize(("size", "cell", "bins"), [(64, 16, 9), (64, 8, 4), (32, 16, 1), (9, 3, 9)])
def test_the_length_follows_from_the_parameters(size, cell, bins):
    descriptor = Hog(size, cell, bins).describe(np.zeros((20, 30, 3), np.uint8))
    assert descriptor.shape == ((size // cell - 1) ** 2 * 4 * bins,)


@pytest.mark.parametrize(
    "parameters",
    [{"cell": 0}, {"cell": -16}, {"bins": 0}, {"size": 500}, {"size": 16}, {"size": 0}, {"size": -32}],
    ids=str,
)
def test_parameters_that_make_no_grid_are_refused(parameters):
    with pytest.raises(ValueError, match=r"must be a multiple of cell.* Got size=-?[0-9]+, cell="):
        Hog(**parameters)


def test_vertical_and_horizontal_edges_are_told_apart():
    stripes = np.zeros((64, 64, 3), np.uint8)
    stripes[:, ::8] = 255
    upright, lying = (Hog(64).describe(image) for image in (stripes, stripes.transpose(1, 0, 2)))
    assert upright @ lying < 0.2 * (upright @ upright)


def test_every_reference_finds_itself_first(tiny_dataset):
    references = load_case("tiny").references
    method = Hog(size=64, cell=8)
    method.fit(references)
    for index, image in enumerate(references):
        match = method.match(image, k=3)
        assert match.indices[0] == index and match.scores[0] == pytest.approx(1)
        assert match.scores[1] < 0.999


def test_it_recognises_places_from_beside_and_in_the_dark(tiny_dataset):
    method = Hog(size=64, cell=8)
    for pairing in ("day_left-day_right", "day_left-night_right"):
        case = load_case("tiny", pairing)
        method.fit(case.references)
        assert [int(method.match(image, 1).indices[0]) for image in case.queries] == list(range(12))


@pytest.mark.parametrize("shape", [(1, 1), (3, 200), (600, 7)])
def test_images_of_any_size_are_described(shape):
    method = Hog(size=32, cell=8)
    method.fit(Traverse("map", [np.random.default_rng(0).integers(0, 256, (*shape, 3), dtype=np.uint8)]))
    assert np.isfinite(method.match(np.zeros((2, 9, 3), np.uint8), 1).scores).all()
