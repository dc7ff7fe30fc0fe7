import numpy as np
import pytest

from vpr_baselines.alexnet import AlexNet
from vpr_bench.errors import DataError
from vpr_bench.method.build import build_method
from vpr_bench.types.traverse import Traverse

IMAGES = list(np.random.default_rng(0).integers(0, 256, (4, 40, 50, 3), dtype=np.uint8))


@pytest.mark.parametrize(
    ("parameters", "length"),
    [({}, 64_896), ({"dimensions": 16}, 16), ({"layer": "fc7"}, 4096), ({"width": 63, "height": 63}, 3 * 3 * 384)],
    ids=str,
)
def test_the_length_follows_from_layer_size_and_projection(parameters, length):
    response = AlexNet(weights="random", **parameters).respond(IMAGES[0])
    assert response.shape == (length,) and response.dtype == np.float32
    assert np.isfinite(response).all() and response.std() > 0


@pytest.mark.parametrize("metric", ["cosine", "manhattan"])
@pytest.mark.parametrize("parameters", [{}, {"layer": "fc7"}, {"dimensions": 64}, {"centre": True}], ids=str)
def test_images_are_told_apart(parameters, metric):
    method = AlexNet(weights="random", width=100, height=80, metric=metric, **parameters)
    method.fit(Traverse("map", IMAGES))
    assert [method.match(image, 1).indices[0] for image in IMAGES] == [0, 1, 2, 3]


def test_the_projection_is_of_the_response_and_of_the_seed():
    whole = AlexNet(weights="random").respond(IMAGES[0])
    projected = AlexNet(weights="random", dimensions=400).respond(IMAGES[0])
    assert np.linalg.norm(projected) == pytest.approx(np.linalg.norm(whole), rel=0.15)


def test_missing_weights_say_how_to_get_them_and_where_to_put_them(tmp_path, monkeypatch):
    monkeypatch.setenv("VPR_BENCH_WEIGHTS", str(tmp_path))
    for layer in ("conv3", "fc7"):
        with pytest.raises(DataError, match=rf"`vpr-bench weights fetch alexnet-imagenet`,\n.* into {tmp_path}"):
            build_method("alexnet", {"layer": layer})
    with pytest.raises(DataError, match="weights fetch alexnet-imagenet"):
        AlexNet().fit(Traverse("map", [tmp_path / "gone.png"]))


def test_random_weights_stand_in_the_result():
    assert build_method("alexnet", {"weights": "random", "seed": 2}).weights == "alexnet (random, seed 2)"
