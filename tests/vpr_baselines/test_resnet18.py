import numpy as np
import pytest
import torch

from vpr_baselines.backbones import resnet18
from vpr_baselines.backbones.layers import respond
from vpr_baselines.resnet18 import ResNet18
from vpr_bench.errors import DataError
from vpr_bench.method.build import build_method
from vpr_bench.types.traverse import Traverse

IMAGES = list(np.random.default_rng(0).integers(0, 256, (4, 40, 50, 3), dtype=np.uint8))


@pytest.mark.parametrize("weights", ["imagenet", "places365"])
def test_missing_weights_say_how_to_get_them_and_where_to_put_them(tmp_path, monkeypatch, weights):
    monkeypatch.setenv("VPR_BENCH_WEIGHTS", str(tmp_path))
    with pytest.raises(DataError, match=rf"`vpr-bench weights fetch resnet18-{weights}`,\n.* into {tmp_path}"):
        build_method("resnet18", {"weights": weights})


def test_the_places_network_is_taken_from_the_folder_of_weights(tmp_path, monkeypatch, data_folder):
    monkeypatch.setenv("VPR_BENCH_WEIGHTS", str(tmp_path))
    torch.manual_seed(0)
    network = resnet18.ResNet18(365).eval()
    state = {f"module.{key}": value for key, value in network.state_dict().items()}
    torch.save({"epoch": 1, "state_dict": state}, tmp_path / "resnet18_places365.pth.tar")
    built = build_method(
        "resnet18", {"weights": "places365", "width": 96, "height": 64, "normalise": "none", "pooling": "average"}
    )
    assert built.weights.startswith("resnet18 (Places365) sha256:")
    image = np.random.default_rng(0).integers(0, 256, (64, 96, 3), dtype=np.uint8)
    scaled = (image / 255 - np.array(resnet18.MEAN)) / np.array(resnet18.STD)
    with torch.inference_mode():
        expected = respond(network, torch.from_numpy(scaled.transpose(2, 0, 1)[None]).float(), ("layer4",))[0].mean(
            dim=(2, 3)
        )[0]
    assert np.allclose(built.method.respond(image), expected, rtol=1e-3, atol=1e-4)


def test_random_weights_tell_images_apart():
    method = ResNet18(weights="random", width=96, height=64)
    method.fit(Traverse("map", IMAGES))
    assert [method.match(image, 1).indices[0] for image in IMAGES] == [0, 1, 2, 3]
    assert method.respond(IMAGES[0]).shape == (3 * 512,)
