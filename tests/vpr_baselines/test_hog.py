import numpy as np
import pytest

from vpr_baselines.hog import Hog
from vpr_bench.dataset.load import load_case
from vpr_bench.types.traverse import Traverse


def test_the_descriptor_has_the_length_of_vpr_bench():
    descriptor = Hog().describe(np.zeros((30, 40, 3), np.uint8))
    assert descriptor.shape == (34_596,) and descriptor.dtype == np.float32


@pytest.mark.parametrize(
    ("width", "height", "cell", "bins"), [(64, 64, 16, 9), (64, 48, 8, 4), (32, 96, 16, 1), (9, 6, 3, 9)]
)
def test_the_length_follows_from_the_parameters(width, height, cell, bins):
    descriptor = Hog(width, height, cell, bins).describe(np.zeros((20, 30, 3), np.uint8))
    assert descriptor.shape == ((width // cell - 1) * (height // cell - 1) * 4 * bins,)


def test_the_thesis_has_3780_numbers():
    assert Hog(**Hog.presets["thesis"]).describe(np.zeros((30, 40, 3), np.uint8)).shape == (3780,)


def test_the_preset_of_vpr_bench_is_the_default():
    assert Hog(**Hog.presets["vpr-bench"]) == Hog()


@pytest.mark.parametrize(
    "parameters",
    [{"cell": 0}, {"cell": -16}, {"bins": 0}, {"width": 500}, {"height": 16}, {"width": 0}, {"height": -32}],
    ids=str,
)
def test_parameters_that_make_no_grid_are_refused(parameters):
    with pytest.raises(ValueError, match=r"must be multiples of cell.* Got width=-?[0-9]+, height="):
        Hog(**parameters)


def test_an_index_that_knows_no_such_metric_is_refused():
    with pytest.raises(ValueError, match="manhattan needs index='exact'"):
        Hog(metric="manhattan", index="hnsw")


def test_vertical_and_horizontal_edges_are_told_apart():
    stripes = np.zeros((64, 64, 3), np.uint8)
    stripes[:, ::8] = 255
    upright, lying = (Hog(64, 64).describe(image) for image in (stripes, stripes.transpose(1, 0, 2)))
    assert upright @ lying < 0.2 * (upright @ upright)


def test_every_reference_finds_itself_first(tiny_dataset):
    references = load_case("tiny").references
    method = Hog(64, 64, cell=8)
    method.fit(references)
    for index, image in enumerate(references):
        match = method.match(image, k=3)
        assert match.indices[0] == index and match.scores[0] == pytest.approx(1)
        assert match.scores[1] < 0.999


def test_it_recognises_places_from_beside_and_in_the_dark(tiny_dataset):
    method = Hog(64, 64, cell=8)
    for pairing in ("day_left-day_right", "day_left-night_right"):
        case = load_case("tiny", pairing)
        method.fit(case.references)
        assert [int(method.match(image, 1).indices[0]) for image in case.queries] == list(range(12))


@pytest.mark.parametrize("shape", [(1, 1), (3, 200), (600, 7)])
def test_images_of_any_size_are_described(shape):
    method = Hog(32, 32, cell=8)
    method.fit(Traverse("map", [np.random.default_rng(0).integers(0, 256, (*shape, 3), dtype=np.uint8)]))
    assert np.isfinite(method.match(np.zeros((2, 9, 3), np.uint8), 1).scores).all()
