import cv2
import pytest
import torch
from sklearn.datasets import load_sample_image
from torch.nn import functional

from vpr_baselines.backbones.efficientnet_lite0 import MEAN, STD, EfficientNetLite0, _SameConv2d
from vpr_baselines.backbones.layers import respond
from vpr_bench.weights.place import find_weights


@pytest.fixture(scope="module")
def network():
    network = EfficientNetLite0()
    network.load_state_dict(torch.load(find_weights("efficientnet-lite0-imagenet"), weights_only=True), strict=True)
    return network.eval()


def test_it_has_the_parameters_of_the_published_network(network):
    assert sum(parameter.numel() for parameter in network.parameters()) == 4_652_008


def test_its_state_has_exactly_the_keys_and_shapes_of_the_checkpoint():
    published = torch.load(find_weights("efficientnet-lite0-imagenet"), weights_only=True)
    ours = EfficientNetLite0().state_dict()
    assert {key: value.shape for key, value in ours.items()} == {key: value.shape for key, value in published.items()}


@pytest.mark.parametrize(("height", "width"), [(64, 96), (33, 65), (1, 1), (95, 31)])
def test_the_feature_map_is_a_32nd_of_the_image_rounded_up(network, height, width):
    with torch.inference_mode():
        (maps,) = respond(network, torch.zeros(2, 3, height, width), ("head",))
    assert maps.shape == (2, 1280, -(-height // 32), -(-width // 32))
    assert maps.min() >= 0 and maps.max() <= 6


@pytest.mark.parametrize("size", range(7, 13))
@pytest.mark.parametrize(("kernel", "stride"), [(1, 1), (3, 1), (5, 1), (3, 2), (5, 2)])
def test_padding_is_tensorflows_same(size, kernel, stride):
    """As TensorFlow defines it: ceil(size / stride) outputs, the odd pixel of padding after the image."""
    convolution = _SameConv2d(1, 1, kernel, stride)
    image = torch.rand(1, 1, size, size + 1)
    padding = []
    for side in (size + 1, size):  # the last dimension comes first in pad
        total = max((-(-side // stride) - 1) * stride + kernel - side, 0)
        padding += [total // 2, total - total // 2]
    expected = functional.conv2d(functional.pad(image, padding), convolution.weight, stride=stride)
    with torch.inference_mode():
        found = convolution(image)
    assert found.shape == (1, 1, -(-size // stride), -(-(size + 1) // stride))
    assert torch.allclose(found, expected, atol=1e-6)


@pytest.mark.parametrize(("photograph", "label"), [("china.jpg", 698), ("flower.jpg", 985)], ids=["palace", "daisy"])
def test_it_sees_in_photographs_what_is_there(network, photograph, label):
    image = load_sample_image(photograph)  # 427 × 640
    square = cv2.resize(image[:, 106:533], (224, 224), interpolation=cv2.INTER_AREA) / 255
    batch = torch.from_numpy(((square - MEAN) / STD).transpose(2, 0, 1)[None]).float()
    with torch.inference_mode():
        assert network(batch)[0].argmax() == label
