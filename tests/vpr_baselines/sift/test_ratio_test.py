import cv2
import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from vpr_baselines.sift import products
from vpr_baselines.sift.keypoints import KeyPoints, root_sift
from vpr_baselines.sift.ratio_test import KeyPointMap


@pytest.fixture(params=[torch.float32, torch.bfloat16], ids=str)
def kind(request, monkeypatch):
    """Multiply in this type, whichever is the faster one here."""
    monkeypatch.setattr(products, "fastest_type", lambda: request.param)


def key_points(generator, count, palette):
    """Return key points that resemble those of a palette, more or less."""
    noise = generator.integers(-60, 61, (count, 128)) * generator.random((count, 1))
    descriptors = palette[generator.integers(0, len(palette), count)] + noise
    return KeyPoints(generator.random((count, 2), dtype=np.float32), descriptors.clip(0, 255).astype(np.uint8))


def make(seed, counts, n_features):
    """Return a filled map, its key points, and those of a query."""
    generator = np.random.default_rng(seed)
    palette = generator.integers(0, 256, (40, 128)) * (generator.random((40, 128)) < 0.4)
    references = [key_points(generator, count, palette) for count in counts]
    made = KeyPointMap(len(counts), n_features)
    for image, points in enumerate(references):
        made.put(image, points)
    return made, references, key_points(generator, 50, palette)


def brute_force(query, reference, ratio):
    """Return which key points match which by OpenCV, with the similarities of those that do."""
    left, right = root_sift(query.descriptors), root_sift(reference.descriptors)
    # At its own length a vector is as far from another as their product says.
    left, right = (one / np.maximum(np.linalg.norm(one, axis=1, keepdims=True), 1e-9) for one in (left, right))
    found = cv2.BFMatcher(cv2.NORM_L2).knnMatch(left, right, 2)
    good = [pair[0] for pair in found if len(pair) == 2 and pair[0].distance < ratio * pair[1].distance]
    return {(one.queryIdx, one.trainIdx) for one in good}


@pytest.mark.parametrize("ratio", [0.6, 0.8, 0.95])
def test_the_pairs_are_those_of_opencvs_brute_force(kind, ratio):
    made, references, query = make(0, counts=[60, 35, 2, 60, 1, 0, 47, 60], n_features=60)
    found = made.best(query, ratio, k=8)
    total = 0
    for image, reference in enumerate(references):
        expected = brute_force(query, reference, ratio) if len(reference.positions) > 1 else set()
        pairs = found.get(image)
        ours = set() if pairs is None else set(zip(pairs.query.tolist(), pairs.reference.tolist(), strict=True))
        assert len(ours ^ expected) <= 0.02 * len(expected) + 1  # lengths are 1 but for the rounding
        total += len(expected)
    assert total > 30


@settings(max_examples=25)
@given(st.integers(0, 99), st.lists(st.integers(0, 33), min_size=1, max_size=40), st.floats(0.3, 1))
def test_nothing_that_passes_is_thrown_away_by_the_rough_products(seed, counts, ratio):
    made, _, query = make(seed, counts, n_features=33)
    descriptors = root_sift(query.descriptors)
    everything = np.arange(len(descriptors))
    rough = made._products.may_pass(descriptors, ratio)
    for image, count in enumerate(counts):
        if count > 1:
            exact = made._pairs(image, descriptors, everything, ratio)
            assert rough[image, exact.query].all()


@settings(max_examples=25)
@given(st.integers(0, 99), st.integers(1, 40))
def test_the_best_are_those_of_looking_at_all(seed, k):
    made, _, query = make(seed, [30] * 40, n_features=30)
    everything, best = (made.best(query, 0.9, count) for count in (40, k))
    ranked = sorted(everything, key=lambda image: (-everything[image].score, image))
    assert sorted(best, key=lambda image: (-best[image].score, image))[:k] == ranked[:k]
    assert all(best[image].score == everything[image].score for image in best)


def test_both_types_give_the_same_answer(monkeypatch):
    answers = []
    for one in (torch.float32, torch.bfloat16):
        monkeypatch.setattr(products, "fastest_type", lambda one=one: one)
        made, _, query = make(3, [50] * 30, n_features=50)
        answers.append({image: pairs.score for image, pairs in made.best(query, 0.8, 30).items()})
    assert answers[0] == answers[1]


def test_the_same_key_point_twice_in_a_reference_is_no_match():
    made, references, _ = make(0, [10], n_features=20)
    twice = KeyPoints(*(np.concatenate([part] * 2) for part in vars(references[0]).values()))
    made.put(0, twice)
    assert made.best(references[0], 0.9, 1) == {}


def test_an_identical_image_matches_with_all_its_key_points(kind):
    made, references, _ = make(0, [40, 40], n_features=40)
    assert made.best(references[1], 0.99, 1)[1].score >= 39


def test_it_survives_the_disk(kind, tmp_path):
    made, _, query = make(0, [20, 0, 30], n_features=30)
    made.save(tmp_path)
    loaded = KeyPointMap.load(tmp_path)
    before, after = made.best(query, 0.9, 3), loaded.best(query, 0.9, 3)
    assert {image: pairs.score for image, pairs in before.items()} == {
        image: pairs.score for image, pairs in after.items()
    }
    assert np.array_equal(loaded.positions(2), made.positions(2))


def test_the_faster_type_is_one_of_the_two():
    assert products.fastest_type() in products._ERROR


def test_torch_has_as_many_threads_afterwards_as_before():
    made, _, query = make(0, [20], n_features=20)
    before = torch.get_num_threads()
    torch.set_num_threads(2)
    try:
        made.best(query, 0.8, 1)
        assert torch.get_num_threads() == 2
    finally:
        torch.set_num_threads(before)
