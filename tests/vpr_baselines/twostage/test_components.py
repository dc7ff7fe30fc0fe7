import numpy as np
import pytest

from vpr_baselines.twostage.clusters import Clusters
from vpr_baselines.twostage.components import Components, train_components
from vpr_baselines.twostage.heads import LinearHead

CLUSTERS = Clusters(np.array([0, 4, 5, 10]))


@pytest.fixture
def components():
    """Every reference answers to a direction of its own, by as much as its number says."""
    return Components(CLUSTERS, LinearHead(np.eye(10, dtype=np.float32), np.zeros(10, np.float32)))


@pytest.fixture(scope="module")
def trained():
    """Components trained on two noisy descriptors of each of 10 references."""
    chance = np.random.default_rng(0)
    references = np.repeat(np.arange(10), 2)
    descriptors = np.eye(10)[references] + 0.05 * chance.standard_normal((20, 10))
    order = chance.permutation(20)
    return train_components(CLUSTERS, descriptors[order].astype(np.float32), references[order], penalty=10.0)


def test_each_triggered_component_names_its_best(components):
    descriptor = np.array([0.1, 0.9, 0.5, 0.2, 0.0, 0.3, 0.1, 0.2, 0.9, 0.8], np.float32)
    assert components.answer(descriptor, np.array([2, 0]), best=2).tolist() == [8, 9, 1, 2]
    assert components.answer(descriptor, np.array([0]), best=1).tolist() == [1]


def test_the_bias_belongs_to_the_reference(components):
    biased = Components(CLUSTERS, LinearHead(components.head.weight, np.arange(10, dtype=np.float32)))
    assert biased.answer(np.zeros(10, np.float32), np.array([0, 2]), best=2).tolist() == [3, 2, 9, 8]


def test_a_small_cluster_gives_all_it_has(components):
    answers = components.answer(np.zeros(10, np.float32), np.array([1, 0]), best=3)
    assert answers.tolist() == [4, 0, 1, 2]


def test_answers_are_unique_and_inside_the_triggered_clusters(trained):
    answers = trained.answer(np.ones(10, np.float32), np.array([2, 1, 0]), best=99)
    assert sorted(answers.tolist()) == list(range(10))
    assert set(trained.answer(np.ones(10, np.float32), np.array([2]), best=3).tolist()) <= set(range(5, 10))


@pytest.mark.parametrize("reference", range(10))
def test_trained_components_recognise_their_own_references(trained, reference):
    cluster = CLUSTERS.labels[reference]
    descriptor = np.eye(10, dtype=np.float32)[reference]
    assert trained.answer(descriptor, np.array([cluster]), best=1).tolist() == [reference]


def test_a_component_knows_only_its_own_cluster():
    """What is learnt about one cluster does not depend on the others."""
    chance = np.random.default_rng(0)
    references = np.repeat(np.arange(10), 2)
    descriptors = chance.standard_normal((20, 6)).astype(np.float32)
    changed = descriptors.copy()
    changed[references >= 5] *= -1
    heads = [train_components(CLUSTERS, one, references, 10.0).head for one in (descriptors, changed)]
    assert np.array_equal(heads[0].weight[:5], heads[1].weight[:5])
    assert not np.allclose(heads[0].weight[5:], heads[1].weight[5:])
