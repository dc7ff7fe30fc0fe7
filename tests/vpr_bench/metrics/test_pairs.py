import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sklearn import metrics as oracle

from vpr_bench.metrics import pairs as module
from vpr_bench.metrics.pairs import pr_auc_pairs, pr_auc_pairs_of_matches
from vpr_bench.types.ground_truth import GroundTruth

# Dyadic, so that none is lost in float32; few, so that true and false pairs tie.
LEVELS = np.array([-1.0, 0.0, 0.25, 0.5, 2.0], dtype=np.float32)


@st.composite
def _tables(draw):
    """Scores and truth of up to 8 x 8 pairs, with at least one true pair."""
    shape = draw(st.integers(1, 8)), draw(st.integers(1, 8))
    cells = shape[0] * shape[1]
    levels = draw(st.lists(st.integers(0, len(LEVELS) - 1), min_size=cells, max_size=cells))
    truth = np.array(draw(st.lists(st.booleans(), min_size=cells, max_size=cells)))
    truth[draw(st.integers(0, cells - 1))] = True
    return LEVELS[levels].reshape(shape), truth.reshape(shape)


def sparse(truth):
    return GroundTruth.from_pairs(*np.nonzero(truth), *truth.shape)


def brute_force(scores, truth):
    precision, recall, _ = oracle.precision_recall_curve(truth.ravel(), scores.ravel())
    return oracle.auc(recall, precision)


@given(_tables(), st.integers(1, 70), st.integers(1, 3))
def test_as_brute_force_over_all_pairs(table, block, threads):
    scores, truth = table
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "BLOCK_ELEMENTS", block)
        value = pr_auc_pairs(lambda rows: scores[rows], sparse(truth), "reject", threads)
    assert value == pytest.approx(brute_force(scores, truth))


@given(_tables())
def test_excluded_queries_leave_no_pairs(table):
    scores, truth = table
    keep = truth.any(axis=1)
    value = pr_auc_pairs(lambda rows: scores[rows], sparse(truth), "exclude", threads=1)
    assert value == pytest.approx(brute_force(scores[keep], truth[keep]))


@given(_tables())
def test_ranked_matches_give_the_same(table):
    scores, truth = table
    order = np.argsort(-scores, axis=1, kind="stable")
    ranked = np.take_along_axis(scores, order, axis=1)
    assert pr_auc_pairs_of_matches(order, ranked, sparse(truth), "miss") == pytest.approx(brute_force(scores, truth))


def test_continuous_scores_of_many_blocks(monkeypatch):
    generator = np.random.default_rng(0)
    truth = sparse(np.abs(np.subtract.outer(np.arange(200), np.arange(300))) <= 2)
    scores = generator.standard_normal((200, 300), dtype=np.float32)
    scores[truth.query_of_pair, truth.references] += 2
    monkeypatch.setattr(module, "BLOCK_ELEMENTS", 5000)
    dense = truth.contains(np.arange(200)[:, None], np.arange(300))
    assert pr_auc_pairs(lambda rows: scores[rows], truth) == pytest.approx(brute_force(scores, dense), rel=1e-12)


def test_perfect_and_worst():
    truth = np.eye(4, dtype=bool)
    assert pr_auc_pairs(lambda rows: np.eye(4, dtype=np.float32)[rows], sparse(truth)) == 1
    # Twelve false pairs come before the four true ones, which arrive together: 4/16, from 0, over 2.
    assert pr_auc_pairs(lambda rows: -np.eye(4, dtype=np.float32)[rows], sparse(truth)) == 1 / 8


def test_pairs_that_were_not_considered_are_never_retrieved():
    scores = np.array([[1.0, -np.inf], [-np.inf, -np.inf]], dtype=np.float32)
    truth = GroundTruth.from_lists([[0], [0, 1]], n_references=2)
    assert pr_auc_pairs(lambda rows: scores[rows], truth) == pytest.approx(1 / 3)


def test_undefined_without_a_true_pair_or_without_all_scores():
    nothing = GroundTruth.from_lists([[], []], n_references=2)
    assert np.isnan(pr_auc_pairs(lambda rows: np.zeros((2, 2), np.float32)[rows], nothing, "reject"))
    truth = GroundTruth.from_lists([[0], [1]], n_references=2)
    assert np.isnan(pr_auc_pairs_of_matches(np.array([[0, 1], [0, -1]]), np.zeros((2, 2)), truth))


@pytest.mark.parametrize("place", [(0, 0), (0, 1)])
def test_scores_that_are_no_numbers_are_refused(place):
    scores = np.zeros((2, 2), dtype=np.float32)
    scores[place] = np.nan
    with pytest.raises(ValueError, match="NaN"):
        pr_auc_pairs(lambda rows: scores[rows], GroundTruth.from_lists([[0], [1]], n_references=2))


def test_scores_of_the_wrong_shape_are_refused():
    with pytest.raises(ValueError, match=r"shape \(2, 3\)"):
        pr_auc_pairs(lambda rows: np.zeros((2, 2)), GroundTruth.from_lists([[0], [1]], n_references=3))


def test_soft_pairs_are_neither_right_nor_wrong():
    scores = np.array([[0.9, 0.8, 0.1], [0.2, 0.7, 0.6]], dtype=np.float32)
    hard = GroundTruth.from_lists([[0], [1]], 3)
    truth = hard.with_soft(GroundTruth.from_lists([[1], []], 3))
    without = np.where([[False, True, False], [False, False, False]], -np.inf, scores).astype(np.float32)
    assert pr_auc_pairs(lambda rows: scores[rows], truth) == pr_auc_pairs(lambda rows: without[rows], hard) == 1.0
    assert pr_auc_pairs(lambda rows: scores[rows], hard) < 1.0
