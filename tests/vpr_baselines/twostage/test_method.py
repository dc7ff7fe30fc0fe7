import warnings

import numpy as np
import pytest

from vpr_baselines.twostage.method import TwoStage
from vpr_bench.checkpoint import checkpoints
from vpr_bench.dataset.card import Card
from vpr_bench.dataset.load import load_traverse
from vpr_bench.errors import DataError, UsageError
from vpr_bench.method.build import build_method
from vpr_bench.method.interfaces import Augmenting, Clustering, Extendable, Method, Persistent, Weighted
from vpr_bench.shortlist import collect_shortlists
from vpr_bench.timing import collect_stages
from vpr_bench.types.traverse import Traverse

SMALL = {"width": 96, "height": 64, "dimensions": 64}


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


def with_triggers(method, n_components, answers_per_component=None):
    """Return the same fitted map, triggered otherwise."""
    other = TwoStage(**SMALL, n_components=n_components, answers_per_component=answers_per_component)
    vars(other).update({name: value for name, value in vars(method).items() if name.endswith("_")})
    return other


def test_it_can_do_what_the_harness_looks_for(fitted):
    for capability in (Method, Persistent, Weighted, Clustering, Extendable, Augmenting):
        assert isinstance(fitted, capability)


def test_it_recognises_places_again_and_mostly_from_beside(fitted, walks):
    indices, _ = answers(fitted, walks["day_left"], k=1)
    assert indices == [[place] for place in range(12)]
    indices, _ = answers(fitted, walks["day_right"], k=1)
    assert sum(found == [place] for place, found in enumerate(indices)) >= 8  # by chance, 1


def test_a_reference_is_found_with_more_confidence_than_another_walk_s_place(fitted, walks):
    again, beside = (answers(fitted, walks[name], k=1)[1] for name in ("day_left", "day_right"))
    assert 0.9 < np.mean(again) < 1
    assert np.mean(again) > np.mean(beside)


def test_answers_are_unique_references_and_at_most_k(fitted, walks):
    for k in (1, 5, 100):
        for indices in answers(fitted, walks["day_right"], k)[0]:
            assert len(set(indices)) == len(indices) <= k
            assert set(indices) <= set(range(12))
    assert len(fitted.match(walks["day_right"][0], 1)) == 1


def test_the_triggered_components_bound_the_answers(fitted, walks):
    image = walks["day_right"][6]
    clusters = fitted.system_.clusters
    one = with_triggers(fitted, 1, 2).match(image, 100).indices
    assert len(one) == 2 and len(set(clusters.labels[one])) == 1
    two = with_triggers(fitted, 2, 1).match(image, 100).indices
    assert len(two) == 2 and len(set(clusters.labels[two])) == 2


def test_more_components_than_clusters_trigger_all(fitted, walks):
    everything = with_triggers(fitted, 99, 99).match(walks["day_right"][0], 100).indices
    assert sorted(everything.tolist()) == list(range(12))


def test_candidates_are_shared_among_the_triggered_components(walks):
    twice = Traverse("thrice", [*walks["day_left"], *walks["day_right"], *walks["night_right"]])
    method = fit(twice, n_clusters=2, min_size=15)
    for triggered, expected in ((1, min(21, *method.system_.clusters.sizes)), (2, 22)):
        assert len(with_triggers(method, triggered).match(walks["day_left"][3], 100)) >= min(expected, 15)


def test_cosine_compares_descriptors_alone(walks):
    method = fit(walks["day_left"], rerank="cosine", n_components=99, answers_per_component=99)
    match = method.match(walks["day_left"][3], 12)
    originals = method.system_.description.originals
    assert np.linalg.norm(originals, axis=1) == pytest.approx([1] * 12, abs=1e-3)
    expected = originals @ originals[3]
    assert match.indices[0] == 3
    assert np.array_equal(np.argsort(-expected, kind="stable")[:3], match.indices[:3])


