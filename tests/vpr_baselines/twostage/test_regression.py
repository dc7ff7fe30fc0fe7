import numpy as np
import pytest
from sklearn.linear_model import LogisticRegression

from vpr_baselines.retrieval import normalised
from vpr_baselines.twostage import regression
from vpr_baselines.twostage.regression import Samples, balanced, train_head


def scattered(classes, counts=8, dimensions=6):
    """Noisy unit vectors around one direction per class, that overlap a little."""
    chance = np.random.default_rng(classes)
    centres = chance.standard_normal((classes, dimensions))
    labels = np.repeat(np.arange(classes), counts)
    noise = 0.7 * chance.standard_normal((len(labels), dimensions))
    return normalised((centres[labels] + noise).astype(np.float32)), labels


def samples(descriptors, labels):
    return Samples(descriptors, np.arange(len(labels)), labels)


def probabilities(head, descriptors):
    exponentials = np.exp(head.logits(descriptors))
    return exponentials / exponentials.sum(axis=1, keepdims=True)


@pytest.mark.parametrize(("classes", "counts"), [(3, 8), (12, 8), (4, [1, 3, 20, 9])])
def test_it_predicts_what_scikit_learn_does_with_balanced_classes(classes, counts):
    descriptors, labels = scattered(classes, counts)
    head, _, stopped = train_head(samples(descriptors, labels), classes, penalty=10.0)
    oracle = LogisticRegression(C=10.0, max_iter=1000, tol=1e-6, class_weight="balanced").fit(descriptors, labels)
    queries, _ = scattered(classes, counts=50)
    assert stopped == "converged"
    assert np.allclose(probabilities(head, queries), oracle.predict_proba(queries), atol=2e-3)


def test_two_classes_are_two_rows():
    """Scikit-learn learns the difference of both rows, whose penalty is half of theirs."""
    descriptors, labels = scattered(2)
    head, _, _ = train_head(samples(descriptors, labels), 2, penalty=10.0)
    oracle = LogisticRegression(C=20.0, max_iter=1000, tol=1e-6).fit(descriptors, labels)
    assert np.allclose(probabilities(head, descriptors), oracle.predict_proba(descriptors), atol=2e-3)


@pytest.mark.parametrize("classes", [1, 2, 5])
def test_it_has_one_row_of_float32_for_each_class(classes):
    head, _, _ = train_head(samples(*scattered(classes)), classes, penalty=10.0)
    assert head.weight.shape == (classes, 6) and head.bias.shape == (classes,)
    assert head.weight.dtype == head.bias.dtype == np.float32


def test_with_one_class_there_is_nothing_to_learn():
    head, rounds, stopped = train_head(samples(*scattered(1)), 1, penalty=10.0)
    assert head.logits(np.ones(6, np.float32)).tolist() == [0]
    assert rounds == 0 and stopped == "nothing to learn"


def test_a_weaker_penalty_follows_the_training_set_more_closely():
    descriptors, labels = scattered(4)
    margins = []
    for penalty in (0.01, 1.0, 100.0):
        logits = train_head(samples(descriptors, labels), 4, penalty)[0].logits(descriptors)
        margins.append(logits[np.arange(len(labels)), labels].mean() - logits.mean())
    assert margins == sorted(margins) and margins[0] < margins[-1]


def test_identical_descriptors_of_different_classes_are_no_error():
    head, _, _ = train_head(samples(np.full((6, 4), 0.5, np.float32), np.array([0, 1, 2] * 2)), 3, penalty=10.0)
    assert head.logits(np.ones(4, np.float32)) == pytest.approx([0, 0, 0], abs=1e-3)


def test_all_classes_weigh_the_same_and_all_samples_as_many_as_there_are():
    labels = np.array([0, 0, 0, 2, 2, 3])
    weights = balanced(labels, 4)
    assert weights[labels].sum() == pytest.approx(6 * 3 / 4)  # no sample carries the weight of class 1
    assert weights.tolist() == [0.5, 0.0, 0.75, 1.5]


def test_samples_are_rows_of_a_matrix_that_may_lie_on_disk(tmp_path):
    descriptors, labels = scattered(3)
    stored = np.lib.format.open_memmap(tmp_path / "half.npy", "w+", np.float16, (30, 6))
    rows = np.random.default_rng(0).permutation(30)[: len(labels)]
    stored[rows] = descriptors
    found, _, _ = train_head(Samples(stored, rows, labels), 3, penalty=10.0)
    expected, _, _ = train_head(samples(descriptors, labels), 3, penalty=10.0)
    assert np.allclose(found.weight, expected.weight, atol=0.05)


def test_many_samples_are_read_in_batches(monkeypatch):
    expected, _, _ = train_head(samples(*scattered(5)), 5, penalty=10.0)
    monkeypatch.setattr(regression, "_BATCH", 6 * 7)
    found, _, _ = train_head(samples(*scattered(5)), 5, penalty=10.0, validation=samples(*scattered(5, counts=3)))
    assert np.allclose(found.weight, expected.weight, atol=0.5)
    without, _, _ = train_head(samples(*scattered(5)), 5, penalty=10.0)
    assert np.allclose(without.weight, expected.weight, atol=1e-2)


def test_training_stops_early_where_the_samples_held_back_say_the_contrary():
    descriptors, labels = scattered(4)
    head, rounds, stopped = train_head(
        samples(descriptors, labels), 4, 1e4, validation=samples(descriptors, (labels + 1) % 4)
    )
    assert stopped == "validation" and rounds < 10
    assert np.isfinite(head.weight).all()
