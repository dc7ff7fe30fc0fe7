from dataclasses import dataclass

import numpy as np
import pytest

from vpr_baselines.centred import Centred
from vpr_bench.types.traverse import Traverse


@dataclass
class Thumbnail(Centred):
    """The image itself, as numbers."""

    centre: bool = True

    def respond(self, image):
        return image.astype(np.float32).ravel()


@pytest.fixture
def images():
    return list(np.random.default_rng(0).integers(100, 140, (6, 4, 5, 3), dtype=np.uint8))


def fitted(images, **parameters):
    method = Thumbnail(**parameters)
    method.fit(Traverse("map", images))
    return method


@pytest.mark.parametrize("metric", ["cosine", "euclidean", "manhattan"])
@pytest.mark.parametrize("centre", [True, False])
def test_scores_are_those_of_the_definition(images, centre, metric):
    vectors = np.stack(images).reshape(6, -1).astype(float)
    query = vectors[2] + 5 * vectors[4]
    shift = vectors.mean(axis=0) if centre else 0
    if metric == "cosine":
        a, b = vectors - shift, query - shift
        expected = a @ b / np.linalg.norm(a, axis=1) / np.linalg.norm(b)
    else:
        expected = -np.linalg.norm(vectors - query, axis=1, ord=1 if metric == "manhattan" else 2)
    method = fitted(images, centre=centre, metric=metric)
    method.respond = lambda image: query.astype(np.float32)
    match = method.match(images[0], 6)
    assert np.array_equal(match.indices, np.argsort(-expected, kind="stable"))
    assert match.scores == pytest.approx(expected[match.indices], rel=1e-4)


def test_what_all_references_share_is_taken_away(images):
    plain, centred = (fitted(images, centre=centre).match(images[3], 6).scores for centre in (False, True))
    assert plain.min() > 0.9  # nearly grey images are all alike
    assert centred[0] == pytest.approx(1) and centred[1] < 0.5


def test_the_order_of_the_references_does_not_matter(images):
    order = np.random.default_rng(1).permutation(6)
    one, other = fitted(images), fitted([images[index] for index in order])
    for image in images:
        first, second = one.match(image, 6), other.match(image, 6)
        assert np.array_equal(first.indices, order[second.indices])
        assert first.scores == pytest.approx(second.scores, abs=1e-6)


def test_it_is_restored_as_it_was_saved(images, tmp_path):
    method = fitted(images)
    method.save(tmp_path)
    restored = Thumbnail().load(tmp_path)
    for image in images:
        assert repr(restored.match(image, 6)) == repr(method.match(image, 6))


def test_a_map_of_one_is_like_everything(images):
    match = fitted(images[:1]).match(images[1], 3)
    assert match.indices.tolist() == [0] and np.isfinite(match.scores).all()


def test_fitting_again_forgets(images):
    method = fitted(images)
    method.fit(Traverse("map", images[:2]))
    assert repr(method.match(images[5], 6)) == repr(fitted(images[:2]).match(images[5], 6))