def test_what_was_still_in_the_running_is_told(fitted, walks):
    with collect_shortlists() as found:
        match = with_triggers(fitted, 2).match(walks["day_left"][3], 100)
    labels = fitted.system_.clusters.labels
    assert sorted(match.indices.tolist()) == sorted(found["components"].tolist())
    assert len(set(labels[found["clusters"]])) == 2 and set(found["components"]) <= set(found["clusters"])
    with collect_shortlists() as found:
        with_triggers(fitted, 99).match(walks["day_left"][3], 100)
    assert found["clusters"] is None


def test_what_is_saved_answers_as_before(fitted, walks, tmp_path):
    fitted.save(tmp_path)
    loaded = TwoStage(**SMALL, n_clusters=4).load(tmp_path)
    assert answers(loaded, walks["night_right"]) == answers(fitted, walks["night_right"])


def test_the_same_seed_gives_the_same_map_and_another_one_another(fitted, walks):
    again, other = (fit(walks["day_left"], n_clusters=4, seed=seed) for seed in (0, 1))
    assert answers(again, walks["night_right"]) == answers(fitted, walks["night_right"])
    assert np.array_equal(again.system_.stage_one.weight, fitted.system_.stage_one.weight)
    assert not np.array_equal(other.system_.stage_one.weight, fitted.system_.stage_one.weight)


def test_fitting_again_forgets_the_former_map(walks):
    part = walks["day_left"][:4]
    method = fit(walks["day_right"][5:], n_clusters=2)
    method.fit(part)
    fresh = TwoStage(**SMALL, n_clusters=2)
    fresh.fit(part)
    assert answers(method, walks["day_left"]) == answers(fresh, walks["day_left"])


def test_a_cluster_holds_eight_references_unless_told_otherwise(walks):
    twice = Traverse("twice", [*walks["day_left"], *walks["day_left"]])
    assert len(fit(twice).system_.clusters) == round(len(twice) / 8) == 3
    assert len(fit(twice, n_clusters=5).system_.clusters) == 5


@pytest.mark.parametrize(
    ("parameters", "said"),
    [
        ({"n_clusters": 3, "threshold": 0.5}, "does not use threshold"),
        ({"clustering": "leader"}, "needs threshold"),
        ({"components": "separate", "rerank": "spatial"}, "rerank='cosine' only"),
        ({"components": "separate", "layer": "block10"}, "no layer"),
        ({"finetune": True}, "needs components='separate'"),
    ],
)
def test_parameters_that_do_not_go_together_are_refused(parameters, said):
    with pytest.raises(ValueError, match=said):
        TwoStage(**parameters)


@pytest.mark.parametrize("by", ["trunk", "hog"])
def test_clusters_follow_from_the_threshold(walks, by):
    for threshold, expected in ((-1, 1), (1, 4)):
        method = fit(walks["day_left"][:4], clustering="leader", threshold=threshold, cluster_by=by)
        assert len(method.system_.clusters) == expected
        assert np.array_equal(method.cluster(walks["day_left"][:4]).labels, method.system_.clusters.labels)


def test_clusters_may_be_given_and_need_not_be_stretches(walks):
    labels = [0, 1] * 6
    method = fit(walks["day_left"], clustering="labels", labels=labels, n_components=1)
    assert method.system_.clusters.labels.tolist() == labels
    for image in walks["day_right"]:
        assert len(set(np.array(labels)[method.match(image, 12).indices])) == 1
    assert answers(method, walks["day_left"], k=1)[0] == [[place] for place in range(12)]


def test_a_map_grows_and_keeps_what_it_knew(fitted, walks, tmp_path):
    grown = with_triggers(fitted, 99)
    fitted.save(tmp_path)
    grown.load(tmp_path)
    before = grown.system_
    grown.extend(walks["night_right"])
    clusters = grown.system_.clusters
    assert len(clusters.labels) == 24 and np.array_equal(clusters.labels[:12], before.clusters.labels)
    assert np.array_equal(grown.system_.components.head.weight[:12], before.components.head.weight)
    assert len(grown.system_.stage_one.weight) == len(clusters) > len(before.clusters)
    assert answers(grown, walks["night_right"], k=1)[0] == [[place] for place in range(12, 24)]
    assert answers(grown, walks["day_left"], k=1)[0] == [[place] for place in range(12)]
    grown.save(tmp_path)
    assert answers(with_triggers(grown, 99).load(tmp_path), walks["day_right"]) == answers(grown, walks["day_right"])


