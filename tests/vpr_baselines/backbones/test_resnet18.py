import pytest
import torch
from torch.nn import functional

from vpr_baselines.backbones.layers import respond
from vpr_baselines.backbones.resnet18 import ResNet18


def parameters(network):
    return sum(parameter.numel() for parameter in network.parameters())


@pytest.fixture(scope="module")
def network():
    """Random weights whose batch norms do something."""
    torch.manual_seed(0)
    network = ResNet18()
    for key, value in network.state_dict().items():
        if "bn" in key or "downsample.1" in key:
            if key.endswith(("weight", "running_var")):
                value.uniform_(0.5, 1.5)
            elif not key.endswith("num_batches_tracked"):
                value.normal_(0, 0.1)
    return network.eval()


def test_it_has_the_parameters_of_the_published_network(network):
    assert parameters(network) == 11_689_512


@pytest.mark.parametrize(
    ("cut", "published"),
    [
        ({}, 11_240_637),
        ({"pool": False}, 15_272_637),
        ({"pool": False, "stages": 3}, 9_982_909),
        ({"pool": False, "stages": 2}, 14_139_197),
        ({"pool": False, "stages": 1}, 26_149_629),
        ({"pool": False, "stages": 0}, 26_001_661),
    ],
)
def test_cut_networks_have_the_parameters_that_the_thesis_prints(cut, published):
    """Chapter 3: 125 classes, images of 227 × 227."""
    with torch.device("meta"):
        assert parameters(ResNet18(125, **cut)) == published


def torchvision_keys():
    """Write down torchvision's names and shapes: a table, and how its blocks repeat."""
    norm = {"weight": 0, "bias": 0, "running_mean": 0, "running_var": 0, "num_batches_tracked": None}

    def norms(name, channels):
        return {f"{name}.{part}": () if kind is None else (channels,) for part, kind in norm.items()}

    keys = {"conv1.weight": (64, 3, 7, 7), **norms("bn1", 64)}
    for stage, inputs, outputs in [(1, 64, 64), (2, 64, 128), (3, 128, 256), (4, 256, 512)]:
        for block in (0, 1):
            name = f"layer{stage}.{block}"
            keys[f"{name}.conv1.weight"] = (outputs, outputs if block else inputs, 3, 3)
            keys[f"{name}.conv2.weight"] = (outputs, outputs, 3, 3)
            keys |= norms(f"{name}.bn1", outputs) | norms(f"{name}.bn2", outputs)
        if stage > 1:
            keys[f"layer{stage}.0.downsample.0.weight"] = (outputs, inputs, 1, 1)
            keys |= norms(f"layer{stage}.0.downsample.1", outputs)
    return {**keys, "fc.weight": (1000, 512), "fc.bias": (1000,)}


def test_its_state_has_exactly_torchvisions_keys_and_shapes(network):
    assert {key: tuple(value.shape) for key, value in network.state_dict().items()} == torchvision_keys()


def reference(state, images):
    """Compute ResNet-18 as He et al. 2016 write it down, from its weights alone: last map and logits."""

    def norm(x, name):
        mean, variance = (state[f"{name}.running_{part}"][:, None, None] for part in ("mean", "var"))
        weight, bias = (state[f"{name}.{part}"][:, None, None] for part in ("weight", "bias"))
        return (x - mean) / torch.sqrt(variance + 1e-5) * weight + bias

    x = functional.conv2d(images, state["conv1.weight"], stride=2, padding=3)
    x = functional.max_pool2d(norm(x, "bn1").clamp(min=0), 3, 2, 1)
    for stage in (1, 2, 3, 4):
        for block in (0, 1):
            name, stride = f"layer{stage}.{block}", 2 if stage > 1 and block == 0 else 1
            y = functional.conv2d(x, state[f"{name}.conv1.weight"], stride=stride, padding=1)
            y = norm(y, f"{name}.bn1").clamp(min=0)
            y = norm(functional.conv2d(y, state[f"{name}.conv2.weight"], padding=1), f"{name}.bn2")
            if stride == 2:
                x = functional.conv2d(x, state[f"{name}.downsample.0.weight"], stride=2)
                x = norm(x, f"{name}.downsample.1")
            x = (x + y).clamp(min=0)
    return x, x.mean(dim=(2, 3)) @ state["fc.weight"].T + state["fc.bias"]


@pytest.mark.parametrize(("height", "width"), [(64, 96), (33, 65), (227, 227)])
def test_it_computes_what_a_second_implementation_does(network, height, width):
    images = torch.randn(2, 3, height, width, generator=torch.Generator().manual_seed(1))
    with torch.inference_mode():
        maps, logits = reference(network.state_dict(), images)
        assert respond(network, images, ("layer4",))[0].shape == (2, 512, -(-height // 32), -(-width // 32))
        assert maps.std() > 0.1
        assert torch.allclose(respond(network, images, ("layer4",))[0], maps, rtol=1e-4, atol=1e-4 * maps.abs().max())
        assert torch.allclose(network(images), logits, rtol=1e-4, atol=1e-4 * logits.abs().max())


@pytest.mark.parametrize("stages", range(5))
def test_cut_networks_begin_as_the_whole_one_and_run(network, stages):
    cut = ResNet18(5, stages=stages, pool=False, size=(64, 96)).eval()
    kept = {key: value for key, value in network.state_dict().items() if key in cut.state_dict() and "fc" not in key}
    cut.load_state_dict(kept, strict=False)
    images = torch.randn(1, 3, 64, 96, generator=torch.Generator().manual_seed(1))
    with torch.inference_mode():
        x = functional.max_pool2d(functional.relu(network.bn1(network.conv1(images))), 3, 2, 1)
        for number in range(1, stages + 1):
            x = network.get_submodule(f"layer{number}")(x)
        assert torch.equal(respond(cut, images, (f"layer{stages}" if stages else "conv1",))[0], x)
        assert cut(images).shape == (1, 5)


def test_there_are_four_stages():
    with pytest.raises(ValueError, match=r"stages must lie in \[0, 4\]. Got 5 instead"):
        ResNet18(stages=5)
