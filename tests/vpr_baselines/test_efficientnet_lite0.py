import cv2
import numpy as np
import pytest

from vpr_baselines.efficientnet_lite0 import EfficientNetLite0
from vpr_bench.errors import DataError, UsageError
from vpr_bench.method.build import build_method
from vpr_bench.types.traverse import Traverse

SMALL = {"width": 96, "height": 64}


def scene(place, brightness=1.0):
    """Return a (64, 96, 3) uint8 texture that tells the place."""
    blocks = np.random.default_rng(place).integers(0, 256, (6, 9, 3), dtype=np.uint8)
    return (cv2.resize(blocks, (96, 64), interpolation=cv2.INTER_CUBIC) * brightness).astype(np.uint8)


def fitted(**parameters):
    method = EfficientNetLite0(**{**SMALL, **parameters})
    method.fit(Traverse("map", [scene(place) for place in range(6)]))
    return method


@pytest.mark.parametrize("metric", ["cosine", "euclidean", "manhattan"])
@pytest.mark.parametrize("pooling", ["gem", "average", "grid1x3", "grid2x3"])
def test_places_are_recognised_in_other_light(pooling, metric):
    method = fitted(pooling=pooling, metric=metric)
    assert [method.match(scene(place, 0.6), 1).indices[0] for place in range(6)] == list(range(6))


@pytest.mark.parametrize(
    ("pooling", "length"), [("gem", 1280), ("average", 1280), ("grid1x3", 3840), ("grid2x3", 7680)]
)
def test_the_length_follows_from_the_pooling(pooling, length):
    descriptor = EfficientNetLite0(pooling=pooling, **SMALL).respond(scene(0))
    assert descriptor.shape == (length,) and descriptor.dtype == np.float32


def test_a_result_says_which_weights_were_used():
    built = build_method("efficientnet-lite0")
    assert built.weights.startswith("efficientnet-lite0 (ImageNet) sha256:57934424")
    random = build_method("efficientnet-lite0", {"weights": "random", "seed": 3})
    assert random.weights == "efficientnet-lite0 (random, seed 3)"
    assert random.label == "efficientnet-lite0(weights=random)"


def test_random_weights_answer_by_their_seed():
    scores = [fitted(weights="random", seed=seed).match(scene(0, 0.5), 6).scores for seed in (0, 1, 0)]
    assert np.array_equal(scores[0], scores[2])
    assert not np.array_equal(scores[0], scores[1])


@pytest.mark.parametrize(
    ("parameters", "fault"),
    [
        ({"weights": "imagenett"}, "Did you mean 'imagenet'"),
        ({"pooling": "max"}, "'gem'"),
        ({"width": "16"}, "greater than or equal to 32"),
        ({"normalise": "red"}, r"'grey\+clahe'"),
    ],
    ids=str,
)
def test_parameters_that_mean_nothing_are_usage_errors(parameters, fault):
    with pytest.raises(UsageError, match=fault):
        build_method("efficientnet-lite0", parameters)


def test_weights_that_are_missing_are_told_when_it_is_made_and_before_an_image_is_opened(tmp_path):
    with pytest.raises(DataError, match=r"mine.pth are not there") as raised:
        build_method("efficientnet-lite0", {"weights": str(tmp_path / "mine.pth")})
    assert raised.value.exit_code == 3
    with pytest.raises(DataError, match=r"mine.pth are not there"):
        EfficientNetLite0(weights=str(tmp_path / "mine.pth")).fit(Traverse("map", [tmp_path / "gone.png"]))


def test_it_is_restored_as_it_was_saved(tmp_path):
    method = fitted()
    method.save(tmp_path)
    restored = EfficientNetLite0(**SMALL).load(tmp_path)
    assert repr(restored.match(scene(3, 0.5), 6)) == repr(method.match(scene(3, 0.5), 6))