def test_references_that_cannot_be_clustered_as_asked_for_are_the_user_s_to_mend(walks):
    for references, said in (
        (walks["day_left"][:3], "labels must be one per reference, 3. Got 2"),
        ([], "no references"),
    ):
        method = TwoStage(**SMALL, clustering="labels", labels=[0, 1])
        with pytest.raises(UsageError, match=said):
            method.fit(Traverse("map", list(references)))


def test_maps_that_cannot_grow_say_why(walks):
    with pytest.raises(UsageError, match="given labels"):
        fit(walks["day_left"][:2], clustering="labels", labels=[0, 1]).extend(walks["day_right"])


@pytest.mark.parametrize("stop", ["stage one", "components from", "calibration", "references from 0"])
def test_an_interrupted_fit_goes_on_and_comes_to_the_same(fitted, walks, tmp_path, monkeypatch, stop):
    from vpr_bench.checkpoint import Checkpoints

    save = Checkpoints.save

    def interrupted(self, name, arrays):
        save(self, name, arrays)
        if name.startswith(stop):
            raise KeyboardInterrupt

    monkeypatch.setattr(Checkpoints, "save", interrupted)
    method = TwoStage(**SMALL, n_clusters=4)
    with pytest.raises(KeyboardInterrupt), checkpoints(tmp_path):
        method.fit(walks["day_left"])
    monkeypatch.undo()
    with checkpoints(tmp_path) as kept:
        method.fit(walks["day_left"])
    assert kept.resumed
    assert answers(method, walks["night_right"]) == answers(fitted, walks["night_right"])


@pytest.mark.parametrize("damage", ["truncated", "gone", "other"])
def test_a_damaged_map_is_refused(fitted, walks, tmp_path, damage):
    fitted.save(tmp_path)
    file = tmp_path / "descriptors.npy"
    if damage == "truncated":
        file.write_bytes(file.read_bytes()[:-100])
    elif damage == "gone":
        file.unlink()
    else:
        np.save(file, np.zeros((3, 6, 64), np.float16))
    with pytest.raises(DataError, match="damaged; fit it again"):
        TwoStage(**SMALL).load(tmp_path)


@pytest.mark.parametrize("backbone", ["resnet18", "alexnet"])
def test_other_trunks_whole_and_cut_short(walks, backbone):
    last = {"resnet18": "layer2", "alexnet": "conv3"}[backbone]
    for layer in (None, last):
        method = fit(walks["day_left"][:4], backbone=backbone, weights="random", layer=layer, pooling="gem")
        assert [method.match(image, 1).indices[0] for image in walks["day_left"][:4]] == [0, 1, 2, 3]
    with pytest.raises(ValueError, match=f"{last}, .*Got 'layer9'"):
        TwoStage(backbone=backbone, weights="random", layer="layer9")


def test_the_thesis_s_system_has_networks_of_its_own_for_every_part(walks, tmp_path):
    small = {"weights": "random", "width": 64, "height": 64, "threshold": 0.9, "n_components": 2}
    method = build_method("twostage:thesis", small).method
    method.fit(walks["day_left"])
    passes = []
    network = method.system_.networks.body.trunk.network
    stem = network.conv1.register_forward_pre_hook(lambda *_: passes.append(1))
    match = method.match(walks["day_left"][5], 12)
    stem.remove()
    assert len(passes) == 3 and len(match) <= 6
    assert [method.match(image, 1).indices[0] for image in walks["day_left"]] == list(range(12))
    method.save(tmp_path)
    loaded = build_method("twostage:thesis", small).method.load(tmp_path)
    assert answers(loaded, walks["night_right"]) == answers(method, walks["night_right"])
    with pytest.raises(NotImplementedError, match="cannot be extended"):
        method.extend(walks["day_right"])


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
