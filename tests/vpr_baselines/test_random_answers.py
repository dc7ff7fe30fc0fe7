import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_baselines.random_answers import Random
from vpr_bench.method.build import build_method
from vpr_bench.types.traverse import Traverse

IMAGES = [np.random.default_rng(i).integers(0, 256, (6, 8, 3), dtype=np.uint8) for i in range(60)]


def fit(seed=0, images=IMAGES):
    method = Random(seed)
    method.fit(Traverse("map", images))
    return method


def test_the_same_image_gets_the_same_answer_whatever_was_asked_before():
    first, second = fit(), fit()
    second.match(IMAGES[3], 5)
    assert first.match(IMAGES[7], 60).indices.tolist() == second.match(IMAGES[7], 60).indices.tolist()


def test_other_seeds_and_other_images_get_other_answers():
    answers = {tuple(fit(seed).match(IMAGES[i], 10).indices) for seed in (0, 1) for i in (0, 1)}
    assert len(answers) == 4


@given(st.permutations(range(60)))
def test_the_order_of_the_references_does_not_count(order):
    shuffled = fit(images=[IMAGES[i] for i in order])
    expected = fit().match(IMAGES[0], 60).indices
    assert [order[i] for i in shuffled.match(IMAGES[0], 60).indices] == expected.tolist()


def test_scores_are_uniform_and_every_reference_is_answered():
    method = fit()
    scores = np.concatenate([method.scores(image) for image in IMAGES])
    assert scores.min() >= 0 and scores.max() < 1
    assert np.histogram(scores, 10, (0, 1))[0] == pytest.approx(np.full(10, 360), abs=75)  # four deviations
    best = {int(method.match(image, 1).indices[0]) for image in IMAGES}
    assert len(best) > 25  # of about 38 expected


def test_what_is_saved_answers_as_before(tmp_path):
    fit().save(tmp_path)
    assert np.array_equal(Random().load(tmp_path).scores(IMAGES[5]), fit().scores(IMAGES[5]))


def test_the_seed_of_the_run_is_its_seed():
    assert build_method("random", seed=4).method.seed == 4
