import warnings

import numpy as np
import pytest

from vpr_baselines.twostage.method import TwoStage
from vpr_bench.dataset.card import Card
from vpr_bench.dataset.load import load_traverse
from vpr_bench.method.interfaces import Method, Persistent, Weighted
from vpr_bench.timing import collect_stages
from vpr_bench.types.traverse import Traverse

SMALL = {"width": 96, "height": 64}


@pytest.fixture(scope="module")
def walks(tiny_card: Card, tiny_images):
    return {one.name: load_traverse(tiny_card, one, tiny_images).traverse for one in tiny_card.traverses}


def fit(references, **parameters):
    method = TwoStage(**SMALL, **parameters)
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # of solvers that do not converge, above all
        method.fit(references)
    return method


@pytest.fixture(scope="module")
def fitted(walks):
    """Fitted on 12 places in 4 clusters."""
    return fit(walks["day_left"], n_clusters=4)


def answers(method, walk, k=5):
    matches = [method.match(image, k) for image in walk]
    return [match.indices.tolist() for match in matches], [match.scores.tolist() for match in matches]


def with_triggers(method, n_components, answers_per_component=3):
    """Return the same fitted map, triggered otherwise."""
    other = TwoStage(**SMALL, n_components=n_components, answers_per_component=answers_per_component)
    vars(other).update({name: value for name, value in vars(method).items() if name.endswith("_")})
    return other


def test_it_can_do_what_the_harness_looks_for(fitted):
    assert isinstance(fitted, Method) and isinstance(fitted, Persistent) and isinstance(fitted, Weighted)


def test_it_recognises_places_again_and_mostly_from_beside(fitted, walks):
    indices, _ = answers(fitted, walks["day_left"], k=1)
    assert indices == [[place] for place in range(12)]
    indices, _ = answers(fitted, walks["day_right"], k=1)
    assert sum(found == [place] for place, found in enumerate(indices)) >= 8  # by chance, 1


def test_a_reference_is_found_with_full_similarity(fitted, walks):
    _, scores = answers(fitted, walks["day_left"], k=2)
    assert [best for best, _ in scores] == pytest.approx([1] * 12, abs=1e-4)
    assert max(second for _, second in scores) < 0.9


def test_answers_are_unique_references_and_at_most_k(fitted, walks):
    for k in (1, 5, 100):
        for indices in answers(fitted, walks["day_right"], k)[0]:
            assert len(set(indices)) == len(indices) <= k
            assert set(indices) <= set(range(12))
    assert len(fitted.match(walks["day_right"][0], 1)) == 1


def test_the_triggered_components_bound_the_answers(fitted, walks):
    image = walks["day_right"][6]
    clusters = fitted.components_.clusters
    one = with_triggers(fitted, 1, 2).match(image, 100).indices
    assert len(one) == 2 and len(set(clusters.labels[one])) == 1
    two = with_triggers(fitted, 2, 1).match(image, 100).indices
    assert len(two) == 2 and len(set(clusters.labels[two])) == 2


def test_more_components_than_clusters_trigger_all(fitted, walks):
    everything = with_triggers(fitted, 99, 99).match(walks["day_right"][0], 100).indices
    assert sorted(everything.tolist()) == list(range(12))


def test_the_score_is_the_cosine_to_the_stored_descriptor(fitted, walks):
    match = with_triggers(fitted, 99, 99).match(walks["day_left"][3], 12)
    expected = fitted.database_ @ fitted.database_[3]
    assert match.scores == pytest.approx(expected[match.indices], abs=1e-4)
    assert np.linalg.norm(fitted.database_, axis=1) == pytest.approx([1] * 12, abs=1e-5)


def test_what_is_saved_answers_as_before(fitted, walks, tmp_path):
    fitted.save(tmp_path)
    loaded = TwoStage(**SMALL, n_clusters=4).load(tmp_path)
    assert np.array_equal(loaded.components_.head.weight, fitted.components_.head.weight)
    assert answers(loaded, walks["night_right"]) == answers(fitted, walks["night_right"])


def test_the_same_seed_gives_the_same_map_and_another_one_another(fitted, walks):
    again, other = (fit(walks["day_left"], n_clusters=4, seed=seed) for seed in (0, 1))
    assert answers(again, walks["night_right"]) == answers(fitted, walks["night_right"])
    assert np.array_equal(again.stage_one_.weight, fitted.stage_one_.weight)
    assert not np.array_equal(other.stage_one_.weight, fitted.stage_one_.weight)


def test_fitting_again_forgets_the_former_map(walks):
    part = walks["day_left"][:4]
    method = fit(walks["day_right"][5:], n_clusters=2)
    method.fit(part)
    fresh = TwoStage(**SMALL, n_clusters=2)
    fresh.fit(part)
    assert answers(method, walks["day_left"]) == answers(fresh, walks["day_left"])


def test_a_cluster_holds_a_dozen_references_unless_told_otherwise(walks):
    twice = Traverse("twice", [*walks["day_left"], *walks["day_left"]])
    assert len(fit(twice).components_.clusters) == round(len(twice) / 12) == 2
    assert len(fit(twice, n_clusters=5).components_.clusters) == 5


def test_clusters_are_asked_for_in_one_way():
    with pytest.raises(ValueError, match="not both"):
        TwoStage(n_clusters=3, similarity=0.5)


def test_clusters_follow_from_the_similarity(walks):
    assert len(fit(walks["day_left"][:4], similarity=-1).components_.clusters) == 1
    assert len(fit(walks["day_left"][:4], similarity=1).components_.clusters) == 4


def test_its_stages_are_encode_match_and_rerank(fitted, walks):
    with collect_stages() as seconds:
        fitted.match(walks["day_left"][0], 1)
    assert list(seconds) == ["encode", "match", "rerank"]


def test_a_map_of_one_image_answers_with_it(walks):
    method = fit(walks["day_left"][:1])
    for image in (walks["day_left"][0], walks["night_right"][5]):
        match = method.match(image, 3)
        assert match.indices.tolist() == [0] and np.isfinite(match.scores).all()


@pytest.mark.parametrize("level", [None, 0, 255], ids=["texture", "black", "white"])
@pytest.mark.parametrize("n_clusters", [None, 2])
def test_a_map_of_identical_images_answers_all_the_same(walks, level, n_clusters):
    image = walks["day_left"][0] if level is None else np.full((48, 64, 3), level, np.uint8)
    method = fit(Traverse("still", [image] * 4), n_clusters=n_clusters)
    match = method.match(walks["day_left"][1], 3)
    assert len(set(match.indices.tolist())) == 3 and np.isfinite(match.scores).all()


def test_images_of_different_sizes_are_one_map(walks):
    images = [walks["day_left"][0], walks["day_left"][1][:31, :17], walks["day_left"][2].repeat(3, axis=0)]
    method = fit(Traverse("mixed", images))
    assert method.match(walks["day_left"][2].repeat(3, axis=0), 1).indices.tolist() == [2]


def test_the_weights_are_named(fitted):
    assert fitted.weights_digest().startswith("efficientnet-lite0 (ImageNet) sha256:57934424")
