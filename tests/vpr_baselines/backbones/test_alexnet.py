import pytest
import torch
from torch.nn import functional

from vpr_baselines.backbones.alexnet import AlexNet
from vpr_baselines.backbones.layers import respond


def parameters(network):
    return sum(parameter.numel() for parameter in network.parameters())


@pytest.fixture(scope="module")
def network():
    torch.manual_seed(0)
    return AlexNet(10).eval()


@pytest.fixture(scope="module")
def images():
    return torch.randn(2, 3, 227, 227, generator=torch.Generator().manual_seed(1))


KEYS = {
    "features.0.weight": (64, 3, 11, 11),
    "features.0.bias": (64,),
    "features.3.weight": (192, 64, 5, 5),
    "features.3.bias": (192,),
    "features.6.weight": (384, 192, 3, 3),
    "features.6.bias": (384,),
    "features.8.weight": (256, 384, 3, 3),
    "features.8.bias": (256,),
    "features.10.weight": (256, 256, 3, 3),
    "features.10.bias": (256,),
    "classifier.1.weight": (4096, 9216),
    "classifier.1.bias": (4096,),
    "classifier.4.weight": (4096, 4096),
    "classifier.4.bias": (4096,),
    "classifier.6.weight": (1000, 4096),
    "classifier.6.bias": (1000,),
}
"""Torchvision's names and shapes."""


def test_its_state_has_exactly_torchvisions_keys_and_shapes():
    with torch.device("meta"):
        network = AlexNet()
    assert {key: tuple(value.shape) for key, value in network.state_dict().items()} == KEYS
    assert parameters(network) == 61_100_840  # as published


@pytest.mark.parametrize(
    ("depth", "published"),
    [
        ("fc7", 57_524_159),
        ("fc6", 40_742_847),  # "without the last two layers": of those that have weights
        ("fc6", 40_742_847),  # "without the last three": of the classifier's entries, ReLU counted
        ("pool5", 3_640_255),  # "without the last six"
    ],
)
def test_cut_networks_have_the_parameters_that_the_thesis_prints(depth, published):
    """Chapter 3: 127 classes."""
    with torch.device("meta"):
        assert parameters(AlexNet(127, depth=depth)) == published


def reference(state, images):
    """Compute AlexNet as Krizhevsky 2014 writes it down, from its weights alone: conv3, pool5, fc7 and logits."""

    def conv(x, number, **options):
        name = f"features.{number}"
        return functional.conv2d(x, state[f"{name}.weight"], state[f"{name}.bias"], **options).clamp(min=0)

    def full(x, number):
        return x @ state[f"classifier.{number}.weight"].T + state[f"classifier.{number}.bias"]

    x = functional.max_pool2d(conv(images, 0, stride=4, padding=2), 3, 2)
    x = functional.max_pool2d(conv(x, 3, padding=2), 3, 2)
    conv3 = conv(x, 6, padding=1)
    pool5 = functional.max_pool2d(conv(conv(conv3, 8, padding=1), 10, padding=1), 3, 2)
    fc7 = full(full(pool5.flatten(1), 1).clamp(min=0), 4).clamp(min=0)
    return conv3, pool5, fc7, full(fc7, 6)


def test_it_computes_what_a_second_implementation_does(network, images):
    with torch.inference_mode():
        expected = reference(network.state_dict(), images)
        found = *respond(network, images, ("conv3", "pool5", "fc7")), network(images)
    assert [one.shape[1:] for one in found] == [(384, 13, 13), (256, 6, 6), (4096,), (10,)]
    for ours, theirs in zip(found, expected, strict=True):
        assert theirs.std() > 0
        assert torch.allclose(ours, theirs, rtol=1e-4, atol=1e-4 * theirs.abs().max())


def test_the_response_of_conv3_has_the_size_that_the_thesis_means(network, images):
    """It prints 64869."""
    with torch.inference_mode():
        assert respond(network, images, ("conv3",))[0].flatten(1).shape == (2, 64_896)


@pytest.mark.parametrize(("depth", "inputs"), [("fc6", 4096), ("pool5", 9216)])
def test_cut_networks_begin_as_the_whole_one_and_run(network, images, depth, inputs):
    cut = AlexNet(10, depth=depth).eval()
    kept = {key: value for key, value in network.state_dict().items() if not key.startswith("classifier.6")}
    cut.load_state_dict({key: value for key, value in kept.items() if key in cut.state_dict()}, strict=False)
    with torch.inference_mode():
        before_head = respond(cut, images, (depth,))[0].flatten(1)
        x = network.features(images).flatten(1)
        if depth == "fc6":
            x = functional.relu(network.classifier[1](x))
        assert torch.equal(before_head, x)
        assert before_head.shape == (2, inputs) and cut(images).shape == (2, 10)
