import numpy as np
import pytest

from vpr_baselines.clustering.cluster import cluster_descriptors
from vpr_baselines.clustering.describers import describe_references
from vpr_baselines.clustering.options import ClusteringOptions
from vpr_bench.dataset.load import load_case
from vpr_bench.errors import DataError
from vpr_bench.types.traverse import Traverse

IMAGES = Traverse("map", [np.random.default_rng(seed).integers(0, 256, (60, 80, 3), np.uint8) for seed in range(2)])


@pytest.mark.parametrize(("name", "length"), [("hog", 26_244), ("hog:thesis", 3_780), ("sift", 16_384)])
def test_every_reference_is_one_row(name, length):
    described = describe_references(name, IMAGES)
    assert described.shape == (2, length) and described.dtype == np.float32
    assert not np.array_equal(*described)


def test_sift_of_an_image_without_key_points_is_nothing():
    assert not describe_references("sift", Traverse("map", [np.zeros((60, 80, 3), np.uint8)])).any()


@pytest.mark.usefixtures("data_folder")
def test_missing_weights_say_how_to_get_them():
    with pytest.raises(DataError, match="alexnet"):
        describe_references("alexnet", IMAGES)


def test_no_reference_is_no_row():
    assert len(describe_references("hog", Traverse("map", []))) == 0


@pytest.mark.usefixtures("real_gardens")
def test_the_numbers_of_clusters_of_the_real_walk():
    """What the documentation states: sequential clusters by cosine, and by Manhattan distance of the small HOG."""
    references = load_case("gardens", edition="real").references
    large = describe_references("hog", references)
    counts = [len(cluster_descriptors(large, ClusteringOptions("leader", threshold=one))) for one in (0.65, 0.70)]
    assert counts == pytest.approx([17, 36], abs=8)  # libraries decode and resize a little differently
    small = describe_references("hog:thesis", references)
    counts = [
        len(cluster_descriptors(small, ClusteringOptions("focus", "l1", threshold=one))) for one in (340, 355, 370)
    ]
    assert counts == pytest.approx([19, 15, 9], abs=4)
