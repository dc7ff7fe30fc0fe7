import pytest
import torch

from vpr_baselines.backbones.layers import respond
from vpr_baselines.backbones.resnet18 import ResNet18

IMAGES = torch.rand(1, 3, 64, 96, generator=torch.Generator().manual_seed(0))


@pytest.fixture(scope="module")
def network():
    return ResNet18(5).eval()


def test_responses_come_in_the_order_asked_for_and_from_one_pass(network):
    with torch.inference_mode():
        last, middle, again = respond(network, IMAGES, ("layer4", "layer3", "layer4"))
        assert last.shape == (1, 512, 2, 3) and middle.shape == (1, 256, 4, 6)
        assert again is last
        assert torch.equal(network.layer4(middle), last)


def test_it_stops_after_the_last_layer_wanted(network, monkeypatch):
    monkeypatch.setattr(network.layer4, "forward", lambda x: pytest.fail("layer4 was computed"))
    with torch.inference_mode():
        (found,) = respond(network, IMAGES, ("layer2",))
    assert found.shape == (1, 128, 8, 12)


def test_a_layer_that_is_not_there_is_refused_with_those_that_are(network):
    with pytest.raises(ValueError, match=r"conv1, layer1, layer2, layer3, layer4\. Got layer5"):
        respond(network, IMAGES, ("layer5",))
