import numpy as np
import pytest
from sklearn.linear_model import LogisticRegression

from vpr_baselines.retrieval import normalised
from vpr_baselines.twostage.heads import LinearHead, train_head


def scattered(classes, per_class=8, dimensions=6):
    """Noisy unit vectors around one direction per class, that overlap a little."""
    chance = np.random.default_rng(classes)
    centres = chance.standard_normal((classes, dimensions))
    labels = np.repeat(np.arange(classes), per_class)
    return normalised(
        (centres[labels] + 0.7 * chance.standard_normal((len(labels), dimensions))).astype(np.float32)
    ), labels


@pytest.mark.parametrize("classes", [2, 3, 12])
def test_it_predicts_what_scikit_learn_does(classes):
    descriptors, labels = scattered(classes)
    head = train_head(descriptors, labels, classes, penalty=10.0)
    oracle = LogisticRegression(C=10.0, max_iter=300).fit(descriptors, labels)
    queries, _ = scattered(classes, per_class=50)
    logits = np.stack([head.logits(query) for query in queries])
    assert logits.shape == (len(queries), classes)
    assert np.array_equal(logits.argmax(axis=1), oracle.predict(queries))
    assert np.allclose(
        np.exp(logits) / np.exp(logits).sum(axis=1, keepdims=True), oracle.predict_proba(queries), atol=1e-4
    )


@pytest.mark.parametrize("classes", [1, 2, 5])
def test_it_has_one_row_of_float32_for_each_class(classes):
    head = train_head(*scattered(classes), classes, penalty=10.0)
    assert head.weight.shape == (classes, 6) and head.bias.shape == (classes,)
    assert head.weight.dtype == head.bias.dtype == np.float32


def test_with_one_class_there_is_nothing_to_learn():
    head = train_head(*scattered(1), 1, penalty=10.0)
    assert head.logits(np.ones(6, np.float32)).tolist() == [0]


def test_a_weaker_penalty_follows_the_training_set_more_closely():
    descriptors, labels = scattered(4)
    margins = []
    for penalty in (0.01, 1.0, 100.0):
        head = train_head(descriptors, labels, 4, penalty)
        logits = descriptors @ head.weight.T + head.bias
        margins.append(logits[np.arange(len(labels)), labels].mean() - logits.mean())
    assert margins == sorted(margins) and margins[0] < margins[-1]


def test_identical_descriptors_of_different_classes_are_no_error():
    head = train_head(np.zeros((6, 4), np.float32), np.array([0, 1, 2] * 2), 3, penalty=10.0)
    assert head.logits(np.ones(4, np.float32)) == pytest.approx([0, 0, 0], abs=1e-3)


def test_logits_are_weight_times_descriptor_plus_bias():
    head = LinearHead(np.array([[1, 2], [3, 4]], np.float32), np.array([10, 20], np.float32))
    assert head.logits(np.array([1, -1], np.float32)).tolist() == [9, 19]
