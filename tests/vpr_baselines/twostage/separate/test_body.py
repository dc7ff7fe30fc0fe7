import numpy as np
import pytest
import torch

from vpr_baselines.backbones.architectures import ARCHITECTURES
from vpr_baselines.twostage.separate.body import SIDE, load_body

IMAGE = np.random.default_rng(0).integers(0, 256, (70, 90, 3), dtype=np.uint8)


@pytest.mark.parametrize(("backbone", "dimensions"), [("resnet18", 512), ("efficientnet-lite0", 1280)])
def test_it_answers_one_vector_for_each_image(backbone, dimensions):
    body = load_body(backbone, "random", width=64, height=64)
    responses = body.respond([IMAGE, IMAGE[::-1]])
    assert responses.shape == (2, dimensions) and responses.dtype == np.float32
    assert not np.allclose(responses[0], responses[1])


def test_the_input_is_the_thesis_s():
    trunk = load_body("resnet18", "random").trunk
    image = np.full((10, 20, 3), 128, np.uint8)
    inputs = trunk.input(image)
    assert inputs.shape == (1, 3, SIDE, SIDE) == (1, 3, 227, 227)
    expected = (128 / 255 - np.array([0.485, 0.456, 0.406])) / [0.229, 0.224, 0.225]
    assert inputs[0, :, 5, 5].numpy() == pytest.approx(expected, abs=1e-5)


def test_alexnet_keeps_all_but_its_last_layer(monkeypatch):
    class Small(torch.nn.Module):
        def layers(self):
            yield "fc7", lambda x: x.mean(dim=(2, 3))

    asked = []
    monkeypatch.setattr(
        "vpr_baselines.backbones.trunk.load_network", lambda architecture, *_: asked.append(architecture) or Small()
    )
    body = load_body("alexnet", "random", width=65, height=65)
    assert body.respond([IMAGE]).shape == (1, 3)
    assert asked[0].head == "classifier.6" and asked[0] is not ARCHITECTURES["alexnet"]


def test_with_gradients_it_answers_the_same(body):
    response = body.response(torch.cat([body.trunk.input(IMAGE)] * 2))
    assert np.allclose(response[:1].numpy(), body.respond([IMAGE]), rtol=1e-4, atol=1e-4)
