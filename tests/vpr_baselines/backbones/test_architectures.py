import pytest
import torch

from vpr_baselines.backbones.alexnet import AlexNet
from vpr_baselines.backbones.architectures import ARCHITECTURES, WHOLE_ALEXNET, load_network
from vpr_baselines.backbones.efficientnet_lite0 import EfficientNetLite0
from vpr_baselines.backbones.layers import respond
from vpr_baselines.backbones.resnet18 import ResNet18
from vpr_bench.errors import DataError, UsageError
from vpr_bench.weights.checkpoint import load_checkpoint
from vpr_bench.weights.place import find_weights

IMAGES = torch.randn(2, 3, 65, 97, generator=torch.Generator().manual_seed(0))


def test_the_folded_network_computes_what_the_published_one_does():
    published = EfficientNetLite0()
    published.load_state_dict(load_checkpoint(find_weights("efficientnet-lite0-imagenet")))
    published.eval()
    folded = load_network(ARCHITECTURES["efficientnet-lite0"], "imagenet")
    assert not any(isinstance(part, torch.nn.BatchNorm2d) for part in folded.modules())
    with torch.inference_mode():
        expected, found = respond(published, IMAGES, ("head",))[0], respond(folded, IMAGES, ("head",))[0]
    assert expected.std() > 0.1
    assert torch.allclose(found, expected, atol=1e-3)


@pytest.fixture(scope="module")
def resnet(tmp_path_factory):
    """Return a ResNet-18 of random weights, and the checkpoint that the training script of Places365 makes of it."""
    torch.manual_seed(3)
    network = ResNet18(365).eval()
    for key, value in network.state_dict().items():
        if key.endswith("running_var"):
            value.uniform_(0.5, 1.5)
        elif key.endswith("running_mean"):
            value.normal_(0, 0.1)
    file = tmp_path_factory.mktemp("weights") / "resnet18_places365.pth.tar"
    torch.save({"epoch": 1, "state_dict": {f"module.{key}": v for key, v in network.state_dict().items()}}, file)
    return network, file


def test_a_checkpoint_of_places365_is_loaded_and_folded(resnet):
    network, file = resnet
    folded = load_network(ARCHITECTURES["resnet18"], str(file))
    assert not any(isinstance(part, torch.nn.BatchNorm2d) for part in folded.modules())
    with torch.inference_mode():
        expected = respond(network, IMAGES, ("layer4",))[0]
        assert torch.allclose(respond(folded, IMAGES, ("layer4",))[0], expected, rtol=1e-3, atol=1e-4 * expected.max())


@pytest.mark.parametrize("whole", [True, False])
def test_an_alexnet_of_places365_is_loaded_whole_or_without_its_fully_connected_layers(tmp_path, monkeypatch, whole):
    """Its training script puts only the convolutions on several processors: features.module.0.weight."""
    network = AlexNet(7, depth="fc7" if whole else "pool5").eval()
    file = tmp_path / "alexnet.pth.tar"
    if whole:  # a quarter of a gigabyte, which the disk may be spared
        file.touch()
        monkeypatch.setattr("vpr_bench.weights.checkpoint.load_checkpoint", lambda path: network.state_dict())
    else:
        state = {key.replace("features.", "features.module."): value for key, value in network.state_dict().items()}
        state |= {f"classifier.{part}": torch.zeros(2, 3) for part in ("1.weight", "4.weight", "6.bias")}
        torch.save({"state_dict": state}, file)
    layers = ("conv3", "fc7") if whole else ("conv3", "pool5")
    loaded = load_network(WHOLE_ALEXNET if whole else ARCHITECTURES["alexnet"], str(file))
    with torch.inference_mode():
        for expected, found in zip(respond(network, IMAGES, layers), respond(loaded, IMAGES, layers), strict=True):
            assert torch.allclose(found, expected, atol=1e-5)


def test_it_is_frozen_and_shared_by_all_that_ask_for_it():
    network = load_network(ARCHITECTURES["efficientnet-lite0"], "imagenet")
    assert load_network(ARCHITECTURES["efficientnet-lite0"], "imagenet") is network
    assert not any(parameter.requires_grad for parameter in network.parameters())
    assert not network.training


def test_random_weights_depend_on_the_seed_alone():
    weights = []
    for seed in (1, 2, 1):
        load_network.cache_clear()
        weights.append(load_network(ARCHITECTURES["resnet18"], "random", seed).conv1.weight)
    assert torch.equal(weights[0], weights[2])
    assert not torch.equal(weights[0], weights[1])


@pytest.mark.parametrize("backbone", ARCHITECTURES)
def test_random_networks_tell_images_apart(backbone):
    """Torch's own initialisation makes the last map of the deeper ones vanish."""
    with torch.inference_mode():
        one = ARCHITECTURES[backbone]
        maps = respond(load_network(one, "random"), IMAGES, (one.last,))[0].flatten(1)
    assert torch.isfinite(maps).all()
    assert (maps[0] - maps[1]).abs().mean() > 1e-2


def test_a_checkpoint_of_another_network_is_a_data_error_that_says_what_does_not_fit(resnet):
    with pytest.raises(DataError, match=r"\(resnet18_places365.pth.tar\) sha256:\w+ does not fit AlexNet: .* missing"):
        load_network(ARCHITECTURES["alexnet"], str(resnet[1]))


def test_weights_that_nobody_knows_are_a_usage_error():
    with pytest.raises(UsageError, match=r"no weights 'imagenett' of resnet18. Did you mean 'imagenet'"):
        load_network(ARCHITECTURES["resnet18"], "imagenett")


def test_damaged_weights_are_a_data_error(tmp_path, monkeypatch):
    damaged = tmp_path / "damaged.pth"
    content = bytearray(find_weights("efficientnet-lite0-imagenet").read_bytes())
    content[1000] ^= 1
    damaged.write_bytes(content)
    monkeypatch.setattr("vpr_bench.weights.digest.find_file", lambda card: damaged)
    load_network.cache_clear()
    with pytest.raises(DataError, match=rf"{damaged} is damaged .*\nReinstall its package"):
        load_network(ARCHITECTURES["efficientnet-lite0"], "imagenet")
