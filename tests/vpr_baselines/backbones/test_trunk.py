import numpy as np
import pytest
import torch

from vpr_baselines.backbones.architectures import ARCHITECTURES, WHOLE_ALEXNET
from vpr_baselines.backbones.trunk import load_trunk
from vpr_bench.errors import DataError


@pytest.fixture(scope="module")
def trunk():
    return load_trunk("efficientnet-lite0", 96, 64)


def noise(height, width, seed=0):
    return np.random.default_rng(seed).integers(0, 256, (height, width, 3), dtype=np.uint8)


def test_images_of_any_size_become_maps_of_one_size(trunk):
    maps = trunk.encode([noise(48, 64), noise(31, 200), noise(64, 96)])
    assert maps.shape == (3, 1280, 2, 3) and maps.dtype == np.float32
    assert maps.min() >= 0 and maps.max() <= 6 and maps.std() > 0


@pytest.mark.parametrize(("width", "height"), [(33, 65), (32, 32)])
def test_odd_input_sizes_are_rounded_up(width, height):
    maps = load_trunk("efficientnet-lite0", width, height).encode([noise(20, 20)])
    assert maps.shape == (1, 1280, -(-height // 32), -(-width // 32))


def test_an_image_is_encoded_the_same_alone_and_among_others(trunk):
    images = [noise(64, 96, seed) for seed in range(3)]
    together = trunk.encode(images)
    for image, maps in zip(images, together, strict=True):
        assert np.allclose(trunk.encode([image])[0], maps, atol=1e-4)


def test_colour_does_not_matter_and_dimming_hardly(trunk):
    image = noise(8, 12).repeat(8, axis=0).repeat(8, axis=1)
    grey = np.repeat((image @ [0.299, 0.587, 0.114]).round().astype(np.uint8)[..., None], 3, axis=2)
    maps, of_grey, of_dim, of_other = trunk.encode([image, grey, image // 3, noise(64, 96, 5)]).reshape(4, -1)
    assert np.corrcoef(maps, of_grey)[0, 1] > 0.99
    assert np.corrcoef(maps, of_dim)[0, 1] > np.corrcoef(maps, of_other)[0, 1] + 0.2


def test_colour_matters_where_light_is_left_alone():
    trunk = load_trunk("efficientnet-lite0", 96, 64, normalise="none")
    image = noise(8, 12).repeat(8, axis=0).repeat(8, axis=1)
    grey = np.repeat((image @ [0.299, 0.587, 0.114]).round().astype(np.uint8)[..., None], 3, axis=2)
    maps, of_grey = trunk.encode([image, grey]).reshape(2, -1)
    assert np.corrcoef(maps, of_grey)[0, 1] < 0.9


@pytest.mark.parametrize("backbone", ["resnet18", "efficientnet-lite0"])
def test_pixels_are_scaled_channel_by_channel(backbone):
    """By the definition: (RGB / 255 - mean) / std."""
    trunk = load_trunk(backbone, 4, 3, "random", normalise="none")
    one = ARCHITECTURES[backbone]
    image = noise(3, 4)
    expected = ((image / 255 - np.array(one.mean)) / np.array(one.std)).transpose(2, 0, 1)[None]
    assert np.allclose(trunk.input(image).numpy(), expected, atol=1e-5)


def test_it_is_shared_by_all_that_ask_for_it_and_its_network_by_trunks_of_other_sizes(trunk):
    assert load_trunk("efficientnet-lite0", 96, 64) is trunk
    assert load_trunk("efficientnet-lite0", 64, 64).network is trunk.network


@pytest.mark.parametrize(
    ("backbone", "layers", "shape"),
    [
        ("resnet18", (), (512, 2, 3)),
        ("resnet18", ("layer2",), (128, 8, 12)),
        ("alexnet", (), (256, 1, 2)),
        ("alexnet", ("conv3",), (384, 3, 5)),
        (WHOLE_ALEXNET, (), (4096,)),
    ],
)
def test_other_networks_and_layers(backbone, layers, shape):
    trunk = load_trunk(backbone, 96, 64, "random", layers=layers)
    assert trunk.encode([noise(20, 30), noise(40, 30)]).shape == (2, *shape)


def test_missing_weights_are_told_before_anything_else(tmp_path, monkeypatch):
    monkeypatch.setenv("VPR_BENCH_WEIGHTS", str(tmp_path))
    with pytest.raises(DataError, match="weights fetch resnet18-imagenet"):
        load_trunk("resnet18", 96, 64)


def test_reading_leaves_the_random_state_alone():
    torch.manual_seed(5)
    expected = torch.rand(1)
    torch.manual_seed(5)
    load_trunk("resnet18", 31, 31, "random", seed=12345)
    assert torch.equal(torch.rand(1), expected)
